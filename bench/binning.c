/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compares in-order binning with the sequential loop and with LOCALWRITE, on loops in redcc's
 * generated form. (In-order binning stores updates as records, sorted by row, before it applies
 * them.) Each execution has new subscripts, so LOCALWRITE inspects each time.
 *
 *     OMP_NUM_THREADS=2 binning ROUNDS KERNEL...       no KERNEL: all
 *
 * Each round executes every variant once, with the same subscripts. Each variant adds to a separate
 * array, which is not cleared; the bits of all arrays are compared after each round. Prints lines
 *
 *     kernel,method,threads,serial_seconds,seconds,speed_up,lowest,highest,best,cpu,extra_percent
 *
 * For method `auto` there is a separate run, in which executions by auto alternate with the
 * sequential loop. Its seconds and speed-up are those of the sums over all executions, including
 * the first.
 *
 * For the other methods, seconds are medians; speed_up, lowest and highest are the median, minimum
 * and maximum of the rounds' speed-ups. best is the least time of the sequential loop divided by
 * the least time of the method. cpu is the sequential loop's processor time divided by that of the
 * method, per thread (for auto, by the total of all threads); other jobs disturb it less than the
 * speed-up. extra_percent is the extra memory relative to the array.
 */
#include "base/bins_kind.h"
#include "binning_data.h"
#include "loop.h"
#include "redcc/bins.h"
#include "settings.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

enum { SETS = 3, MOST_ROUNDS = 101, AUTO_ROUNDS = 3 /* executions by auto in each round */ };

/* ---- the forms of a body --------------------------------------------------------------------- */

#define PLAIN(N, row, contribution)                                                                \
    do {                                                                                           \
        const N##_record e = contribution;                                                         \
        N##_update(&R[row], &e);                                                                   \
    } while (0)
#define GUARDED(N, row, contribution)                                                              \
    do {                                                                                           \
        if (redcc_owns(&own, &R[row]))                                                             \
            PLAIN(N, row, contribution);                                                           \
    } while (0)
#define PUSHED(N, row, contribution)                                                               \
    do {                                                                                           \
        const N##_record e = contribution;                                                         \
        redcc_push(&to_0, &N##_streams[0], row, 0, &e);                                            \
    } while (0)
#define COPIED(N, row, contribution)                                                               \
    do {                                                                                           \
        const N##_record e = contribution;                                                         \
        if (redcc_is_copied(&chunk.bins, &copy[row]))                                              \
            N##_update(&copy[row], &e);                                                            \
    } while (0)
#define TOLD(N, row, contribution) redcc_touch(&worker, 0, &R[row], sizeof *R)

/* BODY(UPDATE) is the loop's body for iteration t of *d. BYTES is the size of a record. EXACT is 1
 * if the order of updates does not affect the result. */
#define KERNEL(N, ROW, BYTES, OPERATION, TYPE, EXACT, BODY)                                        \
    static void N##_apply(const redcc_applied *applied) {                                          \
        ROW *const rows = applied->rows[0];                                                        \
        const N##_record *const records = applied->records;                                        \
        for (redcc_size n = 0; n < applied->count; n++) {                                          \
            REDCC_APPLY_AHEAD(applied, n, rows, 0);                                                \
            N##_update(&rows[applied->place[n]], &records[n]);                                     \
        }                                                                                          \
    }                                                                                              \
    static const redcc_array N##_arrays[] = {{"R", OPERATION, TYPE, sizeof(ROW), sizeof(ROW), 0}}; \
    static const redcc_source N##_sources[] = {{"data", 1}};                                       \
    static const redcc_stream N##_streams[] = {                                                    \
        {N##_apply, 1, {0}, {sizeof(ROW)}, BYTES, 0, EXACT}};                                      \
    static redcc_binned N##_loop = {{"binning.c", __LINE__, #N, REDCC_ORDER_SERIAL, REDCC_BINNED,  \
                                     1, N##_arrays, 1, N##_sources, 0, 0},                         \
                                    1,                                                             \
                                    0,                                                             \
                                    N##_streams};                                                  \
    static __attribute__((noinline)) void N##_sequential(const struct data *its, void *array) {    \
        const struct data mine = *its, *const d = &mine;                                           \
        ROW *const R = array;                                                                      \
        for (redcc_int t = 0; t < d->trip; t++)                                                    \
            BODY(PLAIN)                                                                            \
    }                                                                                              \
    static __attribute__((noinline)) void N##_execute(redcc_worker *given, struct data mine) {     \
        const struct data *const d = &mine;                                                        \
        redcc_worker worker = *given;                                                              \
        while (redcc_next(&worker)) {                                                              \
            ROW *const R = worker.base[0];                                                         \
            const redcc_owner own = worker.owner[0];                                               \
            for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {         \
                redcc_int t = worker.origin + run->begin;                                          \
                const redcc_int end = t + run->count_and_check / 2;                                \
                if (!(run->count_and_check & 1))                                                   \
                    for (; t < end; t++)                                                           \
                        BODY(PLAIN)                                                                \
                else                                                                               \
                    for (; t < end; t++)                                                           \
                        BODY(GUARDED)                                                              \
            }                                                                                      \
        }                                                                                          \
    }                                                                                              \
    static bool N##_parallel(const struct data *its, void *array, int threads) {                   \
        void *const bases[] = {array};                                                             \
        const redcc_extent known[] = {{(const char *)its, (const char *)(its + 1)}};               \
        redcc_call call;                                                                           \
        if (redcc_enter(&call, &N##_loop.loop, its->trip, bases, known, NULL, threads, 0)) {       \
            _Pragma("omp parallel num_threads(call.threads)") {                                    \
                redcc_worker worker;                                                               \
                redcc_bins bins[1];                                                                \
                ROW *const R = array;                                                              \
                const struct data mine = *its, *const d = &mine; /* firstprivate */                \
                redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());           \
                while (redcc_inspect(&worker))                                                     \
                    for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {        \
                        BODY(TOLD)                                                                 \
                        redcc_iteration_done(&worker);                                             \
                    }                                                                              \
                while (redcc_bins_next(&worker, bins, NULL)) {                                     \
                    const redcc_bins to_0 = bins[0];                                               \
                    const redcc_int last = worker.last;                                            \
                    redcc_int t = worker.first;                                                    \
                    if (EXACT && REDCC_ARE_COPIED(&to_0)) {                                        \
                        ROW *const copy = redcc_copy_base(&to_0, &N##_streams[0], 0);              \
                        redcc_chunk_bins chunk = redcc_chunk_bins_of(&to_0, 0, sizeof(ROW));       \
                        for (; t < last; t++)                                                      \
                            BODY(COPIED)                                                           \
                        redcc_report_lacking(&chunk, sizeof(ROW));                                 \
                    } else                                                                         \
                        for (; t < last; t++)                                                      \
                            BODY(PUSHED)                                                           \
                }                                                                                  \
                N##_execute(&worker, mine);                                                        \
            }                                                                                      \
        }                                                                                          \
        return redcc_leave(&call);                                                                 \
    }

/* ---- kernels --------------------------------------------------------------------------------- */

typedef double doubles_record;
static inline void doubles_update(double *r, const double *e) {
    *r += *e;
}
#define DOUBLES(UPDATE) UPDATE(doubles, d->k[t], d->value[t]);
KERNEL(doubles, double, sizeof(double), REDCC_SUM, REDCC_DOUBLE, 0, DOUBLES)

typedef float floats_record;
static inline void floats_update(float *r, const float *e) {
    *r += *e;
}
#define FLOATS(UPDATE) UPDATE(floats, d->k[t], d->part[t]);
KERNEL(floats, float, sizeof(float), REDCC_SUM, REDCC_FLOAT, 0, FLOATS)

typedef int counts_record; /* a record of a count has no value; a type is needed */
static inline void counts_update(int *r, const int *e) {
    (void)e;
    (*r)++;
}
#define COUNTS(UPDATE) UPDATE(counts, d->k[t], 0);
KERNEL(counts, int, 0, REDCC_SUM, REDCC_INT32, 1, COUNTS)

/* Cloud in cell: a particle's charge goes to the corners of its cell. */
typedef double charge_record;
static inline void charge_update(double *r, const double *e) {
    *r += *e;
}
#define CORNER(UPDATE, dx, dy, dz)                                                                 \
    UPDATE(charge, cell + (dx) + side * ((dy) + side * (dz)),                                      \
           (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz));
#define CHARGE(UPDATE)                                                                             \
    {                                                                                              \
        const double *const p = d->x[t];                                                           \
        const int ix = (int)p[0], iy = (int)p[1], iz = (int)p[2];                                  \
        const double fx = p[0] - ix, fy = p[1] - iy, fz = p[2] - iz;                               \
        const int side = d->side, cell = ix + side * (iy + side * iz);                             \
        (void)fx, (void)fy, (void)fz;                                                              \
        CORNER(UPDATE, 0, 0, 0)                                                                    \
        CORNER(UPDATE, 1, 0, 0)                                                                    \
        CORNER(UPDATE, 0, 1, 0)                                                                    \
        CORNER(UPDATE, 1, 1, 0)                                                                    \
        CORNER(UPDATE, 0, 0, 1)                                                                    \
        CORNER(UPDATE, 1, 0, 1)                                                                    \
        CORNER(UPDATE, 0, 1, 1)                                                                    \
        CORNER(UPDATE, 1, 1, 1)                                                                    \
    }
KERNEL(charge, double, sizeof(double), REDCC_SUM, REDCC_DOUBLE, 0, CHARGE)

/* Forces by half neighbour lists: each pair is listed once. */
typedef struct {
    double c[3];
} forces_record;
static inline void forces_update(forces_record *r, const forces_record *e) {
    for (int c = 0; c < 3; c++)
        r->c[c] += e->c[c];
}
static inline forces_record force(const double *a, const double *b) {
    const double v[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    const double q = 1 / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 0.01), s = q * q * q;
    const double f = s * (s - 0.5) * q;
    return (forces_record){{f * v[0], f * v[1], f * v[2]}};
}
#define FORCES(UPDATE)                                                                             \
    {                                                                                              \
        forces_record all = {{0, 0, 0}};                                                           \
        for (int n = d->start[t]; n < d->start[t + 1]; n++) {                                      \
            const forces_record f = force(d->x[t], d->x[d->k[n]]);                                 \
            all.c[0] += f.c[0], all.c[1] += f.c[1], all.c[2] += f.c[2];                            \
            const forces_record back = {{-f.c[0], -f.c[1], -f.c[2]}};                              \
            (void)back;                                                                            \
            UPDATE(forces, d->k[n], back);                                                         \
        }                                                                                          \
        UPDATE(forces, t, all);                                                                    \
    }
KERNEL(forces, forces_record, sizeof(forces_record), REDCC_SUM, REDCC_OTHER_TYPE, 0, FORCES)

/* ---- measuring ------------------------------------------------------------------------------- */

struct kernel {
    const char *name;
    size_t rows, row; /* rows: number of rows (for a grid, cells per side); row: bytes of a row */
    enum pattern pattern;
    int most_threads; /* 0: no limit */
    void (*sequential)(const struct data *, void *);
    bool (*parallel)(const struct data *, void *, int);
    redcc_binned *loop;
};

#define OF(N, ROW) sizeof(ROW), RANDOM, 0, N##_sequential, N##_parallel, &N##_loop
#define ORDERED(N, ROW, PATTERN) sizeof(ROW), PATTERN, 0, N##_sequential, N##_parallel, &N##_loop
static const struct kernel kernels[] = {
    {"doubles-16M", (size_t)16 * MILLION, OF(doubles, double)},
    {"floats-16M", (size_t)16 * MILLION, OF(floats, float)},
    {"counters-16M", (size_t)16 * MILLION, OF(counts, int)},
    {"charge-128^3", 128, OF(charge, double)},
    {"charge-256^3", 256, OF(charge, double)},
    {"half-neighbours-shuffled", 0, OF(forces, forces_record)},
    {"histogram-4096", 4096, OF(counts, int)},
    {"doubles-16M-sorted", (size_t)16 * MILLION, ORDERED(doubles, double, SORTED)},
    {"doubles-16M-banded", (size_t)16 * MILLION, ORDERED(doubles, double, BANDED)},
    {"doubles-64k", 65536, OF(doubles, double)},
    {"doubles-1M", MILLION, OF(doubles, double)},
    {"doubles-64M", (size_t)64 * MILLION, OF(doubles, double)},
    {"floats-16M-one-thread", (size_t)16 * MILLION, sizeof(float), RANDOM, 1, floats_sequential,
     floats_parallel, &floats_loop},
};
enum { KERNELS = sizeof kernels / sizeof *kernels };

static int kind = BINS_EITHER; /* REDCC_METHOD=binning:records or binning:copies overrides it */

struct variant {
    const char *name;
    const struct method *method; /* NULL: the sequential loop or, with is_auto, auto's choice */
    bool is_auto;
    char *array;
    double wall[AUTO_ROUNDS * MOST_ROUNDS], cpu[AUTO_ROUNDS * MOST_ROUNDS];
    size_t extra; /* extra memory, bytes */
};

static double clock_of(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void execute(const struct kernel *kernel, struct variant *variant, const struct data *d,
                    int threads, int round) {
    struct settings *settings = (struct settings *)redcc_settings();
    const double wall = clock_of(CLOCK_MONOTONIC), cpu = clock_of(CLOCK_PROCESS_CPUTIME_ID);
    settings->method = variant->method;
    settings->parameter = kind;
    if (!variant->method && !variant->is_auto)
        kernel->sequential(d, variant->array);
    else if (!kernel->parallel(d, variant->array, threads)) {
        kernel->sequential(d, variant->array);
        redcc_sequential_done(&kernel->loop->loop);
    }
    const struct loop_state *state = kernel->loop->loop.state;
    if (variant->method == &redcc_method_binning) {
        if (state->binning.bytes > variant->extra)
            variant->extra = state->binning.bytes;
        variant->name = state->binning.copies.count ? "binning:copies" : "binning:records";
    }
    variant->wall[round] = clock_of(CLOCK_MONOTONIC) - wall;
    variant->cpu[round] = (clock_of(CLOCK_PROCESS_CPUTIME_ID) - cpu) /
                          (variant->method ? threads : 1); /* auto: the total time of all threads */
}

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(const double *values_of, int count) {
    double sorted[MOST_ROUNDS];
    memcpy(sorted, values_of, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, ascending);
    return count % 2 ? sorted[count / 2] : (sorted[count / 2 - 1] + sorted[count / 2]) / 2;
}

static double extreme(const double *values_of, int count, int sign) {
    double found = values_of[0];
    for (int i = 1; i < count; i++)
        found = sign * values_of[i] > sign * found ? values_of[i] : found;
    return found;
}

/* Prints the figures of all rounds but the first, which causes page faults. */
static void print(const struct kernel *kernel, const struct variant *serial,
                  const struct variant *variant, int threads, int rounds, size_t bytes) {
    double ratio[MOST_ROUNDS];
    const int count = rounds - 1;
    for (int r = 0; r < count; r++)
        ratio[r] = serial->wall[r + 1] / variant->wall[r + 1];
    printf("%s,%s,%d,%.4g,%.4g,%.3f,%.3f,%.3f,%.3f,%.3f,%.1f\n", kernel->name, variant->name,
           threads, median(serial->wall + 1, count), median(variant->wall + 1, count),
           median(ratio, count), extreme(ratio, count, -1), extreme(ratio, count, 1),
           extreme(serial->wall + 1, count, -1) / extreme(variant->wall + 1, count, -1),
           median(serial->cpu + 1, count) / median(variant->cpu + 1, count),
           100 * (double)variant->extra / (double)bytes);
    fflush(stdout);
}

static double sum(const double *values_of, int count) {
    double all = 0;
    for (int i = 0; i < count; i++)
        all += values_of[i];
    return all;
}

/* Executes the loop by auto and sequentially, alternately, beginning with auto's first execution.
 * Returns whether the bits of the results differ. */
static bool measure_auto(const struct kernel *kernel, const struct data *sets, int count,
                         int threads) {
    static struct variant serial, by_auto;
    const size_t bytes = sets[0].rows * kernel->row;
    serial = (struct variant){.array = calloc(1, bytes)};
    by_auto = (struct variant){.is_auto = true, .array = calloc(1, bytes)};
    redcc_loop_forget(&kernel->loop->loop);
    memset(serial.array, 0, bytes); /* page faults happen before the measurement */
    memset(by_auto.array, 0, bytes);
    for (int n = 0; n < count; n++) {
        execute(kernel, &serial, &sets[n % SETS], threads, n);
        execute(kernel, &by_auto, &sets[n % SETS], threads, n);
    }
    const bool differ = memcmp(serial.array, by_auto.array, bytes) != 0;
    double ratio[AUTO_ROUNDS * MOST_ROUNDS] = {0};
    for (int n = 0; n < count; n++)
        ratio[n] = serial.wall[n] / by_auto.wall[n];
    const double wall = sum(serial.wall, count), its = sum(by_auto.wall, count);
    printf("%s,auto,%d,%.4g,%.4g,%.3f,%.3f,%.3f,%.3f,%.3f,\n", kernel->name, threads, wall, its,
           wall / its, extreme(ratio, count, -1), extreme(ratio, count, 1),
           extreme(serial.wall, count, -1) / extreme(by_auto.wall, count, -1),
           sum(serial.cpu, count) / sum(by_auto.cpu, count));
    fflush(stdout);
    free(serial.array);
    free(by_auto.array);
    return differ;
}

static void make(const struct kernel *kernel, struct data *d) {
    if (kernel->loop == &charge_loop)
        make_particles(d, (int)kernel->rows);
    else if (kernel->loop == &forces_loop)
        make_neighbours(d);
    else
        make_subscripts(d, kernel->pattern, kernel->rows);
}

static int measure(const struct kernel *kernel, int rounds, int threads) {
    struct variant variants[] = {{.name = "serial"},
                                 {.name = "binning", .method = &redcc_method_binning},
                                 {.name = "localwrite", .method = &redcc_method_localwrite}};
    const int count = threads > 1 ? 3 : 2;
    struct data sets[SETS];
    for (int s = 0; s < SETS; s++)
        make(kernel, &sets[s]);
    const size_t bytes = sets[0].rows * kernel->row;
    int bad = 0;
    for (int c = 0; c < count; c++)
        variants[c].array = calloc(1, bytes);
    for (int round = 0; round < rounds; round++) {
        for (int c = 0; c < count; c++)
            execute(kernel, &variants[c], &sets[round % SETS], threads, round);
        for (int c = 1; c < count; c++)
            bad |= memcmp(variants[0].array, variants[c].array, bytes) != 0;
    }
    for (int c = 1; c < count; c++)
        print(kernel, &variants[0], &variants[c], threads, rounds, bytes);
    bad |= measure_auto(kernel, sets, AUTO_ROUNDS * rounds, threads);
    if (bad)
        fprintf(stderr, "binning: %s: other bits\n", kernel->name);
    redcc_loop_forget(&kernel->loop->loop);
    for (int c = 0; c < count; c++)
        free(variants[c].array);
    for (int s = 0; s < SETS; s++)
        free_data(&sets[s]);
    return bad;
}

static bool is_wanted(const char *name, int count, char **names) {
    bool wanted = count == 0;
    for (int i = 0; i < count; i++)
        wanted |= strcmp(name, names[i]) == 0;
    return wanted;
}

int main(int count, char **arguments) {
    const int rounds = count > 1 ? atoi(arguments[1]) : 12;
    int bad = 0;
    if (redcc_settings()->method == &redcc_method_binning)
        kind = redcc_settings()->parameter;
    if (rounds < 2 || rounds > MOST_ROUNDS) {
        fprintf(stderr, "binning: 2 to %d rounds\n", MOST_ROUNDS);
        return 2;
    }
    for (int n = 0; n < KERNELS; n++) {
        const int most = kernels[n].most_threads, threads = omp_get_max_threads();
        if (is_wanted(kernels[n].name, count > 2 ? count - 2 : 0, arguments + 2))
            bad |= measure(&kernels[n], rounds, most && most < threads ? most : threads);
    }
    return bad;
}
