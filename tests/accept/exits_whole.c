/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An iteration leaves the loop, and the loop cannot continue there: the branch reads what the header sets, the header
// sets the bound, or has braces, or a macro makes the header. The original loop then runs from its start.
// MAY-RUN-SERIALLY: one iteration always leaves
// INTEGERS: no
#include "case.h"

enum { N = 1500, M = 200 };
static int k[N];
static double h[M], w[N];

static void note(double value) {
    printf("%.17g\n", value);
}

__attribute__((noinline)) static void whole(int n) {
    for (int t = 0, last = -1; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0) {
            note(last);
            break;
        }
        last = k[t];
        h[last] += w[t];
    }
    int t, e;
    for (t = 0, e = n; t < e; t++) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t];
    }
    note(t);
}

#define FROM 2
__attribute__((noinline)) static int macros(int n) {
    int t;
    for (t = FROM; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t];
    }
    return t;
}

__attribute__((noinline)) static int braces(int n) {
    for (int t = {0}; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0)
            return t;
        h[k[t]] += w[t];
    }
    return -1;
}

static void run(int n) {
    whole(n);
    note(macros(n));
    note(braces(n));
    CASE_PRINT(h);
}

int main(void) {
    static const int places[] = {0, 1, 700, N - 1};
    for (unsigned p = 0; p < sizeof places / sizeof *places; p++) {
        case_subscripts(k, N, M);
        case_values(w, N);
        run(N);
        k[places[p]] = -1;
        run(N);
    }
    return 0;
}
