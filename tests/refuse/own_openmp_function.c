/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions of OpenMP's names, which generated text calls, that are the program's own.
// covers: row 68
static int omp_in_parallel(void) {
    return 3;
}

int kernel(int n, const int *restrict s, double *restrict h, const double *e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += e[t];
    return omp_in_parallel();
}
