/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A variable of the name of a function that generated text calls.
// covers: row 68
void kernel(int n, const int *restrict s, double *restrict h) {
    double omp_get_thread_num = 5;
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += omp_get_thread_num;
}
