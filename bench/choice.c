/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Measures the cost of redcc in a program that calls a typical loop once, a few times, or with new
 * subscripts each time. Most of these loops gain little or nothing by running in parallel.
 *
 *     choice LOOP CALLS [CALLS...]     ascending
 *
 * prints a line for each number of CALLS: the total seconds of that many executions, from the first
 * one on and without the time between executions, and a hash of the results' bits. LOOP:
 * - count: 8 M integer keys into 65536 counts; two keys change before each call
 * - pairs: histogram of the distances of pairs of points, the bin found by bisection; new points
 *    before each call
 * - weights: 20,000 weights into 4096 bins; new subscripts before each call
 * - charge: 2 M particles' charge onto a grid of 512 x 512; the particles move
 * - columns: y += A x by columns, with a random pattern of 1 M entries, new before each call
 * - force-sorted: forces and a matrix from the triangles of a mesh; force-shuffled: with the nodes
 *    and triangles in random order
 * - springs-sorted: forces from the edges of that mesh; springs-shuffled
 * - force-short: the first 4,000 triangles of force-sorted
 * - springs-short: the first 120,000 edges of springs-sorted
 * - columns-short: the first 8,000 columns of columns
 * - gaxpy-sorted: y += A x by columns (CSparse's cs_gaxpy) for a matrix with the pattern of that
 *    mesh; gaxpy-shuffled
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
    KEYS = 8 << 20,
    COUNTS = 65536,
    POINTS = 1200,
    DISTANCES = 64,
    WEIGHTS = 20000,
    BINS = 4096,
    PARTICLES = 2 << 20,
    GRID = 512,
    COLUMNS = 100000,
    PER_COLUMN = 10,
    SIDE = 467,
    NODES = SIDE * SIDE,
    AROUND = 9,
    TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1),
    EDGES = 3 * TRIANGLES / 2,
    SHORT_TRIANGLES = 4000,
    SHORT_EDGES = 120000,
    SHORT_COLUMNS = 8000
};

static int below(int limit) {
    static uint64_t state = 88172645463325252u; /* xorshift64, G. Marsaglia 2003 */
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (int)((state >> 20) % (uint64_t)limit);
}

static double real(void) {
    return below(1 << 30) * 0x1p-30;
}

/* ---- the loops as in a user's program ---- */

static void count(int n, const int *key, int *counts) {
    for (int i = 0; i < n; i++)
        counts[key[i]]++;
}

static void pairs(int n, const double *x, const double *y, const double *edge, double *histogram) {
    for (int k = 0; k < n * n; k++) {
        const int i = k / n, j = k % n;
        const double dx = x[i] - x[j], dy = y[i] - y[j], d = dx * dx + dy * dy;
        int low = 0, high = DISTANCES;
        while (high - low > 1) {
            const int middle = (low + high) / 2;
            if (d < edge[middle])
                high = middle;
            else
                low = middle;
        }
        histogram[low] += 1 / (1 + d);
    }
}

static void weights(int n, const int *bin, const double *weight, double *sum) {
    for (int i = 0; i < n; i++)
        sum[bin[i]] += weight[i];
}

static void charge(int n, const double *x, const double *y, const double *q, double *rho) {
    for (int p = 0; p < n; p++) {
        const int i = (int)x[p], j = (int)y[p];
        const double u = x[p] - i, v = y[p] - j;
        const int cell = i * (GRID + 1) + j;
        rho[cell] += q[p] * (1 - u) * (1 - v);
        rho[cell + 1] += q[p] * (1 - u) * v;
        rho[cell + GRID + 1] += q[p] * u * (1 - v);
        rho[cell + GRID + 2] += q[p] * u * v;
    }
}

static void columns(int n, const int *start, const int *row, const double *a, const double *x,
                    double *y) {
    for (int j = 0; j < n; j++)
        for (int k = start[j]; k < start[j + 1]; k++)
            y[row[k]] += a[k] * x[j];
}

static void forces(int n, int (*triangle)[3], double (*x)[3], double (*f)[3], double (*a)[9]) {
    for (int t = 0; t < n; t++) {
        for (int e = 0; e < 3; e++) {
            const int i = triangle[t][e], j = triangle[t][(e + 1) % 3];
            const double dx = x[j][0] - x[i][0], dy = x[j][1] - x[i][1], dz = x[j][2] - x[i][2];
            const double length = sqrt(dx * dx + dy * dy + dz * dz);
            const double stretch = (1 - 0.9 / length) * (0.5 * exp(-0.01 * length) + 0.1);
            const double bend = 0.9 / (length * length * length);
            f[i][0] += stretch * dx;
            f[i][1] += stretch * dy;
            f[i][2] += stretch * dz;
            f[j][0] -= stretch * dx;
            f[j][1] -= stretch * dy;
            f[j][2] -= stretch * dz;
            for (int c = 0; c < 9; c++) {
                a[i][c] += bend * dx * dy + c * stretch;
                a[j][c] += bend * dx * dz - c * stretch;
            }
        }
    }
}

static void springs(int n, int (*edge)[2], double (*x)[3], double (*f)[3]) {
    for (int e = 0; e < n; e++) {
        const int i = edge[e][0], j = edge[e][1];
        for (int c = 0; c < 3; c++) {
            const double pull = 0.3 * (x[j][c] - x[i][c]) - 0.1;
            f[i][c] += pull;
            f[j][c] -= pull;
        }
    }
}

/* ---- their data ---- */

static int *key, *integers, *start, (*triangle)[3], (*edge)[2], edges;
static double *x, *y, *q, *result, *limits, (*at)[3], (*force)[3], (*matrix)[9];

static double *reals(size_t count) {
    return calloc(count, sizeof(double));
}

static void draw_all(double *to, int count, double scale) {
    for (int i = 0; i < count; i++)
        to[i] = scale * real();
}

/* Returns the nodes' numbers: in order, or a random permutation if `shuffled`. */
static int *permutation(int shuffled) {
    int *node = malloc(NODES * sizeof *node);
    for (int i = 0; i < NODES; i++)
        node[i] = i;
    for (int i = NODES - 1; shuffled && i > 0; i--) {
        const int j = below(i + 1), other = node[j];
        node[j] = node[i];
        node[i] = other;
    }
    return node;
}

static void make_mesh(int shuffled) {
    int *node = permutation(shuffled);
    triangle = malloc(TRIANGLES * sizeof *triangle);
    edge = malloc(EDGES * sizeof *edge);
    at = malloc(NODES * sizeof *at);
    force = calloc(NODES, sizeof *force);
    matrix = calloc(NODES, sizeof *matrix);
    int t = 0;
    for (int i = 0; i + 1 < SIDE; i++)
        for (int j = 0; j + 1 < SIDE; j++) {
            const int a = node[i * SIDE + j], b = node[i * SIDE + j + 1];
            const int c = node[(i + 1) * SIDE + j], d = node[(i + 1) * SIDE + j + 1];
            const int two[2][3] = {{a, b, d}, {a, d, c}}, three[3][2] = {{a, b}, {a, c}, {a, d}};
            memcpy(triangle[t], two, sizeof two);
            memcpy(edge[edges], three, sizeof three);
            t += 2;
            edges += 3;
        }
    for (int i = TRIANGLES - 1; shuffled && i > 0; i--) {
        int other[3], j = below(i + 1);
        memcpy(other, triangle[i], sizeof other);
        memcpy(triangle[i], triangle[j], sizeof other);
        memcpy(triangle[j], other, sizeof other);
    }
    for (int i = edges - 1; shuffled && i > 0; i--) {
        int other[2], j = below(i + 1);
        memcpy(other, edge[i], sizeof other);
        memcpy(edge[i], edge[j], sizeof other);
        memcpy(edge[j], other, sizeof other);
    }
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double *const to = at[node[i * SIDE + j]];
            to[0] = i + 0.3 * real();
            to[1] = j + 0.3 * real();
            to[2] = 0.3 * real();
        }
    free(node);
}

/* ---- the measured loops ---- */

static void make_count(void) {
    key = malloc(KEYS * sizeof *key);
    integers = calloc(COUNTS, sizeof *integers);
    for (int i = 0; i < KEYS; i++)
        key[i] = below(COUNTS);
}
static void change_count(void) {
    key[below(KEYS)] = below(COUNTS);
    key[below(KEYS)] = below(COUNTS);
}
static void run_count(void) {
    count(KEYS, key, integers);
}

static void change_pairs(void) {
    draw_all(x, POINTS, 1);
    draw_all(y, POINTS, 1);
}
static void make_pairs(void) {
    x = reals(POINTS);
    y = reals(POINTS);
    limits = reals(DISTANCES);
    result = reals(DISTANCES);
    for (int b = 0; b < DISTANCES; b++)
        limits[b] = 2.0 * b * b / (DISTANCES * DISTANCES);
}
static void run_pairs(void) {
    pairs(POINTS, x, y, limits, result);
}

static void make_weights(void) {
    key = malloc(WEIGHTS * sizeof *key);
    x = reals(WEIGHTS);
    result = reals(BINS);
    draw_all(x, WEIGHTS, 1);
}
static void change_weights(void) {
    for (int i = 0; i < WEIGHTS; i++)
        key[i] = below(BINS);
}
static void run_weights(void) {
    weights(WEIGHTS, key, x, result);
}

static void make_charge(void) {
    x = reals(PARTICLES);
    y = reals(PARTICLES);
    q = reals(PARTICLES);
    result = reals((GRID + 1) * (GRID + 1));
    draw_all(x, PARTICLES, GRID);
    draw_all(y, PARTICLES, GRID);
    draw_all(q, PARTICLES, 1);
}
static void change_charge(void) {
    for (int p = 0; p < PARTICLES; p++) {
        x[p] = fmod(x[p] + 0.2 * real(), GRID);
        y[p] = fmod(y[p] + 0.2 * real(), GRID);
    }
}
static void run_charge(void) {
    charge(PARTICLES, x, y, q, result);
}

static void make_columns(void) {
    start = malloc((COLUMNS + 1) * sizeof *start);
    key = malloc(COLUMNS * PER_COLUMN * sizeof *key);
    q = reals(COLUMNS * PER_COLUMN);
    x = reals(COLUMNS);
    result = reals(COLUMNS);
    for (int j = 0; j <= COLUMNS; j++)
        start[j] = j * PER_COLUMN;
    draw_all(q, COLUMNS * PER_COLUMN, 1);
    draw_all(x, COLUMNS, 1);
}
static void change_columns(void) {
    for (int k = 0; k < COLUMNS * PER_COLUMN; k++)
        key[k] = below(COLUMNS);
}
static void run_columns(void) {
    columns(COLUMNS, start, key, q, x, result);
}

static void run_short_columns(void) {
    columns(SHORT_COLUMNS, start, key, q, x, result);
}

static void make_sorted(void) {
    make_mesh(0);
}
static void make_shuffled(void) {
    make_mesh(1);
}
/* Makes a matrix whose columns have entries for a node and its neighbours in the grid. */
static void make_gaxpy(int shuffled) {
    int *node = permutation(shuffled);
    start = malloc((NODES + 1) * sizeof *start);
    key = malloc((size_t)NODES * AROUND * sizeof *key);
    q = reals((size_t)NODES * AROUND);
    x = reals(NODES);
    result = reals(NODES);
    int entries = 0, *place = malloc(NODES * sizeof *place);
    for (int i = 0; i < NODES; i++)
        place[node[i]] = i;
    for (int column = 0; column < NODES; column++) {
        start[column] = entries;
        const int i = place[column] / SIDE, j = place[column] % SIDE;
        for (int down = -1; down <= 1; down++)
            for (int right = -1; right <= 1; right++)
                if (i + down >= 0 && i + down < SIDE && j + right >= 0 && j + right < SIDE)
                    key[entries++] = node[(i + down) * SIDE + j + right];
    }
    start[NODES] = entries;
    draw_all(q, entries, 1);
    draw_all(x, NODES, 1);
    free(place);
    free(node);
}
static void make_gaxpy_sorted(void) {
    make_gaxpy(0);
}
static void make_gaxpy_shuffled(void) {
    make_gaxpy(1);
}
static void run_gaxpy(void) {
    columns(NODES, start, key, q, x, result);
}

static void change_nothing(void) {
}
static void run_forces(void) {
    forces(TRIANGLES, triangle, at, force, matrix);
}
static void run_springs(void) {
    springs(edges, edge, at, force);
}

static void run_short_forces(void) {
    forces(SHORT_TRIANGLES, triangle, at, force, matrix);
}
static void run_short_springs(void) {
    springs(SHORT_EDGES, edge, at, force);
}

static const struct {
    const char *name;
    void (*make)(void), (*change)(void), (*run)(void);
} loops[] = {{"count", make_count, change_count, run_count},
             {"pairs", make_pairs, change_pairs, run_pairs},
             {"weights", make_weights, change_weights, run_weights},
             {"charge", make_charge, change_charge, run_charge},
             {"columns", make_columns, change_columns, run_columns},
             {"force-sorted", make_sorted, change_nothing, run_forces},
             {"force-shuffled", make_shuffled, change_nothing, run_forces},
             {"springs-sorted", make_sorted, change_nothing, run_springs},
             {"springs-shuffled", make_shuffled, change_nothing, run_springs},
             {"force-short", make_sorted, change_nothing, run_short_forces},
             {"springs-short", make_sorted, change_nothing, run_short_springs},
             {"columns-short", make_columns, change_columns, run_short_columns},
             {"gaxpy-sorted", make_gaxpy_sorted, change_nothing, run_gaxpy},
             {"gaxpy-shuffled", make_gaxpy_shuffled, change_nothing, run_gaxpy}};

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static uint64_t hash(uint64_t hash, const void *bytes, size_t count) {
    for (size_t b = 0; bytes && b < count; b++)
        hash = (hash ^ ((const unsigned char *)bytes)[b]) * 0x100000001b3u;
    return hash;
}

static uint64_t hash_results(const char *name) {
    uint64_t h = hash(0xcbf29ce484222325u, integers, integers ? COUNTS * sizeof *integers : 0);
    h = hash(h, force, NODES * sizeof *force);
    h = hash(h, matrix, NODES * sizeof *matrix);
    const size_t reals_there = strcmp(name, "pairs") == 0     ? DISTANCES
                               : strcmp(name, "weights") == 0 ? BINS
                               : strcmp(name, "charge") == 0  ? (GRID + 1) * (GRID + 1)
                               : name[0] == 'g'               ? NODES
                                                              : COLUMNS;
    return hash(h, result, reals_there * sizeof *result);
}

int main(int argc, char **argv) {
    for (size_t l = 0; argc > 2 && l < sizeof loops / sizeof *loops; l++) {
        if (strcmp(argv[1], loops[l].name) != 0)
            continue;
        double seconds = 0;
        int call = 0;
        loops[l].make();
        for (int a = 2; a < argc; a++) {
            for (; call < atoi(argv[a]); call++) {
                loops[l].change();
                const double begin = now();
                loops[l].run();
                seconds += now() - begin;
            }
            printf("%d %.6f %016llx\n", call, seconds,
                   (unsigned long long)hash_results(loops[l].name));
        }
        return 0;
    }
    fprintf(stderr, "choice LOOP CALLS [CALLS...]\n");
    return 2;
}
