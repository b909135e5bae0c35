/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP and an option by which directives are kept. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
// OPTIONS: --openmp=keep
void existing_openmp(int n, const int *restrict s, double *restrict h) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp atomic
        h[s[t]]++;
    }
}

void existing_openmp_with_others(int n, const int *restrict s, double *restrict h) {
#ifdef _OPENMP
#pragma omp parallel for
#endif
#pragma GCC ivdep
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[s[t]]++;
}

void asks_for_openmp(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#ifdef _OPENMP
#pragma omp atomic
#endif
        h[k[t]] += 1;
    }
#if defined(_OPENMP)
#pragma omp parallel for
#endif
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[k[t]] += 1;
}

void compiled_openmp(int n, const int *k, double *h) {
#pragma omp parallel for
#ifdef OTHER
    for (int t = 0; t < 2 * n; t++)
#else
    for (int t = 0; t < n; t++) // EXPECT: nothing
#endif
        h[k[t]] += 1;
#ifndef OTHER
#pragma omp parallel for
#endif
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[k[t]] += 1;
}

/* The conditional group above the loop defines a macro, so it is no part of the loop. */
void openmp_of_another_compilation(int n, const int *k, double *h) {
#ifdef OTHER
#define TWICE
#pragma omp parallel for
#endif
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        h[k[t]] += 1;
}

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

/* The directive after the loop is compiled, and its clause reads `last`. */
int directive_behind(int n, const int *k, double *h) {
    int last = 1, count = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse last-value
        if (k[t] > 2)
            for (last = 0; last < k[t]; last++)
                h[k[t]] += 1;
#ifndef OTHER
#pragma omp parallel num_threads(last) reduction(+ : count)
#endif
    count++;
    last = 0;
    return count + last;
}
