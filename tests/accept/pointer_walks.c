/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pointers that step through arrays: as the loop's counter, as secondary counters, and stepped where they
// are dereferenced. Integers stepped where they are used.
// covers: row 89, row 90 of docs/constructs.md
#include "case.h"

enum { N = 4000, ROWS = 90 };
struct pair {
    int row;
    double value;
};
struct list {
    const struct pair *first, *last;
};
static int s[3 * N + 9], picks[N], from[2 * ROWS], counted[ROWS], both[2 * ROWS];
static double e[3 * N + 9], h[ROWS];
static unsigned char bytes[3 * N + 9];
static struct pair pairs[N];

static void up_to(const int *p, const int *end) {
    for (; p < end; p++) // EXPECT: transformed
        counted[*p]++;
}

static const int *until(const int *a, int n) {
    const int *p;
    for (p = a; p != a + n; ++p) // EXPECT: transformed
        counted[*p] += 2;
    return p;
}

static void down(const int *a, int n) {
    for (const int *p = a + n - 1; p > a; p -= 2) // EXPECT: transformed
        h[*p] -= e[p - a] + (double)(p - a);
}

static void records(const struct list *l) {
    for (const struct pair *p = l->first; p != l->last; p++) // EXPECT: transformed
        h[p->row] += p->value;
}

static const struct pair *at_the_end(const struct pair *p, const struct pair *end) {
    while (p < end) { // EXPECT: transformed
        h[p->row] += p->value;
        p++;
    }
    return p;
}

static void conditions(const int *a, int n) {
    for (const int *p = a + 1; p < a + n; p++) // EXPECT: transformed
        if (p[-1] & 1)
            h[*p] += p[1];
        else
            h[*p] -= e[*p];
}

static void several_bytes(const unsigned char *p, const unsigned char *end) {
    for (; p < end; p += 3) // EXPECT: transformed
        counted[(p[0] + p[1] + p[2]) % ROWS]++;
}

static void may_overlap(int *to) {
    for (const int *p = s; p < &s[N]; p++) // EXPECT: transformed
        to[*p] ^= from[*p] & 63;
}

static const int *in_the_update(const int *p, const int *end) {
    while (p < end) // EXPECT: transformed
        counted[*p++]++;
    return p;
}

static int by_index(int n) {
    int i = 0;
    while (i < n) // EXPECT: transformed
        counted[s[i++]] += 2;
    return i;
}

static void in_a_declaration(const int *p, const int *end, const double *v) {
    while (p != end) { // EXPECT: transformed
        const double x = 2 * *v++;
        const int k = *p++;
        h[k] += x;
    }
}

static const double *two_walks(int n, const int *q, const double *v) {
    while (n--) // EXPECT: transformed
        h[*q++] += *v++;
    return v;
}

static const unsigned char *pixels(int n, const unsigned char *p) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int r = *p++, g = *p++, b = *p++;
        counted[(r + g + b) % ROWS]++;
    }
    return p;
}

static const double *by_rows(int n, int ld, const double *v) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += v[1];
        v += ld;
    }
    return v;
}

static void set_in_header(int n) {
    const double *v;
    int i;
    for (i = 0, v = e + n; i < n; i++, v--) // EXPECT: transformed
        h[s[i]] -= *v;
}

static int step_in_subscript(int n, int j) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[j++ + (t & 1)]] += e[t];
    return j;
}

static int step_in_value(int n, int j) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[j--];
    return j;
}

static void own_step(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j = s[t] / 2;
        h[s[t]] += e[j] * e[j + 1];
        h[s[t]] -= 0.5 * s[j++];
    }
}

/* The guard finds at run time that reads and updates overlap. */
static void reads_what_it_updates(int n, const int *p) {
    while (n--) // EXPECT: transformed
        counted[(unsigned)*p++ % ROWS]++;
}

/* `q` steps over subscripts of `other`, which lies outside of the updated elements first and among them later. */
static void looked_up(int n, const int *q, const int *other, int *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[s[t]] += other[*q++] & 63;
}

int main(void) {
    long ends[1] = {0};
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, 3 * N + 9, ROWS);
        case_values(e, 3 * N + 9);
        for (int i = 0; i < 3 * N + 9; i++)
            bytes[i] = (unsigned char)case_below(256);
        for (int i = 0; i < N; i++)
            pairs[i] = (struct pair){s[2 * i], e[i]};
        for (int i = 0; i < ROWS; i++)
            from[i] = case_below(64);
        for (int again = 0; again < 2; again++) {
            up_to(s + round, s + N);
            up_to(s + N, s);
            ends[0] += until(s, N) - s;
            down(s + 1, N);
            records(&(struct list){pairs, pairs + N});
            ends[0] += at_the_end(pairs + 1, pairs + N) - pairs;
            conditions(s, N);
            several_bytes(bytes, bytes + 3 * N - 1);
            may_overlap(from);
            may_overlap(counted);
            ends[0] += in_the_update(s, s + N) - s;
            ends[0] += by_index(N);
            in_a_declaration(s, s + N, e);
            ends[0] += two_walks(N, s, e) - e;
            ends[0] += pixels(N, bytes) - bytes;
            ends[0] += by_rows(N, 2 + again, e) - e;
            set_in_header(N);
            ends[0] += step_in_subscript(N, round);
            ends[0] += step_in_value(N, N + round);
            own_step(N);
            for (int i = 0; i < N; i++)
                picks[i] = i % ROWS + (again ? 0 : ROWS);
            for (int i = 0; i < 2 * ROWS; i++)
                both[i] = i;
            looked_up(N, picks, both, both);
            ends[0] += both[7] + 3 * both[ROWS - 1];
            looked_up(N, picks, from, both);
            reads_what_it_updates(ROWS, counted);
            reads_what_it_updates(N, s);
        }
    }
    CASE_PRINT(h);
    CASE_PRINT(counted);
    CASE_PRINT(from);
    CASE_PRINT(ends);
    return 0;
}
