/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Two sums in inner loops, at addresses that the caller chooses, may be one and the same. A guard detects this: the
// operands of each sum are added on their own.
// MAY-RUN-SERIALLY: sums overlap
#include "case.h"

enum { N = 5000, M = 700, MOST = 8 };

static int row[N], first[N + 1];
static double value[MOST * N], histogram[M], energy[3];

static void both(int n, const int *k, const int *restrict p, double *to, double *a, double *b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        for (int j = p[i]; j < p[i + 1]; j++) {
            to[k[i]] += value[j];
            *a += value[j];
            *b -= value[j] * 0.5;
        }
    }
}

int main(void) {
    case_subscripts(row, N, M);
    case_values(value, MOST * N);
    for (int i = 0; i < N; i++)
        first[i + 1] = first[i] + i % MOST;
    for (int repeat = 0; repeat < 4; repeat++) {
        both(N, row, first, histogram, &energy[0], &energy[0]);
        both(N, row, first, histogram, &energy[0], &energy[1]);
        both(N, row, first, histogram, &energy[2], &energy[2]);
    }
    case_print("histogram", histogram, sizeof histogram);
    case_print("energy", energy, sizeof energy);
    return 0;
}
