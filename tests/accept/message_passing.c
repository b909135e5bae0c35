/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A loop between calls of MPI. A function with a body here is what its body does, also where it is
// called as one of MPI's would be: programs bring stubs to run without MPI.
// covers: row 85
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
