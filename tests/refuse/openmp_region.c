/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiled with OpenMP: `for` that reduces scalars, and whose iterations may have to stay where they are. */
// covers: row 55 of docs/constructs.md
// FLAGS: -fopenmp
static double w[1000], q[1000], of_file, of_thread, buffer[100];
#pragma omp threadprivate(of_thread, buffer)
int omp_get_thread_num(void);
void other(void);

/* each thread would have another sum: below `parallel` of a caller, and of the function */
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

/* a thread finds again what it kept of an iteration */
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

/* the number is known from another region */
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

/* a copy for each thread of its team; a region that is not understood */
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
