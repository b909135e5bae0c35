/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: one directive applies to a nest of loops, and an inner loop must remain where it is. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
enum { N = 1000, TWO = 2 };
static double w[N], h[N];
static int s[N], of_file;
#define BOTH collapse(2)
#define NEST _Pragma("omp parallel for collapse(2)")
double of_another_file(int i);

/* the directive remains and needs the inner loop in its original form */
void inner(int n, int m, double *restrict to) {
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < m; j++) // EXPECT: refuse existing-openmp
            to[s[i] + s[j]] += w[j];
#pragma omp parallel for ordered(2)
    for (int i = 0; i < n; i++) { // EXPECT: refuse existing-openmp
        for (int j = 0; j < m; j++) { // EXPECT: refuse existing-openmp
            to[s[i] + s[j]] += w[j];
        }
    }
#pragma omp parallel for BOTH
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        for (int j = 0; j < m; j++) // EXPECT: refuse existing-openmp
            to[s[i] + s[j]] += w[j];
    NEST
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < m; j++) // EXPECT: refuse existing-openmp
            to[s[i] + s[j]] += w[j];
    if (n > 3)
        NEST for (int i = 0; i < n; i++) // EXPECT: nothing
            for (int j = 0; j < m; j++) // EXPECT: refuse existing-openmp
                to[s[i] + s[j]] += w[j];
#pragma omp parallel
#pragma omp for collapse(3)
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < m; j++)
            for (int k = 0; k < m; k++) // EXPECT: refuse existing-openmp
                to[s[i] + s[k]] += w[j];
#pragma omp taskloop collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < m; j++) // EXPECT: refuse existing-openmp
            to[s[i] + s[j]] += w[j];
}

/* a depth that is no literal */
void depths(int n) {
#pragma omp parallel for collapse(TWO)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        for (int t = 0; t < n; t++)
#pragma omp atomic
            h[s[t] / 2 + s[i] / 2] += w[i];
#pragma omp parallel for collapse(1 + 1)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        for (int t = 0; t < n; t++)
#pragma omp atomic
            h[s[t] / 2 + s[i] / 2] += w[i];
}

/* inner counters that are visible elsewhere and would have to keep their values */
void counters(int n) {
    static int of_function;
    int t, u, *const to = &u;
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: refuse other-store
        for (of_file = 0; of_file < n; of_file++)
#pragma omp atomic
            h[s[of_file] / 2 + s[i] / 2] += w[i];
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: refuse other-store
        for (of_function = 0; of_function < n; of_function++)
#pragma omp atomic
            h[s[of_function] / 2 + s[i] / 2] += w[i];
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: refuse scalar-carried
        for (u = 0; u < n; u++)
#pragma omp atomic
            h[s[u] / 2 + s[i] / 2] += w[i] + *to;
#pragma omp parallel for collapse(2) linear(t)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        for (t = 0; t < n; t++)
#pragma omp atomic
            h[s[t] / 2 + s[i] / 2] += w[i];
}

/* the loop's body decides, as without a directive */
void others(int n) {
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        for (int t = 0; t < n; t++) {
            const double v = of_another_file(i);
#pragma omp atomic
            h[s[t] / 2 + s[i] / 2] += v;
        }
#pragma omp parallel for collapse(2)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        for (int t = 0; t < n; t++)
#pragma omp atomic seq_cst
            h[s[t] / 2 + s[i] / 2] += w[i];
}
