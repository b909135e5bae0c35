/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Elements that an iteration stores and reads again, as subscripts and as values.
// covers: row 31, row 59 of docs/constructs.md
#include "case.h"

enum { N = 6000, M = 500 };
static int key[N], s[N], copy[N], half[N], count[N];
static unsigned char narrow[N];
static float rounded[N];
static double v[N], h[M], g[M], out[N], part[N][3], by_key[M];
static _Bool is_odd[N];
struct work {
    int bin[N];
    float *sum;
    struct {
        int k;
        double x;
    } item[N];
};

static void chained(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        copy[t] = key[t];
        half[t] = copy[t] / 2;
        h[half[t]] += copy[t] * v[t];
        h[copy[t]] -= half[t];
    }
}

/* The value read again is the value stored, converted to the element's type. */
static void conversions(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        rounded[t] = 0.1 * v[t];
        narrow[t] = 3 * key[t];
        is_odd[t] = key[t] & 2;
        h[narrow[t]] += rounded[t];
        g[narrow[t] + is_odd[t]] += is_odd[t] + narrow[t];
    }
}

static void conditional(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (key[t] % 3 == 0)
            continue;
        if (s[t] > 40) {
            copy[t] = key[t];
            h[copy[t]] += v[t];
        } else {
            out[t] = v[t] + v[t];
            g[s[t]] += out[t];
        }
    }
}

static void inner_loops(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int c;
        for (c = 0; c < 3; c++) {
            part[t][c] = v[t] * c;
            h[s[t]] += part[t][c];
            g[key[t]] -= part[t][c];
        }
        count[n - 1 - t] = key[t] % 4;
        for (int k = 0; k < count[n - 1 - t]; k++)
            h[(s[t] + k) % M] += v[t];
    }
}

/* Several iterations store into one element: the value of the last of them remains. */
static void conflicts(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k = s[t];
        by_key[k] = v[t];
        h[key[t]] += by_key[k];
    }
}

static void members(struct work *w, int n) {
    int t = n - 1;
    while (t >= 0) { // EXPECT: transformed
        w->bin[t] = key[t];
        w->item[t].k = w->bin[t] + 1;
        w->item[t].x = v[t];
        w->sum[w->item[t].k] += w->item[t].x;
        w->sum[w->bin[t]] -= 1;
        t--;
    }
}

#define PUT(a, x) a = (x)
#define GET(a) ((a) + 0)
#define STORE(a, x)                                                                                \
    do {                                                                                           \
        (a) = (x);                                                                                 \
        h[(a)] += 1;                                                                               \
    } while (0)
static int twice(int x) {
    return 2 * x;
}
static void macros(int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        PUT(copy[t], twice(key[t] / 4));
        STORE(half[t], s[t]);
        h[GET(copy[t])] += 0.25; /* reads copy[t] */
        sum += copy[t];
    }
    case_print("sum", &sum, sizeof sum);
}

/* By C's effective type rule (C17 6.5p7), arrays of different types are disjoint. */
static void __attribute__((noinline)) pointers(int n, int *bin, double *a, float *b) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        bin[t] = key[t];
        b[t] = bin[t];
        a[bin[t]] += b[t] + v[t];
    }
}

int main(void) {
    static int bin[N];
    static float sum[M];
    static struct work w = {.sum = sum};
    case_values(v, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(key, N, 200);
        case_subscripts(s, N, 80);
        chained(N);
        conversions(N);
        conditional(N);
        inner_loops(N - round);
        conflicts(N);
        members(&w, N);
        macros(N);
        pointers(N, bin, g, rounded);
        CASE_PRINT(h);
        CASE_PRINT(g);
        CASE_PRINT(copy);
        CASE_PRINT(half);
        CASE_PRINT(count);
        CASE_PRINT(narrow);
        CASE_PRINT(rounded);
        CASE_PRINT(out);
        CASE_PRINT(part);
        CASE_PRINT(by_key);
        CASE_PRINT(is_odd);
        CASE_PRINT(bin);
        CASE_PRINT(sum);
        CASE_PRINT(w.bin);
        for (int t = 0; t < N; t++) {
            case_print("k", &w.item[t].k, sizeof w.item[t].k);
            case_print("x", &w.item[t].x, sizeof w.item[t].x);
        }
    }
    return 0;
}
