/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: the team of an enclosing region executes `for` loops that update arrays, in a fixed
// order.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// FIXED: 36 55 69 108 122
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
#include "case.h"

enum { N = 20000, M = 900, P = 40 };
static int s[N], r[N];
static double w[N], x[M], h[M], g[M], e[M], c[M], q[M], u[M], sums[8];
static long counts[P], shared_count;
#ifdef _OPENMP
int omp_get_thread_num(void);
void omp_set_max_active_levels(int);
#else
#define omp_get_thread_num() 0
#define omp_set_max_active_levels(many)
#endif

static double pair(double a, double b) {
    const double d = a - b;
    return d * (0.5 + d * d);
}

/* a solver whose steps are all in one region: each loop reads what the previous loop wrote */
static void steps(int n, int many) {
#pragma omp parallel
    for (int step = 0; step < many; step++) {
#pragma omp for
        for (int i = 0; i < M; i++)
            e[i] = 0;
#pragma omp for schedule(dynamic, 16)
        for (int t = 0; t < n; t++) { // EXPECT: transformed
            const int i = s[t], j = r[t];
            const double force = pair(x[i], x[j]) * w[t];
#pragma omp atomic
            e[i] += force;
#pragma omp atomic update
            e[j] -= force;
        }
#pragma omp for
        for (int i = 0; i < M; i++)
            x[i] += 1e-5 * e[i];
    }
}

/* Loops with `nowait`, directly after other loops that update the same array. */
static void hasty(int n) {
#pragma omp parallel num_threads(5)
    {
#pragma omp for nowait
        for (int t = 0; t < n; t++) // EXPECT: transformed
#pragma omp atomic
            h[s[t]] += w[t];
#pragma omp for nowait
        for (int t = n - 1; t >= 0; t -= 3) { // EXPECT: transformed
            const double v = w[t] * 0.5;
#pragma omp critical(sums)
            {
                u[s[t]] += v;
                u[r[t]] += 2 * v;
            }
        }
#pragma omp barrier
#pragma omp for nowait
        for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
            h[r[t]] -= w[t];
        }
    }
}

/* variables private to the threads, by a clause of the region or the loop, or declared in the region */
static int privates(int n) {
    int t = -7, i = -5, from = 3;
    double v = 0.25, last = 0;
#pragma omp parallel private(v, i) shared(from)
    {
        const double scale = 0.5 * from;
        double f[2];
#pragma omp for lastprivate(last) firstprivate(from)
        for (t = 0; t < n; t++) { // EXPECT: transformed
            i = s[t];
            v = w[t] * scale + from;
            f[0] = v + 1;
            f[1] = v * 0.75;
            last = f[0] - f[1];
#pragma omp atomic
            c[i] += f[0] * f[1];
        }
    }
    case_print("last", &last, sizeof last);
#ifdef _OPENMP
    return t == -7 && i == -5 && from == 3 && v == 0.25;
#else
    return 1;
#endif
}

/* in a function called inside and outside a region; the threadprivate directive above concerns another variable */
double of_thread;
#pragma omp threadprivate(of_thread)
static void orphan(int n, long *restrict to) {
#pragma omp for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        to[s[t] % P]++;
    }
}

/* a reduced scalar in addition, and a value of each thread that is used outside the loop */
static double with_sum(int n) {
    double sum = 0;
    long mine = 0;
#pragma omp parallel firstprivate(mine)
    {
        mine = omp_get_thread_num();
#pragma omp for reduction(+ : sum)
        for (int t = 0; t < n; t++) { // EXPECT: transformed
            const double v = pair(w[t], x[r[t]]);
#pragma omp atomic
            g[s[t]] += v;
            sum += v * w[t];
        }
#pragma omp atomic
        shared_count += mine * 0 + (mine == 0);
    }
    return sum;
}

/* each thread of a team opens a team */
static void half(int n, double *restrict to) {
#pragma omp parallel num_threads(2)
    {
#pragma omp for reduction(+ : to[ : M / 2])
        for (int t = 0; t < n; t++) // EXPECT: transformed
            to[s[t] / 2] += w[t];
    }
}

static void nested(int n) {
#pragma omp parallel for num_threads(2)
    for (int part = 0; part < 2; part++)
        half(n, q + part * (M / 2));
}

int main(void) {
    int kept = 1;
    omp_set_max_active_levels(2);
    case_subscripts(s, N, M);
    case_subscripts(r, N, M);
    case_values(w, N);
    case_values(x, M);
    if (!getenv("CASE_INTEGERS")) // its products are not integers
        steps(N, 6);
    CASE_PRINT(x);
    for (int round = 0; round < 3; round++) {
        hasty(N - round);
        kept &= privates(N);
#pragma omp parallel
        orphan(N - round, counts);
        orphan(N / 2, counts);
        orphan(0, counts);
        sums[round] = with_sum(N);
        nested(6000);
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(c);
    CASE_PRINT(q);
    CASE_PRINT(u);
    CASE_PRINT(sums);
    CASE_PRINT(counts);
    case_print("shared_count", &shared_count, sizeof shared_count);
    return !kept;
}
