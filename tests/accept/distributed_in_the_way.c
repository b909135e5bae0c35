/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Each iteration stores to its own element. Where the updated array overlaps the array read, in part or
// entirely, the loop stays sequential.
// covers: row 93 of docs/constructs.md
// MAY-RUN-SERIALLY: arrays overlap
#include "case.h"

enum { N = 12000, M = 900 };
static int at[N];
static double pool[N + M];

static void to_zero(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        t[i] = 0;
    }
}

static void by_factors(int n, const int *r, double *y, double *t, double factor) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] += t[i] * t[i];
        t[i] *= factor;
    }
}

static void under_conditions(int n, const int *r, double *y, double *t, int limit) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        if (t[i] != 0.0 && i != limit) {
            y[r[i]] -= t[i];
            t[i] = 0.125;
        }
}

int main(void) {
    case_subscripts(at, N, M - 20);
    for (int round = 0; round < 12; round++) {
        const int n = round == 3 ? 5000 : N;
        case_values(pool, N + M);
        switch (round % 6) {
        case 0:
            to_zero(n, at, pool, pool);
            break;
        case 1:
            to_zero(n - 300 * round, at, pool + 300 * round, pool);
            break;
        case 2:
            by_factors(n, at, pool + n - 1, pool, 0.25);
            break;
        case 3:
            by_factors(n, at, pool, pool + M - 21, 0.75);
            break;
        case 4:
            under_conditions(N, at, pool + 17, pool, 17);
            break;
        default:
            under_conditions(N, at, pool, pool + M - 40, 17);
        }
        CASE_PRINT(pool);
    }
    return 0;
}
