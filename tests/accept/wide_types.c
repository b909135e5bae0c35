/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Elements of types long double and complex.
// covers: row 42 of docs/constructs.md
#include "case.h"
#include <complex.h>

enum { N = 9000, M = 500 };
static int s[N];
static double w[N];
static double complex wave[N];
static long double sums[M];
static double complex field[M];
static double shown[M][3];

static void wide(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        sums[s[t]] += (long double)w[t] / 3.0L;
}

static void planes(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        field[s[t]] += wave[t] * w[t];
}

static void imaginary(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double complex z = w[t] - I * w[n - 1 - t];
        field[s[t]] += z + 2.0i * conj(wave[t]) * 1.0if;
        if (creal(z) > 0)
            field[s[t]] -= 0x1p2i;
    }
}

int main(void) {
    case_values(w, N);
    for (int t = 0; t < N; t++)
        wave[t] = case_value() + I * case_value();
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        if (getenv("CASE_INTEGERS") == NULL)
            wide(N);
        planes(N);
        imaginary(N);
        for (int i = 0; i < M; i++) { /* a long double has padding bytes, which must not be compared */
            shown[i][0] = (double)sums[i];
            shown[i][1] = (double)(sums[i] - (long double)shown[i][0]);
            shown[i][2] = creal(field[i]) + 3.0 * cimag(field[i]);
        }
        CASE_PRINT(shown);
        CASE_PRINT(field);
    }
    return 0;
}
