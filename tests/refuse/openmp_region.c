/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: `for` loops that reduce scalars, where each thread may have to execute its own iterations. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
static double w[1000], q[1000], of_file, of_thread, buffer[100];
#pragma omp threadprivate(of_thread, buffer)
int omp_get_thread_num(void);
void other(void);

/* each thread would have its own sum, in a parallel region of the caller or through threadprivate */
void not_shared(int n, double *to) {
    double sum = 0;
#pragma omp for reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        sum += w[i];
#pragma omp for reduction(+ : of_thread)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        of_thread += w[i];
    *to = sum;
}

/* a thread reads again what it stored in the same iteration of an earlier loop */
void kept(int n) {
    double sum = 0;
#pragma omp parallel
    {
        double mine[1000];
#pragma omp for schedule(static)
        for (int i = 0; i < n; i++)
            mine[i] = w[i];
#pragma omp for schedule(static) reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += mine[i];
    }
#pragma omp parallel
    {
        other();
#pragma omp for schedule(static) reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += buffer[i % 100];
    }
    of_file = sum;
}

void by_number(int n) {
    double sum = 0;
#pragma omp parallel
    {
        const int me = omp_get_thread_num();
#pragma omp for schedule(static, 5) reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += w[i] * me;
    }
    of_file = sum;
}

/* another region set `of_thread` to the thread's number */
void by_known_number(int n) {
    double sum = 0;
#pragma omp parallel
    {
        double mine[1000];
#pragma omp for schedule(static, 5) reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += mine[i] = w[i];
        q[(int)of_thread] = mine[5 * (int)of_thread];
    }
    of_file = sum;
}

void orphan(int n, const double *x) {
#pragma omp for schedule(static) reduction(+ : of_file)
    for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
        of_file += x[i];
}

/* each thread has its own copy of the sum; a region that is not analysed */
void regions(int n) {
    double sum = 0;
#pragma omp parallel firstprivate(sum)
    {
#pragma omp for reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += w[i];
        q[0] = sum;
    }
#pragma omp parallel sections
    {
#pragma omp for reduction(+ : sum)
        for (int i = 0; i < n; i++) // EXPECT: refuse existing-openmp
            sum += w[i];
    }
}
