/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compares the runtime's methods with hand-written alternatives, on two loops in redcc's generated
 * form. The mesh has the size of the paper's (217k nodes, 434k triangles; docs/paper.md):
 *    heavy  over triangles: each adds 9 doubles to b and 81 to a block matrix
 *    light  over edges: each adds 6 doubles to b
 *
 *    REDCC_METHOD=localwrite OMP_NUM_THREADS=2 loops heavy|light sorted|shuffled [WARM [others]]
 *
 * First, executions run for WARM seconds (default 2, so that `auto` ends its trials). Then rounds
 * run for twice that time, but at least 9 rounds. In a round each variant is executed twice in a
 * row and the second execution is timed, so that no variant starts with the caches, or the sleeping
 * threads, that another left. Finally, 9 executions are timed, each with an inspection. Prints
 * lines
 *
 *    loop,mesh,method,threads,order,serial_seconds,seconds,speed_up,lowest,highest,
 *    inspection_of_serial,extra_percent,replication,modelled
 *
 * seconds are medians. speed_up, lowest and highest are the median, minimum and maximum of the
 * rounds' speed-ups (from 20 rounds on, the 5th and 95th percentiles). inspection_of_serial is the
 * time of an inspection divided by that of the sequential loop. extra_percent is the extra memory
 * relative to the reduction arrays. replication is the number of iterations executed, including
 * those that several threads repeat, per iteration of the loop. modelled is the number of
 * iterations divided by the makespan of the schedule, including waits (runtime/src/plan/length.h).
 *
 * With `others`, also prints lines for OpenMP's atomics, its reduction of array sections (which
 * needs stacks as large as the arrays: ulimit -s, OMP_STACKSIZE), array expansion written by hand,
 * and `unmerged`: each thread adds an equal share of the iterations to a separate array, and these
 * are not merged. This shows the speed-up of the iterations alone; methods with better locality can
 * be faster. WARM 0: one execution only, for the model at many threads.
 */
#include "loop.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 467, NODES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1) };
enum { ROUNDS = 9, MOST_ROUNDS = 999 };

static int (*triangle)[3], (*slot)[9];
static int (*edge)[2], edges;
static double (*x)[3], (*b)[3], (*a)[9];
static int *row_start, *column;

static unsigned long random_state = 88172645463325252u;

static int below(int limit) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (int)(random_state % (unsigned long)limit);
}

static int *permutation(int count, int shuffled) {
    int *place = malloc((size_t)count * sizeof *place);
    for (int i = 0; i < count; i++)
        place[i] = i;
    for (int i = count - 1; shuffled && i > 0; i--) {
        const int j = below(i + 1), other = place[j];
        place[j] = place[i];
        place[i] = other;
    }
    return place;
}

static void add_neighbour(int *count, int (*neighbour)[8], int i, int j) {
    for (int k = 0; k < count[i]; k++)
        if (neighbour[i][k] == j)
            return;
    neighbour[i][count[i]++] = j;
}

static int ascending(const void *p, const void *q) {
    return *(const int *)p - *(const int *)q;
}

/* Returns the index of block (i, j) of the matrix in `a`. */
static int find(int i, int j) {
    for (int k = row_start[i]; k < row_start[i + 1]; k++)
        if (column[k] == j)
            return k;
    abort();
}

static void make_matrix(void) {
    int *count = calloc(NODES, sizeof *count);
    int(*neighbour)[8] = malloc(sizeof(int[8]) * NODES);
    for (int t = 0; t < TRIANGLES; t++)
        for (int p = 0; p < 3; p++)
            for (int q = 0; q < 3; q++)
                add_neighbour(count, neighbour, triangle[t][p], triangle[t][q]);
    row_start = malloc(sizeof(int) * (NODES + 1));
    column = malloc(sizeof(int) * 8 * NODES);
    row_start[0] = 0;
    for (int i = 0; i < NODES; i++) {
        qsort(neighbour[i], (size_t)count[i], sizeof(int), ascending);
        memcpy(column + row_start[i], neighbour[i], sizeof(int) * (size_t)count[i]);
        row_start[i + 1] = row_start[i] + count[i];
    }
    for (int t = 0; t < TRIANGLES; t++)
        for (int p = 0; p < 9; p++)
            slot[t][p] = find(triangle[t][p / 3], triangle[t][p % 3]);
    free(count);
    free(neighbour);
}

static void make_mesh(int shuffled) {
    int *node = permutation(NODES, shuffled), *place = permutation(TRIANGLES, shuffled);
    triangle = malloc(sizeof(int[3]) * TRIANGLES);
    slot = malloc(sizeof(int[9]) * TRIANGLES);
    edge = malloc(sizeof(int[2]) * 3 * NODES);
    x = malloc(sizeof(double[3]) * NODES);
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            const int here = i * SIDE + j;
            const int next[] = {here + 1, here + SIDE, here + SIDE + 1};
            const double position[3] = {i + 0.1 * sin(here), j, 0.1 * cos(here)};
            memcpy(x[node[here]], position, sizeof position);
            for (int k = 0; k < 3; k++)
                if ((k == 1 || j + 1 < SIDE) && (k == 0 || i + 1 < SIDE)) {
                    edge[edges][0] = node[here];
                    edge[edges++][1] = node[next[k]];
                }
            if (i + 1 == SIDE || j + 1 == SIDE)
                continue;
            const int t = 2 * (i * (SIDE - 1) + j);
            const int low[3] = {node[here], node[here + 1], node[here + SIDE + 1]};
            const int high[3] = {node[here], node[here + SIDE + 1], node[here + SIDE]};
            memcpy(triangle[place[t]], low, sizeof low);
            memcpy(triangle[place[t + 1]], high, sizeof high);
        }
    int *order = permutation(edges, shuffled);
    int(*mixed)[2] = malloc(sizeof(int[2]) * (size_t)edges);
    for (int e = 0; e < edges; e++)
        memcpy(mixed[order[e]], edge[e], sizeof(int[2]));
    free(edge);
    edge = mixed;
    make_matrix();
    b = calloc(NODES, sizeof *b);
    a = calloc((size_t)row_start[NODES], sizeof *a);
    free(node);
    free(place);
    free(order);
}

/* Forces f of springs along the edges of triangle t, and their 3 x 3 Jacobians k, row by row. */
static inline void element(int t, double f[3][3], double k[3][9]) {
    for (int e = 0; e < 3; e++) {
        const double *p = x[triangle[t][e]], *q = x[triangle[t][(e + 1) % 3]];
        double d[3];
        for (int c = 0; c < 3; c++)
            d[c] = q[c] - p[c];
        const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const double stretch = 1 - 0.9 / length, bend = 0.9 / (length * length * length);
        const double damp = exp(-0.01 * length) * 0.5 + atan2(stretch, length) * 0.1;
        for (int c = 0; c < 3; c++)
            f[e][c] = stretch * d[c] * damp;
        for (int c = 0; c < 9; c++)
            k[e][c] = damp * (bend * d[c / 3] * d[c % 3] + (c % 4 == 0 ? stretch : 0));
    }
}

#define PLAINLY(own, target, value) target += value
#define IF_OWNED(own, target, value)                                                               \
    if (redcc_owns(&own, &target))                                                                 \
    target += value
#define ATOMICALLY(own, target, value) _Pragma("omp atomic") target += value

#define HEAVY(t, ADD)                                                                              \
    double f[3][3], k[3][9];                                                                       \
    element(t, f, k);                                                                              \
    for (int p = 0; p < 3; p++)                                                                    \
        for (int c = 0; c < 3; c++) {                                                              \
            ADD(own_b, to_b[triangle[t][p]][c], f[p][c] - f[(p + 2) % 3][c]);                      \
        }                                                                                          \
    for (int p = 0; p < 9; p++)                                                                    \
        for (int c = 0; c < 9; c++) {                                                              \
            ADD(own_a, to_a[slot[t][p]][c], k[p % 3][c] - 0.5 * k[p / 3][c]);                      \
        }

#define LIGHT(t, ADD)                                                                              \
    const int i = edge[t][0], j = edge[t][1];                                                      \
    double f[3];                                                                                   \
    for (int c = 0; c < 3; c++)                                                                    \
        f[c] = 0.3 * (x[j][c] - x[i][c]) - 0.1;                                                    \
    for (int c = 0; c < 3; c++) {                                                                  \
        ADD(own_b, to_b[i][c], f[c]);                                                              \
        ADD(own_b, to_b[j][c], -f[c]);                                                             \
    }

#define TELL_TOUCH(number, base, row) redcc_touch(&worker, number, &base[row], sizeof *base)
#define TELL_READ(number, base, row) redcc_read(&worker, number, &base[row], sizeof *base)
#define PROBE_TOUCH(number, base, row)                                                             \
    redcc_probe_touch_row(&probe, &worker, number, base, row, sizeof *base)
#define PROBE_READ(number, base, row)                                                              \
    redcc_probe_read_row(&probe, &worker, number, base, row, sizeof *base)

#define INSPECT_HEAVY(t, READ, TOUCH)                                                              \
    for (int p = 0; p < 3; p++) {                                                                  \
        READ(2, x, triangle[t][p]);                                                                \
        TOUCH(0, b, triangle[t][p]);                                                               \
    }                                                                                              \
    for (int p = 0; p < 9; p++)                                                                    \
    TOUCH(1, a, slot[t][p])

#define INSPECT_LIGHT(t, READ, TOUCH)                                                              \
    for (int p = 0; p < 2; p++) {                                                                  \
        READ(2, x, edge[t][p]);                                                                    \
        TOUCH(0, b, edge[t][p]);                                                                   \
    }

#define EXECUTE(trip, ARRAYS, SUBSCRIPTS, SUBSCRIPT_BYTES, INSPECT, BODY)                          \
    static const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *b, 0},          \
                                         {"a", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *a, 0}};         \
    static const redcc_source sources[] = {{"triangle", 1}, {"slot", 1}, {"x", 0}};                \
    static redcc_loop loop = {__FILE__,         __LINE__, __func__, REDCC_ORDER_SERIAL,            \
                              REDCC_VERIFIABLE, ARRAYS,   arrays,   3,                             \
                              sources,          1,        0};                                      \
    described = &loop;                                                                             \
    void *const bases[] = {b, a};                                                                  \
    const redcc_extent known[] = {                                                                 \
        {(const char *)(SUBSCRIPTS), (const char *)(SUBSCRIPTS) + SUBSCRIPT_BYTES},                \
        {(const char *)slot, ARRAYS == 2 ? (const char *)(slot + (trip)) : (const char *)slot},    \
        {(const char *)x, 0}};                                                                     \
    redcc_call call;                                                                               \
    if (redcc_enter(&call, &loop, trip, bases, known, &key, omp_get_max_threads(), 0)) {           \
        _Pragma("omp parallel num_threads(call.threads)") {                                        \
            redcc_worker worker;                                                                   \
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());               \
            while (redcc_inspect(&worker))                                                         \
                for (redcc_int n = worker.first; n < worker.last; n += worker.stride) {            \
                    if (redcc_is_settled(&worker)) {                                               \
                        const redcc_int from = n;                                                  \
                        for (; n < worker.last; n++) {                                             \
                            redcc_probe probe = {0};                                               \
                            INSPECT((int)n, PROBE_READ, PROBE_TOUCH);                              \
                            if (!redcc_is_alike(&probe))                                           \
                                break;                                                             \
                        }                                                                          \
                        worker.alike += n - from;                                                  \
                        if (n == worker.last)                                                      \
                            break;                                                                 \
                    }                                                                              \
                    INSPECT((int)n, TELL_READ, TELL_TOUCH);                                        \
                    redcc_iteration_done(&worker);                                                 \
                }                                                                                  \
            while (redcc_next(&worker)) {                                                          \
                double(*const to_b)[3] = worker.base[0];                                           \
                double(*const to_a)[9] = ARRAYS == 2 ? worker.base[1] : 0;                         \
                const redcc_owner own_b = worker.owner[0], own_a = worker.owner[ARRAYS - 1];       \
                (void)to_a;                                                                        \
                (void)own_a;                                                                       \
                for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {     \
                    int n = (int)(worker.origin + run->begin);                                     \
                    const int end = n + (int)(run->count_and_check / 2);                           \
                    if (!(run->count_and_check & 1))                                               \
                        for (; n < end; n++) {                                                     \
                            BODY(n, PLAINLY);                                                      \
                        }                                                                          \
                    else                                                                           \
                        for (; n < end; n++) {                                                     \
                            BODY(n, IF_OWNED);                                                     \
                        }                                                                          \
                }                                                                                  \
            }                                                                                      \
        }                                                                                          \
    }                                                                                              \
    if (redcc_leave(&call))                                                                        \
    return 1

static redcc_loop *described; /* descriptor of the loop executed last */

enum bench_variant { SERIAL, REDCC, ATOMIC, SECTIONS, EXPANSION, UNMERGED, BENCHED };

#define BLOCKS (row_start[NODES])

#define BY_ATOMICS(trip, BODY)                                                                     \
    _Pragma("omp parallel for") for (int t = 0; t < trip; t++) {                                   \
        double(*const to_b)[3] = b;                                                                \
        double(*const to_a)[9] = a;                                                                \
        (void)to_a;                                                                                \
        BODY(t, ATOMICALLY);                                                                       \
    }

/* Array expansion: every thread except the first adds to a private copy. If MERGED is set, the
 * copies are then added to the arrays; each thread adds a share of the elements. */
#define BY_EXPANSION(trip, BODY, WITH_A, MERGED)                                                   \
    const size_t doubles = 3 * (size_t)NODES + (WITH_A ? 9 * (size_t)BLOCKS : 0);                  \
    static double **copy;                                                                          \
    if (!copy)                                                                                     \
        copy = calloc((size_t)omp_get_max_threads(), sizeof *copy);                                \
    _Pragma("omp parallel") {                                                                      \
        const int me = omp_get_thread_num(), all = omp_get_num_threads();                          \
        if (me > 0 && !copy[me])                                                                   \
            copy[me] = malloc(doubles * sizeof(double));                                           \
        if (me > 0 && MERGED)                                                                      \
            memset(copy[me], 0, doubles * sizeof(double));                                         \
        double(*const to_b)[3] = me ? (double(*)[3])copy[me] : b;                                  \
        double(*const to_a)[9] = me ? (double(*)[9])(copy[me] + 3 * NODES) : a;                    \
        (void)to_a;                                                                                \
        _Pragma("omp for") for (int t = 0; t < trip; t++) {                                        \
            BODY(t, PLAINLY);                                                                      \
        }                                                                                          \
        for (int other = 1; MERGED && other < all; other++) {                                      \
            _Pragma("omp for nowait") for (long i = 0; i < 3 * (long)NODES; i++) b[0][i] +=        \
                copy[other][i];                                                                    \
            if (WITH_A)                                                                            \
                _Pragma("omp for nowait") for (long i = 0; i < 9 * (long)BLOCKS; i++) a[0][i] +=   \
                    copy[other][3 * NODES + i];                                                    \
        }                                                                                          \
    }

static void sequentially_heavy(void) {
    double(*const to_b)[3] = b;
    double(*const to_a)[9] = a;
    for (int t = 0; t < TRIANGLES; t++) {
        HEAVY(t, PLAINLY)
    }
}

/* `key` stands for a pointer on which the subscripts depend; changing it forces an inspection.
 * Returns 0 if the loop was executed sequentially, otherwise 1. */
static int run_heavy(redcc_word key, enum bench_variant variant) {
    switch (variant) {
    case SERIAL:
        sequentially_heavy();
        return 0;
    case REDCC: {
        EXECUTE(TRIANGLES, 2, triangle, sizeof(int[3]) * TRIANGLES, INSPECT_HEAVY, HEAVY);
        break;
    }
    case ATOMIC:
        BY_ATOMICS(TRIANGLES, HEAVY)
        return 1;
    case SECTIONS: {
        double *const all_b = b[0], *const all_a = a[0];
#pragma omp parallel for reduction(+ : all_b[:3 * NODES], all_a[:9 * (size_t)BLOCKS])
        for (int t = 0; t < TRIANGLES; t++) {
            double(*const to_b)[3] = (double(*)[3])all_b;
            double(*const to_a)[9] = (double(*)[9])all_a;
            HEAVY(t, PLAINLY)
        }
        return 1;
    }
    case EXPANSION: {
        BY_EXPANSION(TRIANGLES, HEAVY, 1, 1)
        return 1;
    }
    case UNMERGED: {
        BY_EXPANSION(TRIANGLES, HEAVY, 1, 0)
        return 1;
    }
    default:
        return 0;
    }
    sequentially_heavy();
    redcc_sequential_done(described);
    return 0;
}

static void sequentially_light(void) {
    double(*const to_b)[3] = b;
    for (int t = 0; t < edges; t++) {
        LIGHT(t, PLAINLY)
    }
}

static int run_light(redcc_word key, enum bench_variant variant) {
    switch (variant) {
    case SERIAL:
        sequentially_light();
        return 0;
    case REDCC: {
        EXECUTE(edges, 1, edge, sizeof(int[2]) * (size_t)edges, INSPECT_LIGHT, LIGHT);
        break;
    }
    case ATOMIC:
        BY_ATOMICS(edges, LIGHT)
        return 1;
    case SECTIONS: {
        double *const all_b = b[0];
#pragma omp parallel for reduction(+ : all_b[:3 * NODES])
        for (int t = 0; t < edges; t++) {
            double(*const to_b)[3] = (double(*)[3])all_b;
            LIGHT(t, PLAINLY)
        }
        return 1;
    }
    case EXPANSION: {
        BY_EXPANSION(edges, LIGHT, 0, 1)
        return 1;
    }
    case UNMERGED: {
        BY_EXPANSION(edges, LIGHT, 0, 0)
        return 1;
    }
    default:
        return 0;
    }
    sequentially_light();
    redcc_sequential_done(described);
    return 0;
}

static int (*run_loop)(redcc_word, enum bench_variant);

static double seconds(redcc_word key, enum bench_variant variant) {
    const double begin = omp_get_wtime();
    run_loop(key, variant);
    return omp_get_wtime() - begin;
}

static double second_seconds(enum bench_variant variant) {
    run_loop(1, variant);
    return seconds(1, variant);
}

static int by_size(const void *p, const void *q) {
    const double d = *(const double *)p - *(const double *)q;
    return d < 0 ? -1 : d > 0;
}

struct spread {
    double lowest, median, highest;
};

static struct spread spread_of(const double *values, int count) {
    double sorted[MOST_ROUNDS];
    const int left_out = count / 20;
    memcpy(sorted, values, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, by_size);
    return (struct spread){sorted[left_out], sorted[count / 2], sorted[count - 1 - left_out]};
}

static struct spread ratios(const double *above, const double *below, int count) {
    double ratio[MOST_ROUNDS];
    for (int round = 0; round < count; round++)
        ratio[round] = above[round] / below[round];
    return spread_of(ratio, count);
}

/* Times rounds of the variants below `end` for `most` seconds, but at least ROUNDS and at most
 * MOST_ROUNDS rounds. Returns the number of rounds that were timed. */
static int time_rounds(double taken[BENCHED][MOST_ROUNDS], int end, double most) {
    const double begin = omp_get_wtime();
    int round = 0;
    for (; round < ROUNDS || (round < MOST_ROUNDS && omp_get_wtime() - begin < most); round++)
        for (int variant = 0; variant < end; variant++)
            taken[variant][round] = second_seconds((enum bench_variant)variant);
    return round;
}

static const char *order_of(enum bench_variant variant, const struct statistics *it) {
    static const char *const names[] = {"serial", "fixed", "any"};
    return variant == REDCC ? names[it->order] : "any";
}

int main(int count, char **arguments) {
    if (count < 3) {
        fprintf(stderr, "usage: %s heavy|light sorted|shuffled [WARM [others]]\n", arguments[0]);
        return 2;
    }
    const int heavy = strcmp(arguments[1], "heavy") == 0;
    const double warm = count > 3 ? atof(arguments[3]) : 2;
    const int end = count > 4 ? BENCHED : ATOMIC;
    run_loop = heavy ? run_heavy : run_light;
    make_mesh(strcmp(arguments[2], "shuffled") == 0);
    static double taken[BENCHED][MOST_ROUNDS], fresh[ROUNDS];
    const double begin = omp_get_wtime();
    do
        seconds(1, REDCC);
    while (omp_get_wtime() - begin < warm);
    const struct loop_state *state = described->state; /* NULL if never executed in parallel */
    struct statistics kept = {0};
    if (state)
        memcpy(&kept, &state->reported.statistics, sizeof kept);
    const int rounds = warm > 0 ? time_rounds(taken, end, 2 * warm) : 1;
    for (int round = 0; round < ROUNDS && warm > 0; round++)
        fresh[round] = seconds(2 + (redcc_word)round, REDCC);
    const double alone = spread_of(taken[SERIAL], rounds).median;
    const double bytes = 24.0 * (double)NODES + (heavy ? 72.0 * BLOCKS : 0);
    static const char *const names[] = {"serial",       "",        "omp-atomic",
                                        "omp-sections", "by-hand", "unmerged"};
    for (int variant = REDCC; variant < end; variant++) {
        const struct spread gain =
            warm > 0 ? ratios(taken[SERIAL], taken[variant], rounds) : (struct spread){0, 0, 0};
        const double mine = spread_of(taken[variant], rounds).median;
        const int ours = variant == REDCC;
        const double copies = variant == ATOMIC     ? 0
                              : variant == SECTIONS ? omp_get_max_threads()
                                                    : omp_get_max_threads() - 1;
        const double extra = ours ? (double)kept.extra.bytes : copies * bytes;
        printf("%s,%s,%s%s,%d,%s,%.6f,%.6f,%.2f,%.2f,%.2f,%.2f,%.1f,%.4f,%.2f\n", arguments[1],
               arguments[2], ours && !getenv("REDCC_METHOD") ? "auto=" : "",
               ours ? kept.method ? kept.method->name : "serial" : names[variant],
               omp_get_max_threads(), order_of((enum bench_variant)variant, &kept), alone, mine,
               gain.median, gain.lowest, gain.highest,
               ours && warm > 0 ? (spread_of(fresh, ROUNDS).median - mine) / alone : 0,
               100 * extra / bytes,
               ours && kept.in_loops ? (double)kept.extra.executed / (double)kept.in_loops : 1,
               ours && kept.last.length ? (double)kept.last.trip / (double)kept.last.length : 0);
    }
    return 0;
}
