/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: scalars that a directive reduces are summed in fixed blocks, with the same bits at every
// number of threads. With REDCC_ORDER=serial the order is sequential. A conjugate gradient solver and other loops.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: blocks
// MAY-RUN-SERIALLY: one loop has no iterations
#include "case.h"
#include <stdbool.h>

enum { N = 3000, MOST = 7 };
#define THREADS 5
#define CHUNK (64)
#define LEAST 10
static int begin[N + 1], column[N * MOST];
static double value[N * MOST], x[N], b[N], r[N], p[N], q[N], w[N];
static int k[N];
double outside = 0.5;
static double little; /* 0 if all values are integers */

/* ---- a solver: dot products, a product with a sparse matrix stored by columns, atomic updates */

static double dot(int n, const double *restrict u, const double *restrict v) {
    double sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int i = 0; i < n; i++) // EXPECT: transformed
        sum += u[i] * v[i];
    return sum;
}

static void product(int n, const double *in, double *restrict out) {
#pragma omp parallel for
    for (int i = 0; i < n; i++)
        out[i] = 0;
#pragma omp parallel for schedule(dynamic, 16)
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++)
#pragma omp atomic
            out[column[j]] += value[j] * in[i];
}

static int solve(int n) {
    int steps = 0;
    for (int i = 0; i < n; i++) {
        x[i] = 0;
        r[i] = p[i] = b[i];
    }
    double rho = dot(n, r, r);
    const double enough = 1e-20 * rho;
    while (rho > enough && steps < 200) {
        product(n, p, q);
        const double alpha = rho / dot(n, p, q);
        double next = 0;
#pragma omp parallel for reduction(+ : next)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            x[i] += alpha * p[i];
            r[i] -= alpha * q[i];
            next += r[i] * r[i];
        }
        const double beta = next / rho;
        rho = next;
#pragma omp parallel for
        for (int i = 0; i < n; i++)
            p[i] = r[i] + beta * p[i];
        steps++;
    }
    case_print("rho", &rho, sizeof rho);
    return steps;
}

/* fills a diagonally dominant, symmetric matrix: each pair (i, j) is entered in both columns */
static void make_matrix(void) {
    int n = 0;
    for (int i = 0; i < N; i++) {
        begin[i] = n;
        column[n] = i;
        value[n++] = 9 + 0.001 * i;
        for (int step = 1; step < 300; step *= 17) {
            if (i + step < N)
                column[n] = i + step, value[n++] = -0.75;
            if (i >= step)
                column[n] = i - step, value[n++] = -0.75;
        }
    }
    begin[N] = n;
}

/* ---- forms of loops ------------------------------------------------------------------------ */

typedef float real;

static void operators(int n) {
    double least = 1e300, most = -1e300, times = 1;
    long count = 0;
    unsigned bits = 0, common = 0xffffu, odd = 5;
    int all = 1, any = 0;
    bool is_any = false;
    signed char low = 100;
    int above = N;
    real single = 0.5f;
#pragma omp parallel for reduction(min : least, low, above) reduction(max : most) reduction(* : times) \
    reduction(- : count) reduction(| : bits) reduction(& : common) reduction(^ : odd) \
    reduction(&& : all) reduction(|| : any, is_any) reduction(+ : single) /* on three lines */
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (w[i] < least)
            least = w[i];
        most = w[i] > most ? w[i] : most;
        times *= 1 + w[i] * little;
        count -= k[i];
        bits |= 1u << (k[i] & 7);
        common &= 0xfff0u | (unsigned)k[i];
        odd ^= (unsigned)k[i] * 77u;
        all = all && k[i] >= 0;
        any = any || k[i] == 3;
        is_any = is_any || k[i] > N;
        low = (signed char)(k[i] - 50 < low ? k[i] % 50 - 50 : low);
        above = k[i] + 7 < above ? k[i] + 7 : above;
        single += (real)w[i];
    }
    case_print("least", &least, sizeof least);
    case_print("most", &most, sizeof most);
    case_print("times", &times, sizeof times);
    case_print("count", &count, sizeof count);
    case_print("bits", &bits, sizeof bits);
    case_print("common", &common, sizeof common);
    case_print("odd", &odd, sizeof odd);
    case_print("all", &all, sizeof all);
    case_print("any", &any, sizeof any);
    case_print("is_any", &is_any, sizeof is_any);
    case_print("low", &low, sizeof low);
    case_print("above", &above, sizeof above);
    case_print("single", &single, sizeof single);
}

/* counters of several kinds, and their values after the loop */
static int counters(int n) {
    int i = -7, j;
    double sum = 0.25, last = 0, mine;
#pragma omp parallel for reduction(+ : sum) private(mine) firstprivate(n) lastprivate(last) schedule(guided)
    for (i = n - 1; i >= 3; i -= 3) { // EXPECT: transformed
        mine = w[i] * 0.5;
        if (k[i] % 5 == 0)
            continue;
        sum += mine;
        last = mine;
    }
#pragma omp parallel for reduction(+ : sum) lastprivate(j) num_threads(THREADS) schedule(static, CHUNK) if (n > LEAST)
    for (j = 1; j <= n - 2; j++) // EXPECT: transformed
        sum += w[j] * w[j + 1];
    size_t length = (size_t)n;
#pragma omp parallel for reduction(+ : sum, outside) default(none) shared(w, k, length)
    for (size_t u = 5; length > u; u += 2) { // EXPECT: transformed
        sum += w[u];
        outside += w[u] * k[u];
    }
#pragma omp parallel for reduction(+ : sum)
    for (short c = 200; c != 2500; c++) // EXPECT: transformed
        sum += w[c];
#pragma omp parallel for reduction(+ : sum)
    for (long from = n; from < 4; from++) // EXPECT: transformed
        sum += 1e9;
#pragma omp parallel for reduction(+ : sum)
    for (int once = n; once <= n; once++) // EXPECT: transformed
        sum += 3;
    case_print("sum", &sum, sizeof sum);
    case_print("last", &last, sizeof last);
    case_print("outside", &outside, sizeof outside);
#ifdef _OPENMP
    return i == -7 && j == n - 1;
#else
    return i < 3 && j == n - 1;
#endif
}

/* No iteration: `lastprivate` sets the counter as the loop without a directive does; OpenMP leaves it unspecified. */
static int never(int n) {
    int i = -7, first = n;
    double sum = 0.25, last = 5;
#pragma omp parallel for reduction(+ : sum) lastprivate(i, last)
    for (i = first; i < 3; i++) { // EXPECT: transformed
        last = w[i];
        sum += last;
    }
    return sum == 0.25 && (getenv("CASE_INTEGERS") || (last == 5 && i == n)); /* OpenMP leaves them unspecified */
}

/* a directive under a condition, by the operator _Pragma, in a branch; iterations with inner loops */
static double others(int n, int kind) {
    double sum = 0;
    if (kind == 1)
#ifdef _OPENMP
#pragma omp parallel for reduction(+ : sum)
#endif
        for (int i = 0; i < n; i++) // EXPECT: transformed
            sum += w[i] * 3;
    else if (kind == 2)
        _Pragma("omp parallel for reduction(+ : sum)")
        for (int i = 0; i < n / 16; i++) { // EXPECT: transformed
            double row = 0;
            for (int j = 0; j < 16; j++)
                row += w[16 * i + j] * w[j];
#pragma omp atomic
            q[k[i]] += 1;
            sum += row * row;
        }
    else
        sum = 1;
    return sum;
}

int main(void) {
    case_values(b, N);
    case_values(w, N);
    case_subscripts(k, N, N);
    make_matrix();
    little = getenv("CASE_INTEGERS") ? 0 : 1e-3;
    int steps = little > 0 ? solve(N) : 0;
    case_print("steps", &steps, sizeof steps);
    CASE_PRINT(x);
    int kept = 1;
    for (int round = 0; round < 3; round++) {
        operators(N - 7 * round);
        kept &= counters(N - round) && never(3 + round);
    }
    double sums = others(N, 0) + others(N, 1) + 3 * others(N, 2) + others(0, 1);
    case_print("sums", &sums, sizeof sums);
    /* each thread of a team calls `dot` */
    static double apart[8];
#pragma omp parallel for
    for (int i = 0; i < 8; i++)
        apart[i] = dot(N - i, w, b);
    CASE_PRINT(apart);
    return !kept;
}
