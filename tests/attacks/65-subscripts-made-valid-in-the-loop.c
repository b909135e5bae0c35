// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The subscripts that the inspector reads may come from an array that the loop updates. Before the
// loop the array's values are invalid subscripts, far outside the program's memory; iterations make
// them valid before others use them. For comparison the same loops run in parallel on disjoint arrays.
// METHODS: auto localwrite localwrite-direct localwrite-steal graph-localwrite wavefront
#include <stdio.h>
#include <stdlib.h>

enum { N = 20000, FEW = 2000, FAR = 1000000000 };

/* The plan's key contains lim[idx[0]], which each iteration may change. */
static __attribute__((noinline)) void keyed(int n, const int *s, const int *by, int *h,
                                            const int *idx, const int *lim, double *g) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse
        h[s[i]] += by[i];
        g[lim[idx[0]] + s[i]] += 1;
    }
}

/* The iteration that reads the subscript makes it valid. */
static __attribute__((noinline)) void touched(int n, const int *s, const int *by, int *h,
                                              const int *idx, const int *lim, double *g) {
    for (int i = 0; i < n; i++) { // EXPECT: parallel
        h[s[i]] += by[i];
        g[lim[idx[i]]] += 0.1 * i;
    }
}

/* The counters, the subscripts and the map are arrays of one type and may overlap. */
static __attribute__((noinline)) void counted(int n, int *count, const int *map, const int *k) {
    for (int i = 0; i < n; i++) // EXPECT: parallel
        count[map[k[i]]] += FAR;
}

/* The trip count of an inner loop is read from the updated array. */
static __attribute__((noinline)) void bounded(int n, int *count, const int *row,
                                              const int *column) {
    for (int i = 0; i < n; i++) // EXPECT: parallel
        for (int j = row[i]; j < row[i + 1]; j++)
            count[column[j]] += FAR;
}

/* A divisor is read from the updated array; one loop evaluates it only under a condition. */
static __attribute__((noinline)) void divided(int n, int *h, const int *s, const int *d,
                                              double *g) {
    for (int i = 0; i < n; i++) { // EXPECT: parallel
        h[s[i]] += 1;
        g[(i + 1000) / d[i] % 64] += 0.5 * i;
    }
}

static __attribute__((noinline)) void decided(int n, int *h, const int *s, const int *is_in,
                                              const int *map, const long *k, double *g) {
    for (int i = 0; i < n; i++) { // EXPECT: parallel
        h[s[i]] -= 9;
        if (is_in[i] > 0)
            g[map[k[i]]] += 0.5 * i;
    }
}

/* Two levels of tables: the second table's subscripts are unknown before the loop. */
static __attribute__((noinline)) void chained(int n, int *count, const int *map, const int *k,
                                              const int *far) {
    for (int i = 0; i < n; i++) // EXPECT: parallel
        count[map[far[k[i]]]] += FAR;
}

/* A condition decides whether a table is read. */
static __attribute__((noinline)) void sifted(int n, int *count, const int *map, const int *k,
                                             const char *is_in) {
    for (int i = 0; i < n; i++) // EXPECT: parallel
        if (is_in[i])
            count[map[k[i]]] += FAR;
}

/* The slice cannot be a separate function here, since the loop leaves the value `last`. */
static __attribute__((noinline)) int left(int n, int *count, const int *map, const int *k) {
    int last = 0;
    for (int i = 0; i < n; i++) { // EXPECT: parallel
        last = map[k[i]];
        count[last] += FAR;
    }
    return last;
}

/* The iteration that reads the subscript makes it valid, and the loop leaves a value. */
static __attribute__((noinline)) int touched_left(int n, const int *s, const int *by, int *h,
                                                  const int *idx, const int *lim, double *g) {
    int last = 0;
    for (int i = 0; i < n; i++) { // EXPECT: parallel
        h[s[i]] += by[i];
        last = lim[idx[i]];
        g[last] += 0.1 * i;
    }
    return last;
}

static __attribute__((noinline)) int sought(int n, int *count, const int *row, const int *column) {
    int last = -1;
    for (int i = 0; i < n; i++) // EXPECT: parallel
        for (int j = row[i]; j < row[i + 1]; j++) {
            if (column[j] < 0)
                continue;
            last = column[j];
            count[last] += FAR;
        }
    return last;
}

static int s[N], by[N], lim[N], k[N], map[N], row[N + 1], column[4 * N], far[N];
static int h[N + 1], count[N + 1], both[2 * N];
static long wide[N];
static char is_in[N];
static double g[N];

static double sum(const double *x, int n) {
    double all = 0;
    for (int i = 0; i < n; i++)
        all += x[i] * (1 + i % 7);
    return all;
}

static unsigned total(const int *x, int n) {
    unsigned all = 0;
    for (int i = 0; i < n; i++)
        all = all * 3 + (unsigned)x[i];
    return all;
}

static void fill(int first) {
    for (int i = 0; i < N; i++) {
        s[i] = i;
        h[i] = first;
        by[i] = -first + i;
        lim[i] = i % FEW; /* one iteration in FEW depends on another, so the wavefront method needs few barriers */
        k[i] = (int)((unsigned)i * 7919u % N);
        map[i] = (int)((unsigned)i * 104729u % 5000u);
        far[i] = N - 1 - i;
        is_in[i] = i % 3 != 0;
        row[i] = 4 * i;
        count[i] = 0;
        g[i] = 0;
    }
    row[N] = 4 * N;
    for (int j = 0; j < 4 * N; j++)
        column[j] = (int)((unsigned)j * 31u % 5000u);
}

static void show(const char *name) {
    printf("%s %u %u %a\n", name, total(h, N), total(count, N), sum(g, N));
}

/* Earlier iterations make valid what an iteration reads. */
static void in_order(void) {
    fill(-FAR);
    touched(N, s, by, h, h, lim, g);
    show("touched");
    fill(-FAR);
    printf("touched_left %d\n", touched_left(N, s, by, h, h, lim, g));
    show("touched_left");
    fill(-FAR);
    by[0] = FAR;
    for (int i = 1; i < N; i++) {
        s[i] = i % 64;
        by[i] = s[i] != 0;
    }
    keyed(N - FEW, s, by, h, h, lim, g);
    show("keyed");
    fill(0);
    for (int i = 0; i < N; i++) { /* iteration i makes k[i + 1] valid */
        k[i] = i == 0 ? 0 : i - FAR;
        map[i] = i + 1;
    }
    counted(N - 1, k, map, k);
    printf("counted %u\n", total(k, N));
    for (int i = 0; i < N; i++)
        k[i] = i == 0 ? 0 : i - FAR;
    const int last = left(N - 1, k, map, k);
    printf("left %d %u\n", last, total(k, N));
    for (int i = 0; i < N; i++) { /* iteration i makes far[k[i + 1]] valid */
        far[i] = i == 0 ? 0 : i - FAR;
        k[i] = i;
        map[i] = i + 1;
    }
    chained(N - 1, far, map, k, far);
    printf("chained %u\n", total(far, N));
    for (int i = 0; i < N; i++) { /* iteration i makes k[i + 2] valid, if that is read at all */
        k[i] = i < 2 ? i : i - FAR;
        map[i] = i + 2;
        is_in[i] = i % 5 != 0 || i % 2;
    }
    for (int i = 2; i < N; i++)
        is_in[i] = is_in[i - 2] && i % 7;
    sifted(N - 2, k, map, k, is_in);
    printf("sifted %u\n", total(k, N));
    for (int i = 0; i < N; i++) { /* iteration i makes row[i + 2] valid */
        row[i] = i < 2 ? i : i - FAR;
        column[i] = i + 2;
    }
    bounded(N - 2, row, row, column);
    printf("bounded %u\n", total(row, N));
    for (int i = 0; i < N; i++)
        row[i] = i < 2 ? i : i - FAR;
    const int found = sought(N - 2, row, row, column);
    printf("sought %d %u\n", found, total(row, N));
    fill(0);
    divided(N, h, s, h, g);
    show("divided");
    fill(0);
    for (int i = 0; i < N; i++) {
        wide[i] = i % 2 ? 1000L * FAR : i;
        h[i] = i % 2 ? 5 : 12;
    }
    decided(N, h, s, h, map, wide, g);
    show("decided");
}

static void apart(void) {
    fill(0);
    for (int i = 0; i < N; i++) {
        wide[i] = k[i];
        map[i] = i;
    }
    counted(N, count, map, k); /* each element is updated once, so adding FAR does not overflow */
    touched(N, s, lim, h, k, lim, g);
    show("counted and touched apart");
    for (int i = 0; i < N; i++)
        count[i] = 0;
    printf("touched_left apart %d\n", touched_left(N, s, lim, h, k, lim, g));
    show("touched_left apart");
    for (int i = 0; i < N; i++)
        count[i] = 0;
    printf("left apart %d ", left(N, count, map, k));
    printf("%u\n", total(count, N));
    for (int i = 0; i < N; i++) { /* for comparison: updates go upwards and reads downwards */
        k[i] = N - 1 - i;
        both[i] = 0;
        both[N + i] = N - 1 - i;
    }
    counted(N, both, both + N, k);
    printf("neighbours %u\n", total(both, N));
    fill(0);
    for (int j = 0; j < N; j++) {
        row[j] = j / 2;
        column[j] = N - 1 - j;
    }
    bounded(N - 1, count, row, column);
    show("bounded apart");
    for (int i = 0; i < N; i++)
        count[i] = 0;
    printf("sought apart %d ", sought(N - 1, count, row, column));
    printf("%u\n", total(count, N));
    by[0] = 1;
    divided(N, h, s, by, g);
    decided(N, h, s, by, map, wide, g);
    keyed(N - FEW, s, lim, h, k, lim, g);
    show("all apart");
    fill(0);
    for (int i = 0; i < N; i++)
        map[i] = i;
    chained(N, count, map, k, far);
    show("chained apart");
    for (int i = 0; i < N; i++)
        count[i] = 0;
    sifted(N, count, map, k, is_in);
    show("sifted apart");
}

int main(void) {
    in_order();
    for (int again = 0; again < 10; again++)
        apart();
    return 0;
}
