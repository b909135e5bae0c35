/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that are reached again, in an enclosing loop or by a jump, and continue with the counter's last
// value. Nothing else uses this value.
// covers: row 4, row 7, row 9 of docs/constructs.md
#include "case.h"

enum { N = 5000, M = 300 };
static int k[N];
static double h[M], w[N];

__attribute__((noipa)) static void by_jump(int n, double *to) {
    int rounds = 0;
    int i = 0;
again:
    while (i < n) { // EXPECT: transformed
        to[k[i]] += w[i];
        i++;
    }
    if (++rounds < 3)
        goto again;
}

__attribute__((noipa)) static void in_a_loop(int n, double *to) {
    int i = 0;
    for (int round = 0; round < 3; round++)
        while (i < n) { // EXPECT: transformed
            to[k[i]] -= w[i];
            i++;
        }
}

__attribute__((noipa)) static void without_a_start(int n, double *to) {
    int i = 0;
    for (int round = 0; round < 3; round++)
        for (; i < n; i += 2) // EXPECT: transformed
            to[k[i]] += 0.5 * w[i];
}

int main(void) {
    case_subscripts(k, N, M);
    case_values(w, N);
    for (int round = 0; round < 2; round++) {
        by_jump(N, h);
        CASE_PRINT(h);
        in_a_loop(N, h);
        CASE_PRINT(h);
        without_a_start(N, h);
        CASE_PRINT(h);
    }
    return 0;
}
