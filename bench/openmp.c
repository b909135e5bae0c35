/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Loops of OpenMP programs in several shapes, most of them in two spellings: by the clause
 * `reduction` and by `atomic`. The file is compiled unchanged, and as translated by redcc.
 *
 *    openmp SHAPE clause|atomic|critical EXECUTIONS
 *
 * prints the milliseconds of the fastest execution in the second half of the executions, and a hash
 * of all bits of the results. Without arguments, it lists the shapes and their spellings.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MANY = 1000000, FEW = 200000, BINS = 20000, ROWS = 50000, WIDTH = 1000, LARGE = 12500000 };

struct cell {
    double mass, momentum[2];
    int kind;
};

static int *s, *u;           /* [MANY] subscripts */
static double *w, *x, *h;    /* [MANY] numbers; the results */
static int first[ROWS + 1];  /* where the rows of a sparse matrix begin */
static struct cell *cells;   /* [BINS] */
static double total;         /* the result of a scalar reduction */
static long elements = BINS; /* number of elements of h */

/* ---- a histogram ----------------------------------------------------------------------------- */

static void histogram_clause(long n, long m, const int *restrict at, const double *restrict value,
                             double *restrict sum) {
#pragma omp parallel for reduction(+ : sum[:m])
    for (long t = 0; t < n; t++)
        sum[at[t]] += value[t];
}

static void histogram_atomic(long n, const int *restrict at, const double *restrict value,
                             double *restrict sum) {
#pragma omp parallel for
    for (long t = 0; t < n; t++) {
#pragma omp atomic
        sum[at[t]] += value[t];
    }
}

static void histogram_critical(long n, const int *restrict at, const double *restrict value,
                               double *restrict sum) {
#pragma omp parallel for
    for (long t = 0; t < n; t++) {
#pragma omp critical
        sum[at[t]] += value[t];
    }
}

static void by_clause(void) {
    histogram_clause(MANY, elements, s, w, h);
}
static void by_atomic(void) {
    histogram_atomic(MANY, s, w, h);
}
static void by_critical(void) {
    histogram_critical(MANY, s, w, h);
}

/* ---- forces between pairs -------------------------------------------------------------------- */

static void pairs_clause(void) {
    double *f = h;
#pragma omp parallel for reduction(+ : f[:BINS])
    for (int t = 0; t < MANY; t++) {
        const double c = (x[s[t]] - x[u[t]]) * w[t];
        f[s[t]] += c;
        f[u[t]] -= c;
    }
}

static void pairs_atomic(void) {
    double *f = h;
#pragma omp parallel for
    for (int t = 0; t < MANY; t++) {
        const double c = (x[s[t]] - x[u[t]]) * w[t];
#pragma omp atomic
        f[s[t]] += c;
#pragma omp atomic
        f[u[t]] -= c;
    }
}

/* ---- the same, with a force that half of the pairs have -------------------------------------- */

static void cutoff_clause(void) {
    double *f = h;
#pragma omp parallel for reduction(+ : f[:BINS])
    for (int t = 0; t < FEW; t++) {
        const double d = x[s[t]] - x[u[t]];
        if (d > 0) {
            const double c = w[t] * exp(-d * d) / sqrt(d + 1);
            f[s[t]] += c;
            f[u[t]] -= c;
        }
    }
}

static void cutoff_atomic(void) {
    double *f = h;
#pragma omp parallel for
    for (int t = 0; t < FEW; t++) {
        const double d = x[s[t]] - x[u[t]];
        if (d > 0) {
            const double c = w[t] * exp(-d * d) / sqrt(d + 1);
#pragma omp atomic
            f[s[t]] += c;
#pragma omp atomic
            f[u[t]] -= c;
        }
    }
}

/* ---- a loop in a region ---------------------------------------------------------------------- */

static void region_clause(void) {
    double *sum = h;
#pragma omp parallel
    {
#pragma omp for reduction(+ : sum[:BINS])
        for (int t = 0; t < MANY; t++)
            sum[s[t]] += w[t] * x[u[t]];
    }
}

static void region_atomic(void) {
    double *sum = h;
#pragma omp parallel
    {
#pragma omp for
        for (int t = 0; t < MANY; t++) {
#pragma omp atomic
            sum[s[t]] += w[t] * x[u[t]];
        }
    }
}

/* ---- a loop in a function that a region calls ------------------------------------------------ */

static void deposit_clause(void) {
#pragma omp for reduction(+ : h[:BINS])
    for (int t = 0; t < MANY; t++)
        h[s[t]] += 0.5 * w[t];
}

static void deposit_atomic(void) {
#pragma omp for
    for (int t = 0; t < MANY; t++) {
#pragma omp atomic
        h[s[t]] += 0.5 * w[t];
    }
}

static void orphan_clause(void) {
#pragma omp parallel
    deposit_clause();
}

static void orphan_atomic(void) {
#pragma omp parallel
    deposit_atomic();
}

/* ---- rows and columns of an image ------------------------------------------------------------ */

static void collapse_clause(void) {
    double *sum = h;
#pragma omp parallel for collapse(2) reduction(+ : sum[:BINS])
    for (int row = 0; row < MANY / WIDTH; row++)
        for (int column = 0; column < WIDTH; column++)
            sum[s[row * WIDTH + column]] += w[row * WIDTH + column];
}

static void collapse_atomic(void) {
    double *sum = h;
#pragma omp parallel for collapse(2)
    for (int row = 0; row < MANY / WIDTH; row++)
        for (int column = 0; column < WIDTH; column++) {
#pragma omp atomic
            sum[s[row * WIDTH + column]] += w[row * WIDTH + column];
        }
}

/* ---- a scalar, alone and beside updates ------------------------------------------------------ */

static void dot_clause(void) {
    double sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int t = 0; t < MANY; t++)
        sum += w[t] * x[t];
    total += sum;
}

static void energy_clause(void) {
    double *f = h, energy = 0;
#pragma omp parallel for reduction(+ : energy, f[:BINS])
    for (int t = 0; t < MANY; t++) {
        const double d = x[s[t]] - x[u[t]], c = d * w[t];
        energy += c * d;
        f[s[t]] += c;
        f[u[t]] -= c;
    }
    total += energy;
}

static void energy_atomic(void) {
    double *f = h, energy = 0;
#pragma omp parallel for reduction(+ : energy)
    for (int t = 0; t < MANY; t++) {
        const double d = x[s[t]] - x[u[t]], c = d * w[t];
        energy += c * d;
#pragma omp atomic
        f[s[t]] += c;
#pragma omp atomic
        f[u[t]] -= c;
    }
    total += energy;
}

/* ---- records --------------------------------------------------------------------------------- */

static void records_atomic(void) {
#pragma omp parallel for
    for (int t = 0; t < MANY; t++) {
        struct cell *cell = &cells[s[t]];
#pragma omp atomic
        cell->mass += w[t];
#pragma omp atomic
        cell->momentum[0] += w[t] * x[t];
#pragma omp atomic
        cell->momentum[1] -= w[t] * x[u[t]];
    }
}

/* ---- rows of a sparse matrix ----------------------------------------------------------------- */

static void rows_clause(void) {
    double *y = h;
#pragma omp parallel for reduction(+ : y[:BINS])
    for (int row = 0; row < ROWS; row++)
        for (int k = first[row]; k < first[row + 1]; k++)
            y[s[k]] += w[k] * x[row];
}

static void rows_atomic(void) {
    double *y = h;
#pragma omp parallel for
    for (int row = 0; row < ROWS; row++)
        for (int k = first[row]; k < first[row + 1]; k++) {
#pragma omp atomic
            y[s[k]] += w[k] * x[row];
        }
}

/* ---- iterations of different lengths --------------------------------------------------------- */

static void dynamic_clause(void) {
    double *sum = h;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : sum[:BINS])
    for (int t = 0; t < FEW; t++) {
        double value = w[t];
        for (int k = 0; k < t % 64; k++)
            value = value * 0.75 + x[k];
        sum[s[t]] += value;
    }
}

static void dynamic_atomic(void) {
    double *sum = h;
#pragma omp parallel for schedule(dynamic, 64)
    for (int t = 0; t < FEW; t++) {
        double value = w[t];
        for (int k = 0; k < t % 64; k++)
            value = value * 0.75 + x[k];
#pragma omp atomic
        sum[s[t]] += value;
    }
}

/* ---- which shapes there are ------------------------------------------------------------------ */

typedef void kernel(void);
static const struct shape {
    const char *name;
    kernel *clause, *atomic, *critical; /* NULL: the shape has no such spelling */
    long elements;
} shapes[] = {{"histogram", by_clause, by_atomic, by_critical, BINS},
              {"pairs", pairs_clause, pairs_atomic, NULL, BINS},
              {"cutoff", cutoff_clause, cutoff_atomic, NULL, BINS},
              {"region", region_clause, region_atomic, NULL, BINS},
              {"orphan", orphan_clause, orphan_atomic, NULL, BINS},
              {"collapse", collapse_clause, collapse_atomic, NULL, BINS},
              {"dot", dot_clause, NULL, NULL, BINS},
              {"energy", energy_clause, energy_atomic, NULL, BINS},
              {"records", NULL, records_atomic, NULL, BINS},
              {"rows", rows_clause, rows_atomic, NULL, BINS},
              {"dynamic", dynamic_clause, dynamic_atomic, NULL, BINS},
              {"large", by_clause, by_atomic, NULL, LARGE}};
enum { SHAPES = sizeof shapes / sizeof *shapes };

static void list_shapes(void) {
    for (int i = 0; i < SHAPES; i++)
        printf("%s%s%s%s\n", shapes[i].name, shapes[i].clause ? " clause" : "",
               shapes[i].atomic ? " atomic" : "", shapes[i].critical ? " critical" : "");
}

static kernel *kernel_of(const char *name, const char *spelling) {
    for (int i = 0; i < SHAPES; i++)
        if (strcmp(shapes[i].name, name) == 0) {
            elements = shapes[i].elements;
            return strcmp(spelling, "clause") == 0   ? shapes[i].clause
                   : strcmp(spelling, "atomic") == 0 ? shapes[i].atomic
                                                     : shapes[i].critical;
        }
    return NULL;
}

/* ---- the inputs ------------------------------------------------------------------------------ */

static uint32_t next_number(void) {
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 33);
}

static void *array(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory)
        exit(1);
    return memory;
}

static void make_inputs(void) {
    s = array(MANY, sizeof *s), u = array(MANY, sizeof *u);
    w = array(MANY, sizeof *w), x = array(MANY, sizeof *x);
    h = array((size_t)elements, sizeof *h), cells = array(BINS, sizeof *cells);
    for (int t = 0; t < MANY; t++) {
        s[t] = (int)(next_number() % (uint32_t)elements);
        u[t] = (int)(next_number() % BINS);
        w[t] = next_number() * 1e-9;
        x[t] = next_number() * 1e-9;
    }
    for (int row = 0; row < ROWS; row++)
        first[row + 1] = first[row] + row % (2 * (MANY / ROWS));
}

/* ---- measuring ------------------------------------------------------------------------------- */

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static uint64_t hash_of(uint64_t hash, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return hash * 31 + bits;
}

int main(int argc, char **argv) {
    if (argc != 4) {
        list_shapes();
        return argc != 1;
    }
    kernel *const execute = kernel_of(argv[1], argv[2]);
    const long executions = atol(argv[3]);
    if (!execute)
        return 2;
    make_inputs();
    double least = 1e9;
    for (long i = 0; i < executions; i++) {
        const double began = now();
        execute();
        const double seconds = now() - began;
        if (2 * i >= executions && seconds < least)
            least = seconds;
    }
    uint64_t hash = hash_of(0, total);
    for (long i = 0; i < elements; i++)
        hash = hash_of(hash, h[i]);
    for (int i = 0; i < BINS; i++)
        hash = hash_of(hash_of(hash_of(hash, cells[i].mass), cells[i].momentum[0]),
                       cells[i].momentum[1]);
    printf("%.4f %016llx\n", 1e3 * least, (unsigned long long)hash);
    return 0;
}
