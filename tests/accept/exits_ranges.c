/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An iteration leaves the loop long before its bound, where addresses would overflow. What the loop reads overlaps what
// it updates, and only the guard can tell.
// MAY-RUN-SERIALLY: reads and updates overlap
// INTEGERS: no
#include <limits.h>
#include "case.h"

enum { N = 15000 };
static int buffer[3 * N + 9], k[N], end[N];

__attribute__((noinline)) static int scaled(int *hist, const int *a, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (a[3 * t] < 0)
            return t;
        hist[k[t]] -= 1;
    }
    return -1;
}

__attribute__((noinline)) static int of_condition(int *hist, const int *a, long n) {
    for (long t = 0; t < n; t++) { // EXPECT: transformed
        if (a[t] < 0)
            return (int)t;
        hist[k[t]] -= 1;
    }
    return -1;
}

__attribute__((noinline)) static int before_exit(int *hist, const int *x, long n) {
    long t;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        int v = x[t] % 7 + 1;
        if (end[t] < 0)
            break;
        hist[k[t]] += v;
    }
    return (int)t;
}

/* The compiler must not warn of list[n - 1], which no iteration reads. */
__attribute__((noinline)) static int of_constant_bound(double *h) {
    for (int t = 0; t < 1000000; t++) { // EXPECT: transformed
        if (end[t] < 0)
            return t;
        h[k[t]] += 0.5;
    }
    return -1;
}

static void begin(void) {
    for (int i = 0; i < 3 * N; i++)
        buffer[i] = 5;
    buffer[12000] = -1;
}

int main(void) {
    static double h[300];
    for (int i = 0; i < N; i++)
        k[i] = (i * 7919) % 300;
    end[12000] = -1;
    int at[8];
    begin();
    at[0] = scaled(buffer + 2000, buffer, INT_MAX / 3 * 2 + 3);
    CASE_PRINT(buffer);
    begin();
    at[1] = of_condition(buffer + 2000, buffer, LONG_MAX);
    begin();
    at[2] = of_condition(buffer + 2000, buffer, LONG_MAX / 2 + 2);
    CASE_PRINT(buffer);
    begin();
    at[3] = before_exit(buffer + 6000, buffer, LONG_MAX);
    CASE_PRINT(buffer);
    at[4] = of_constant_bound(h);
    case_print("h", h, sizeof h);
    case_print("at", at, sizeof *at * 5);
    return 0;
}
