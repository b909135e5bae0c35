/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Compiled with OpenMP: updates that `atomic` or `critical` protects are made in a fixed order, on private copies, with
// the same bits at every number of threads and in every run. With REDCC_ORDER=serial it is the sequential order.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: 32 41 53 77 90 102 113 126 138 151 163 175 185
// THREADS: 1 2 3 7 16 33
// MAY-RUN-SERIALLY: three loops read what they update, another is too short
#include "case.h"

enum { N = 24000, M = 300, LARGE = 9000 };
static int s[N], r[N], k[N], far[N], same[N];
static double w[N], x[M], g[M], h[M], e[M], most[M], product[M], grown[LARGE], team[M], chain[N], image[M], little;
static float grey[M];
static unsigned bits[M];
static long counts[M];

static int many = 1; /* the condition of a directive's `if` clause */
int omp_get_max_threads(void);

static double pair(double a, double b) {
    const double d = a - b;
    return d * (0.5 + d * d);
}

/* Called for arrays of several sizes, which lie between other data: what earlier executions have found may be more
 * than this array has. */
static void histogram(int n, const int *restrict at, const double *restrict v, double *restrict to) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        to[at[t]] += v[t];
    }
}

/* both ends of each pair */
static void pairs(int n) {
#pragma omp parallel for schedule(dynamic, 16) if (many)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double f = pair(x[s[t]], x[r[t]]) * w[t];
#pragma omp atomic
        g[s[t]] += f;
#pragma omp atomic
        g[r[t]] -= f;
    }
}

/* arrays of different types, and two operators */
static void two(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp critical
        {
            grey[s[t]] += (float)w[t];
            e[r[t]] += w[t] * w[t];
            product[k[t]] *= 1 + w[t] * little;
        }
    }
}

/* The order counts: which of two equal values is greater? */
static void extremes(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp critical(extremes)
        {
            most[s[t]] = w[t] > most[s[t]] ? w[t] : most[s[t]];
        }
    }
}

/* integers */
static void integers(int n) {
#pragma omp parallel for num_threads(5)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        counts[s[t]] += k[t];
#pragma omp atomic
        bits[r[t]] ^= (unsigned)k[t] << (t & 15);
    }
}

/* private variables and inner loops: half of the iterations are long */
static void heavy(int n, double *restrict to) {
    double v;
    int j;
#pragma omp parallel for private(v, j)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        v = 0.25;
        for (j = 0; t % 2 && j < 12; j++)
            v += pair(x[(s[t] + j) % M], w[t]);
#pragma omp atomic
        to[s[t]] += v;
    }
}

/* Few of its rows are known after the first sample. */
static void outliers(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        grown[far[t]] += w[t] * 0.75;
    }
}

/* The team of the enclosing region executes the loop. */
static void of_team(int n, double *restrict to) {
#pragma omp parallel
    {
#pragma omp for
        for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
            to[s[t]] -= w[t] * 0.25;
        }
#pragma omp for
        for (int i = 0; i < M; i++)
            to[i] *= 0.5;
    }
}

/* rows and columns */
static void nest(int rows) {
#pragma omp parallel for collapse(2)
    for (int y = 0; y < rows; y++) // EXPECT: transformed
        for (int c = 0; c < 40; c++) {
#pragma omp atomic
            image[s[y * 40 + c]] += w[y * 40 + c] * 1.5;
        }
}

/* scalars in a clause, beside updates of arrays that a clause or `atomic` protects */
static double energy_atomic(int n) {
    double energy = 0.5;
    float lost = 0;
#pragma omp parallel for reduction(+ : energy) reduction(- : lost)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = w[t] * w[t];
        energy += v;
        lost -= (float)w[t];
#pragma omp atomic
        h[s[t]] += v;
    }
    return energy - lost;
}

static double energy_clause(int n) {
    double energy = 0.5;
#pragma omp parallel for reduction(+ : energy, g[:M])
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = w[t] * w[t];
        g[s[t]] += v;
        energy += v;
    }
    return energy;
}

/* A scalar that only some iterations add to: its operands are added in the order of the loop. */
static double some(int n) {
    double sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (w[t] > 0.25)
            sum += w[t];
#pragma omp atomic
        e[s[t]] -= w[t];
    }
    return sum;
}

/* Long iterations: few of them update many elements. */
static void by_rows(int rows, const int *restrict begin, double *restrict to) {
#pragma omp parallel for
    for (int y = 0; y < rows; y++) // EXPECT: transformed
        for (int c = begin[y]; c < begin[y + 1]; c++) {
#pragma omp atomic
            to[s[c]] += w[c] * 0.25;
        }
}

/* Each iteration reads, before its update, an element that only this iteration updates. */
static void own(int n, const int *at, const double *v, double *to) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        to[at[t]] += v[at[t]] * 0.5;
    }
}

/* The same, after its update: no copies, but where nothing overlaps. */
static void own_later(int n, const int *at, const double *v, double *to, double *sum) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double f = 0;
        for (int j = 0; j < 4; j++)
            f += pair(w[t], x[(s[t] + j) % M]);
#pragma omp atomic
        to[at[t]] += f;
#pragma omp atomic
        sum[s[t]] += v[at[t]];
    }
}

/* Each iteration reads only what it updates itself: no race, but no copies either. */
static void overlapping(int n, const int *at, const double *v, double *to) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        to[at[t]] += v[t] * pair(w[t], 0.5);
    }
}

/* `critical` protects the reads, too: other iterations update what they read. */
static void limited(int n, const int *at, const int *from, const double *v, double *to) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp critical
        to[at[t]] += v[from[t]] < 5 ? 1 : 0;
    }
}

/* Rows read consecutive elements. Those of the last row are partly the elements that it updates: each of these updates
 * is read by the row's next step. */
static void rows_of(int rows, const int *begin, const int *at, const double *v, double *to) {
#pragma omp parallel for
    for (int y = 0; y < rows; y++) // EXPECT: transformed
        for (int c = begin[y]; c < begin[y + 1]; c++) {
#pragma omp atomic
            to[at[c]] += v[c] * 0.5;
        }
}

enum { READ = 12000, TAIL = 9, LENGTH = 20 };
static int last_row_is_read(void) {
    static double all[READ + M], expected[READ + M];
    static int at[READ + TAIL], begin[READ / LENGTH + 1];
    for (int y = 0; y < READ / LENGTH; y++)
        begin[y] = y * LENGTH;
    begin[READ / LENGTH] = READ + TAIL;
    case_values(all, READ + M);
    for (int c = 0; c < READ + TAIL; c++)
        at[c] = c < READ ? 50 + c % 200 : c - READ + 1;
    for (int i = 0; i < READ + M; i++)
        expected[i] = all[i];
    for (int c = READ - LENGTH; c < READ + TAIL; c++)
        expected[READ + at[c]] += expected[c] * 0.5;
    rows_of(READ / LENGTH, begin, at, all, all + READ);
    for (int i = READ; i <= READ + TAIL; i++)
        if (all[i] != expected[i])
            return 0;
    return 1;
}

int main(void) {
    static double between[3 * M], counted[M];
    static int begin[601];
    double total = 0;
    case_subscripts(s, N, M);
    case_subscripts(r, N, M);
    case_subscripts(k, N, M / 3);
    case_values(w, N);
    case_values(x, M);
    case_values(chain, N);
    for (int i = 0; i < 3 * M; i++)
        between[i] = -0.0;
    for (int i = 0; i < M; i++)
        product[i] = 1;
    for (int t = 0; t < N; t++) {
        far[t] = t % 1999 == 1998 ? LARGE - 1 - t % 7 : s[t];
        same[t] = t;
    }
    for (int y = 0; y < 600; y++)
        begin[y + 1] = begin[y] + y % 40;
    little = getenv("CASE_INTEGERS") ? 0 : 0.001;
#ifdef _OPENMP
    many = omp_get_max_threads() > 1;
#endif
    for (int round = 0; round < 4; round++) {
        const int n = round == 3 ? N : N / 2 + 7 * round;
        histogram(1000 * round, s, w, e);
        histogram(n, s, w, h);
        histogram(n, k, w, between + M);
        histogram(n, s, w, grown + 100);
        pairs(n);
        two(n);
        extremes(n);
        integers(n);
        heavy(n / 20, h);
        outliers(n);
        of_team(n, team);
        nest(n / 40);
        total += energy_atomic(n) + energy_clause(n) + some(n);
        by_rows(600, begin, image);
        own(n, same, chain, chain);
        own_later(n, same, chain, chain, h);
        overlapping(n, same, chain, chain);
        limited(n, s, s, counted, counted);
    }
    for (int i = 0; i < M; i++)
        if (counted[i] != 5)
            return 1;
    for (int round = 0; round < 3; round++)
        if (!last_row_is_read())
            return 2;
    CASE_PRINT(h);
    CASE_PRINT(between);
    CASE_PRINT(grown);
    CASE_PRINT(g);
    CASE_PRINT(grey);
    CASE_PRINT(e);
    CASE_PRINT(most);
    CASE_PRINT(product);
    CASE_PRINT(counts);
    CASE_PRINT(bits);
    CASE_PRINT(team);
    CASE_PRINT(image);
    CASE_PRINT(chain);
    case_print("total", &total, sizeof total);
    return 0;
}
