/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: threads that leave a cancelled region do not reach the barriers of its loops. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
static double w[1000], h[1000], of_file;
static int s[1000];

void cancels(int n) {
#pragma omp parallel
    {
        if (n < 0) {
#pragma omp cancel parallel
        }
#pragma omp for reduction(+ : of_file)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            of_file += w[i];
#pragma omp for
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[i]] += w[i];
    }
}
