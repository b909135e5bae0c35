/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: `for` in a region around updates of arrays, which one thread may not execute for all. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
enum { N = 1000 };
static double w[N], h[N], q[N], of_thread[N];
#pragma omp threadprivate(of_thread)
static int s[N];
int omp_get_thread_num(void);
void other(void);

/* each thread has an array of its own */
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

/* nothing protects them: threads add up for themselves */
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

/* a thread finds again what it kept of an iteration */
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

/* it knows which iterations are its own */
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

/* the copies of `many` begin with the least value */
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

/* regions that are not understood, or use nothing but what they name */
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

/* clauses and locks as for `parallel for` */
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
