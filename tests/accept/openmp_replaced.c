/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: loops run without their directives and yield the sequential program's bits.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
#include "case.h"

enum { N = 6000, M = 700, P = 40 };
struct atom {
    double x, f[3];
    int kind;
};
static int s[N], r[N], k[N];
static double w[N], x[M], h[M], g[M], e[M], c[M], total, largest;
static struct atom atoms[M];
static long counts[P];

static double pair(double a, double b) {
    const double d = a - b;
    return d * (0.5 + d * d);
}

static void pairs(int n) {
#pragma omp parallel for schedule(dynamic, 16)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = s[t], j = r[t];
        const double force = pair(x[i], x[j]) * w[t];
#pragma omp atomic
        h[i] += force;
#pragma omp atomic update
        h[j] -= force;
    }
}

static void histogram(int n, double *restrict to) {
#pragma omp parallel for default(none) shared(n, s, w) reduction(+ : to[:M])
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[s[t]] += w[t] * w[t];
}

static void guarded(int n) {
#pragma omp parallel for schedule(guided) \
    shared(s, w) // continued on a second line
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = w[t] * 0.5;
#pragma omp critical(sums)
        {
            e[s[t]] += v;
            e[r[t]] += 2 * v;
        }
    }
}

/* Private variables keep the values from before the loop. Without OpenMP they do not, and nothing reads them. */
static int privates(int n) {
    int t = -7, from = 3;
    double v = 0.25, f[2], last = 0;
    f[0] = f[1] = 0.5;
#pragma omp parallel for private(v, f) firstprivate(from) lastprivate(last)
    for (t = 0; t < n; t++) { // EXPECT: transformed
        v = w[t] * from;
        f[0] = v + 1;
        f[1] = v * 0.75;
        last = f[0] - f[1];
#pragma omp atomic
        c[s[t]] += f[0] * f[1];
    }
    case_print("last", &last, sizeof last);
#ifdef _OPENMP
    return t == -7 && v == 0.25 && from == 3 && f[0] == 0.5 && f[1] == 0.5;
#else
    return 1;
#endif
}

static void by_three(int n, int threads) {
    struct atom *const to = atoms;
#ifdef _OPENMP
#pragma omp parallel for num_threads(threads) if (parallel : n > threads)
#endif
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        to[s[t]].f[0] += w[t];
#pragma omp atomic
        to[s[t]].f[2] -= w[t] * 0.125;
    }
}

static void with_sums(int n) {
    double sum = 0, most = -1e300;
#pragma omp parallel for reduction(+ : sum, g) reduction(max : most)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = pair(w[t], x[r[t]]);
        g[s[t]] += v;
        sum += v * w[t];
        if (v > most)
            most = v;
    }
    total += sum;
    largest += most;
}

static void counted(size_t n) {
#pragma omp parallel for
    for (size_t t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        counts[k[t]]++;
    }
}

int main(void) {
    int kept = 1;
    case_subscripts(s, N, M);
    case_subscripts(r, N, M);
    case_subscripts(k, N, P);
    case_values(w, N);
    case_values(x, M);
    case_values(e, M);
    for (int round = 0; round < 3; round++) {
        pairs(N);
        histogram(N, round ? g : h);
        guarded(N);
        kept &= privates(N);
        by_three(N, 3);
        with_sums(N);
        counted(N);
    }
    for (int i = 0; i < M; i++)
        x[i] = atoms[i].f[0] + atoms[i].f[2];
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(e);
    CASE_PRINT(c);
    CASE_PRINT(x);
    CASE_PRINT(counts);
    case_print("total", &total, sizeof total);
    case_print("largest", &largest, sizeof largest);
    return !kept;
}
