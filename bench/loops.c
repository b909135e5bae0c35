/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The runtime's methods on two loops over a mesh of the paper's size, written as redcc writes them:
 *   heavy  a triangle of 217k nodes, 434k triangles: 9 doubles into b, 81 into a block matrix
 *   light  an edge of that mesh: 6 doubles into b
 *
 *   REDCC_METHOD=localwrite OMP_NUM_THREADS=2 loops heavy|light sorted|shuffled
 *
 * prints seconds of the sequential loop and of the transformed one (medians of 7, interleaved), the
 * speed-up, and what an inspection costs as a share of a sequential execution.
 */
#include "redcc/runtime.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 467, NODES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1), ROUNDS = 7 };

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

/* Block (i, j) of the matrix is a[find(i, j)]. */
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

/* Springs along the triangle's edges, with their 3 x 3 Jacobians: f [3][3], k [3][9]. */
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

#define ALWAYS(own, address) 1
#define OWNED(own, address) redcc_owns(&own, address)

#define HEAVY(t, MAY)                                                                              \
    double f[3][3], k[3][9];                                                                       \
    element(t, f, k);                                                                              \
    for (int p = 0; p < 3; p++)                                                                    \
        for (int c = 0; c < 3; c++)                                                                \
            if (MAY(own_b, &to_b[triangle[t][p]][c]))                                              \
                to_b[triangle[t][p]][c] += f[p][c] - f[(p + 2) % 3][c];                            \
    for (int p = 0; p < 9; p++)                                                                    \
        for (int c = 0; c < 9; c++)                                                                \
            if (MAY(own_a, &to_a[slot[t][p]][c]))                                                  \
    to_a[slot[t][p]][c] += k[p % 3][c] - 0.5 * k[p / 3][c]

#define LIGHT(t, MAY)                                                                              \
    const int i = edge[t][0], j = edge[t][1];                                                      \
    double f[3];                                                                                   \
    for (int c = 0; c < 3; c++)                                                                    \
        f[c] = 0.3 * (x[j][c] - x[i][c]) - 0.1;                                                    \
    for (int c = 0; c < 3; c++) {                                                                  \
        if (MAY(own_b, &to_b[i][c]))                                                               \
            to_b[i][c] += f[c];                                                                    \
        if (MAY(own_b, &to_b[j][c]))                                                               \
            to_b[j][c] -= f[c];                                                                    \
    }

#define TOUCH_HEAVY(t)                                                                             \
    for (int p = 0; p < 3; p++) {                                                                  \
        redcc_read(&worker, 2, &x[triangle[t][p]], sizeof *x);                                     \
        redcc_touch(&worker, 0, &b[triangle[t][p]], sizeof *b);                                    \
    }                                                                                              \
    for (int p = 0; p < 9; p++)                                                                    \
    redcc_touch(&worker, 1, &a[slot[t][p]], sizeof *a)

#define TOUCH_LIGHT(t)                                                                             \
    for (int p = 0; p < 2; p++) {                                                                  \
        redcc_read(&worker, 2, &x[edge[t][p]], sizeof *x);                                         \
        redcc_touch(&worker, 0, &b[edge[t][p]], sizeof *b);                                        \
    }

#define EXECUTE(trip, ARRAYS, SUBSCRIPTS, SUBSCRIPT_BYTES, TOUCH, BODY)                            \
    static const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *b},             \
                                         {"a", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *a}};            \
    static const redcc_source sources[] = {{"triangle", 1}, {"slot", 1}, {"x", 0}};                \
    static redcc_loop loop = {__FILE__,         __LINE__, __func__, REDCC_ORDER_SERIAL,            \
                              REDCC_VERIFIABLE, ARRAYS,   arrays,   3,                             \
                              sources,          1,        0};                                      \
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
                    TOUCH((int)n);                                                                 \
                    redcc_iteration_done(&worker);                                                 \
                }                                                                                  \
            while (redcc_next(&worker)) {                                                          \
                double(*const to_b)[3] = worker.base[0];                                           \
                double(*const to_a)[9] = ARRAYS == 2 ? worker.base[1] : 0;                         \
                const redcc_owner own_b = worker.owner[0], own_a = worker.owner[ARRAYS - 1];       \
                (void)to_a;                                                                        \
                (void)own_a;                                                                       \
                for (const redcc_run *run = worker.run; run != worker.run_end; run++) {            \
                    int n = (int)(worker.origin + run->begin);                                     \
                    const int end = n + (int)(run->count_and_guard / 2);                           \
                    if (!(run->count_and_guard & 1))                                               \
                        for (; n < end; n++) {                                                     \
                            BODY(n, ALWAYS);                                                       \
                        }                                                                          \
                    else                                                                           \
                        for (; n < end; n++) {                                                     \
                            BODY(n, OWNED);                                                        \
                        }                                                                          \
                }                                                                                  \
            }                                                                                      \
        }                                                                                          \
    }                                                                                              \
    if (redcc_leave(&call))                                                                        \
    return 1

/* `key` stands for a pointer that the subscripts depend on: another one forces an inspection. */
static int run_heavy(redcc_word key, int sequential) {
    if (!sequential) {
        EXECUTE(TRIANGLES, 2, triangle, sizeof(int[3]) * TRIANGLES, TOUCH_HEAVY, HEAVY);
    }
    double(*const to_b)[3] = b;
    double(*const to_a)[9] = a;
    for (int t = 0; t < TRIANGLES; t++) {
        HEAVY(t, ALWAYS);
    }
    return 0;
}

static int run_light(redcc_word key, int sequential) {
    if (!sequential) {
        EXECUTE(edges, 1, edge, sizeof(int[2]) * (size_t)edges, TOUCH_LIGHT, LIGHT);
    }
    double(*const to_b)[3] = b;
    for (int t = 0; t < edges; t++) {
        LIGHT(t, ALWAYS);
    }
    return 0;
}

static int (*run_loop)(redcc_word, int);

static double seconds(redcc_word key, int sequential) {
    const double begin = omp_get_wtime();
    run_loop(key, sequential);
    return omp_get_wtime() - begin;
}

static int by_size(const void *p, const void *q) {
    const double d = *(const double *)p - *(const double *)q;
    return d < 0 ? -1 : d > 0;
}

static double median(double *values) {
    qsort(values, ROUNDS, sizeof *values, by_size);
    return values[ROUNDS / 2];
}

int main(int count, char **arguments) {
    if (count != 3) {
        fprintf(stderr, "usage: %s heavy|light sorted|shuffled\n", arguments[0]);
        return 2;
    }
    run_loop = strcmp(arguments[1], "heavy") == 0 ? run_heavy : run_light;
    make_mesh(strcmp(arguments[2], "shuffled") == 0);
    double serial[ROUNDS], planned[ROUNDS], fresh[ROUNDS];
    for (int warm = 0; warm < 6; warm++)
        seconds(1, 0);
    seconds(1, 1);
    for (int round = 0; round < ROUNDS; round++) {
        serial[round] = seconds(1, 1);
        planned[round] = seconds(1, 0);
        fresh[round] = seconds(2 + (redcc_word)round, 0);
    }
    const double alone = median(serial), with_plan = median(planned), inspecting = median(fresh);
    const char *method = getenv("REDCC_METHOD");
    printf(
        "%-6s %-9s %-18s serial %.6f s, planned %.6f s, speed-up %.2f, inspection %.3f of serial\n",
        arguments[1], arguments[2], method ? method : "auto", alone, with_plan, alone / with_plan,
        (inspecting - with_plan) / alone);
    return 0;
}
