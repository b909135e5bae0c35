/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: a region's `for` loop updates arrays, and no thread may execute it for the others. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
enum { N = 1000 };
static double w[N], h[N], q[N], of_thread[N];
#pragma omp threadprivate(of_thread)
static int s[N];
int omp_get_thread_num(void);
void other(void);

/* each thread has its own array */
void not_shared(int n) {
    double mine[N] = {0};
#pragma omp for reduction(+ : mine)
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        mine[s[t]] += w[t];
#pragma omp for
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-local
#pragma omp atomic
        of_thread[s[t]] += w[t];
    q[0] += mine[0];
}

/* no atomic protects `mine`, since each thread adds to its own copy */
void own_bins(int n) {
#pragma omp parallel
    {
        double mine[N] = {0};
#pragma omp for
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
            mine[s[t]] += w[t];
#pragma omp critical
        for (int i = 0; i < N; i++)
            h[i] += mine[i];
    }
}

/* a thread reads again what it stored in the same iteration of an earlier loop */
void kept(int n) {
#pragma omp parallel
    {
        double mine[N];
#pragma omp for schedule(static)
        for (int t = 0; t < n; t++)
            mine[t] = w[t];
#pragma omp for schedule(static)
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[t]] += mine[t];
    }
}

/* the thread uses which iterations it executed */
void by_number(int n) {
#pragma omp parallel
    {
        const int me = omp_get_thread_num();
#pragma omp for schedule(static, 5)
        for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
            q[t] = w[t];
#pragma omp atomic
            h[s[t]] += w[t];
        }
        q[5 * me] += 1;
    }
}

/* each thread's copy of `many` begins with the lowest int */
void reduced(int n) {
    int many = 100;
#pragma omp parallel reduction(max : many)
    {
#pragma omp for
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[t]] += many;
    }
    q[0] = many;
}

/* regions that are not analysed, or that permit only the variables they list */
void regions(int n) {
#pragma omp parallel sections
    {
#pragma omp for
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[t]] += w[t];
    }
#pragma omp parallel default(none) shared(n, h, s, w)
    {
#pragma omp for
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[t]] += w[t];
    }
}

/* clauses and locks as in `parallel for` */
void clauses(int n) {
#pragma omp parallel
    {
#pragma omp for ordered
        for (int t = 0; t < n; t++) { // EXPECT: refuse existing-openmp
#pragma omp ordered
            h[s[t]] += w[t];
        }
#pragma omp for
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic seq_cst
            h[s[t]] += w[t];
#pragma omp for
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[t]] += omp_get_thread_num();
#pragma omp for simd
        for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
#pragma omp atomic
            h[s[t]] += w[t];
    }
}
