/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Rows of floats whose elements a record updates several times with double operands. Each update
 * must be rounded to float. gcc 12 may vectorise neighbouring elements and omit this rounding. (In
 * other such loops it does so in the original program as well.) */
// covers: row 41 of docs/constructs.md
// INTEGERS: no
// METHODS: expansion
#include "case.h"

enum { N = 6000, M = 64 };
static int s[N + 4];
static double w[N + 4], x[M];
static float h[M][3];

static void rows(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]][1] += -w[i / 2];
        h[s[i]][1] += w[i / 2] * x[s[i + 2]];
        h[s[i]][2] -= x[s[i + 3]] - -x[s[i]];
        h[s[i]][2] += 0.5f - (i % 3 == 0 ? w[i] : w[i / 2]);
    }
}

int main(void) {
    case_values(w, N + 4);
    case_values(x, M);
    for (int round = 0; round < 4; round++) {
        case_subscripts(s, N + 4, M);
        rows(N - round);
        CASE_PRINT(h);
    }
    return 0;
}
