/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The function may also be compiled for a device, where the runtime library does not exist. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
enum { N = 1000 };
double h[N], w[N];
int s[N];
double sum;

#pragma omp declare target
void on_a_device(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]] += w[t];
    }
#pragma omp parallel for reduction(+ : sum)
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        sum += w[t];
}
#pragma omp end declare target
