/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Variables that a pragma makes thread-local: each thread of the loop would use its own.
// covers: row 13 of docs/constructs.md
// FLAGS: -w -fopenmp
static double of_thread;
#pragma omp threadprivate(of_thread)

static double read_it(void) {
    return of_thread;
}

void read_in_loop(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += of_thread;
}

void read_by_callee(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += read_it();
}
