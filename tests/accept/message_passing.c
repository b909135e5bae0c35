/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A loop in a program that calls MPI. Functions with MPI's names that have a body here are analysed
// by their body: programs without MPI define such stubs.
// covers: row 85 of docs/constructs.md
#include "case.h"

enum { N = 9000, M = 700 };

static double MPI_Weight(int t) {
    return t % 8;
}

static int MPI_Allreduce(const double *in, double *out, int n) {
    for (int i = 0; i < n; i++)
        out[i] = in[i];
    return 0;
}

static void scatter(double *restrict h, const int *restrict s, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += MPI_Weight(t);
}

int main(void) {
    static double h[M], sum[M];
    static int s[N];
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        scatter(h, s, N);
        MPI_Allreduce(h, sum, M);
        CASE_PRINT(sum);
    }
    return 0;
}
