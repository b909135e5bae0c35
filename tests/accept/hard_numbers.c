/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Numbers that are hard to sum: cancellation, all magnitudes, subnormals, infinities and NaN, minus
// zero, float counters past 2^24, integers that wrap around. Also: all updates to one element, one
// iteration, and no iteration.
// INTEGERS: no
// MAY-RUN-SERIALLY: threads do not pay off for one iteration or none
#include "case.h"
#include <math.h>
#include <string.h>

enum { N = 9000, M = 500 };
static int s[N], one[N];
static double w[N], b[M];
static float h[M];
static signed char c8[M];
static unsigned u32[M];

static void add(int n, const int *k) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[k[t]] += w[t];
}

static void count(int n, const int *k) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[k[t]] += 1;
        c8[k[t]] += 100;
        u32[k[t]] -= 3000000019u * (unsigned)t;
    }
}

/* Replaces NaNs by one, since the compiler's choice of (a + b) or (b + a) decides which NaN results. */
static void print_sums(const char *name) {
    for (int i = 0; i < M; i++)
        if (isnan(b[i]))
            b[i] = (double)NAN;
    case_print(name, b, sizeof b);
}

static void each(const char *name, double (*value)(int t), double before) {
    for (int t = 0; t < N; t++)
        w[t] = value(t);
    for (int round = 0; round < 2; round++) {
        for (int i = 0; i < M; i++)
            b[i] = before;
        add(N, s);
        print_sums(name);
        add(N, one);
        print_sums(name);
    }
}

static double cancelling(int t) {
    static double last;
    last = t % 2 ? 1e-3 * case_value() - last : 1e13 * (1.5 + case_value());
    return last;
}

static double of_all_magnitudes(int t) {
    return (t % 3 ? 1 : -1) * pow(10, 300 * case_value());
}

static double subnormal(int t) {
    return (t % 2 ? 1 : -1) * case_value() * 0x1p-1022;
}

static double infinite_at_times(int t) {
    const int which = case_below(700);
    return which == 0 ? (double)NAN : which < 3 ? (t % 2 ? 1.0 : -1.0) * INFINITY : case_value();
}

static double minus_zero(int t) {
    (void)t;
    return -0.0;
}

int main(void) {
    case_subscripts(s, N, M);
    for (int t = 0; t < N; t++)
        one[t] = M / 2;
    each("cancelling", cancelling, 0);
    each("magnitudes", of_all_magnitudes, 1e-300);
    each("subnormals", subnormal, 0x1p-1022);
    each("infinities", infinite_at_times, 0);
    each("minus zero", minus_zero, -0.0);
    for (int i = 0; i < M; i++)
        h[i] = 0x1p24f - 9;
    for (int round = 0; round < 3; round++) {
        count(N, round ? one : s);
        count(1, s);
        count(0, s);
        add(1, s);
        add(0, s);
        CASE_PRINT(h);
        CASE_PRINT(c8);
        CASE_PRINT(u32);
        CASE_PRINT(b);
    }
    return 0;
}
