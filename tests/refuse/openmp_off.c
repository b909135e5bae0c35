/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Read without OpenMP, compiled with it: a loop that asks for _OPENMP would be another one. */
// covers: row 55
// FLAGS: -fno-openmp
void inside(int n, const int *restrict k, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#ifdef _OPENMP
        h[k[t]] += 2;
#else
        h[k[t]] += 1;
#endif
    }
}

void above(int n, const int *restrict k, double *restrict h) {
#if defined _OPENMP && defined USING_OPENMP
#pragma omp parallel for
#endif
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[k[t]] += 1;
}
