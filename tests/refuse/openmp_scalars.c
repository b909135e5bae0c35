/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: directives that reduce scalars in ways that blocks of iterations cannot reproduce. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
#define SUM reduction(+ : sum)
#define WIDTH sizeof(double)
static double w[1000], h[10];
static int last_of_file;
int omp_get_thread_num(void);
double of_another_file(int i);
#pragma omp threadprivate(last_of_file)

double by_region(int n) {
    static double sum;
#pragma omp parallel
    {
#pragma omp for reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += w[i];
    }
    return sum;
}

double clauses(int n) {
    double sum = 0, at = 0;
#pragma omp parallel for simd reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp parallel for collapse(1 + 1) reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        for (int j = 0; j < n; j++)
            sum += w[i] * w[j];
#pragma omp parallel for linear(at : 1) reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i] + at;
#pragma omp parallel for ordered reduction(+ : sum)
    for (int i = 0; i < n; i++) { // EXPECT: refuse existing-openmp
#pragma omp ordered
        sum += w[i];
    }
#pragma omp parallel for reduction(task, + : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp parallel for reduction(+ : sum, h[ : 10])
    for (int i = 0; i < n; i++) { // EXPECT: refuse existing-openmp
        sum += w[i];
        h[0] += sum;
    }
#pragma omp parallel for reduction(+ : sum, h[ : 10])
    for (int i = 0; i < n; i++) { // EXPECT: refuse impure-call
        sum += w[i];
        h[i % 10] += of_another_file(i);
    }
    /* each thread executes all iterations */
#pragma omp parallel reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp parallel for allocate(sum) reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp parallel for SUM
    for (int i = 0; i < n; i++) // EXPECT: nothing
        sum += w[i];
#pragma omp parallel for num_threads(WIDTH) reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
    return sum;
}

#define FOR(i, n) for (int i = 0; i < n; i++)
#define MOST 1000
#undef MOST
#define MOST 8 + 1

double loops(int n, int step) {
    double sum = 0;
    volatile double seen = 0;
    _Complex double both = 0;
#pragma omp parallel for reduction(+ : sum)
    FOR(i, n) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp parallel for reduction(+ : sum)
    for (const double *v = w; v < w + n; v++) // EXPECT: refuse existing-openmp
        sum += *v;
#pragma omp parallel for reduction(+ : sum)
    for (int i = 0; i < n; i += step) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp parallel for reduction(+ : seen)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        seen += w[i];
#pragma omp parallel for reduction(+ : both)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        both += w[i];
#pragma omp parallel for reduction(+ : sum) num_threads(MOST)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
    return sum + seen + __real__ both;
}

double jumps(int n) {
    double sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int i = 0; i < n; i++) { // EXPECT: refuse existing-openmp
        if (w[i] < 0) {
#pragma omp cancel for
        }
        sum += w[i];
    }
#pragma omp parallel for schedule(static, 4) reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i] * omp_get_thread_num();
    return sum;
}

inline double shared_inline(int n) {
    double sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
    return sum;
}

#ifndef TWICE
double begun(int n) {
    double sum = 0;
#else
double begun(long n) {
    float sum = 1;
#endif
#pragma omp parallel for reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i] * 5;
    return sum;
}
