/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* by-hand check [CALLS]: executes each loop CALLS times, both as written by hand for redcc and
 * sequentially, and compares all bits; status 1 if some differ. by-hand time LOOP SIDE ROUNDS:
 * prints LOOP,version,median,10th percentile,90th percentile for each version, in milliseconds per
 * call. The versions take turns. */
#include "kernels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct lengths lengths;

#ifdef WITH_OPENMP
enum { VERSIONS = 4 };
#else
enum { VERSIONS = 2 };
#endif
enum { LOOPS = 4, MOST_VERSIONS = 4, MOST_ROUNDS = 99 };
static const char *const loop_names[LOOPS] = {"springs", "product", "histogram", "assemble"};
static const char *const version_names[MOST_VERSIONS] = {"plain", "by hand", "reduction", "atomic"};

/* Data of the loops: a grid of side x side particles with springs along the axes and one diagonal,
 * and two triangles in each square. */
struct data {
    int edges, triangles, entries, keys;
    int (*edge)[2], *start, *row, *key;
    double (*x)[3], *value, *vector;
    struct triangle *triangle;
};
struct results {
    size_t bytes[5];
    double (*b)[3], *y, (*load)[3], (*block)[3][3];
    unsigned *count;
};

static void *make(size_t count, size_t size) {
    void *memory = calloc(count + 1, size);
    if (!memory) {
        fprintf(stderr, "by-hand: there is no memory for %zu items of %zu bytes\n", count, size);
        exit(1);
    }
    return memory;
}

static unsigned next_number(void) {
    static unsigned long long state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 40);
}

static double next_real(void) {
    return (double)next_number() / (1 << 24) - 0.5;
}

static void add_edge(struct data *it, int i, int j) {
    it->edge[it->edges][0] = i;
    it->edge[it->edges++][1] = j;
}

/* A corner's diagonal block has the corner's number. After all diagonal blocks follow six blocks
 * for each corner, one for each direction to a neighbour. */
static void add_triangle(struct data *it, int i, int j, int k) {
    const int corner[3] = {i, j, k};
    struct triangle *to = &it->triangle[it->triangles++];
    for (int p = 0; p < 3; p++) {
        to->corner[p] = corner[p];
        to->weight[p] = next_real() * 8.0;
        for (int q = 0; q < 3; q++)
            to->place[p][q] =
                p == q ? corner[p] : lengths.particles + 6 * corner[p] + (corner[q] + 3 * q) % 6;
    }
}

static struct data make_data(int side) {
    const int n = side * side;
    struct data it = {0};
    lengths = (struct lengths){.particles = n, .rows = n, .keys = 4 * side, .blocks = 7 * n};
    it.edge = make((size_t)n * 3, sizeof *it.edge);
    it.triangle = make((size_t)n * 2, sizeof *it.triangle);
    it.x = make((size_t)n, sizeof *it.x);
    it.start = make((size_t)n + 1, sizeof *it.start);
    it.row = make((size_t)n * 9, sizeof *it.row);
    it.value = make((size_t)n * 9, sizeof *it.value);
    it.vector = make((size_t)n, sizeof *it.vector);
    it.keys = 4 * n;
    it.key = make((size_t)it.keys, sizeof *it.key);
    for (int i = 0; i < n; i++) {
        it.vector[i] = next_real();
        for (int c = 0; c < 3; c++)
            it.x[i][c] = next_real();
        const int right = i % side + 1 < side, up = i + side < n;
        if (right)
            add_edge(&it, i, i + 1);
        if (up)
            add_edge(&it, i, i + side);
        if (right && up) {
            add_edge(&it, i, i + side + 1);
            add_triangle(&it, i, i + 1, i + side + 1);
            add_triangle(&it, i, i + side + 1, i + side);
        }
        it.start[i] = it.entries;
        for (int e = 0; e < 9 && i > 0; e += 1 + (int)(next_number() % 2)) {
            const int row = i + side * (e % 3 - 1) + e / 3 - 1;
            it.row[it.entries] = row < 0 ? row + n : row % n;
            it.value[it.entries++] = next_real();
        }
    }
    it.start[n] = it.entries;
    for (int t = 0; t < it.keys; t++)
        it.key[t] = (int)(next_number() % (unsigned)lengths.keys);
    return it;
}

static void free_data(struct data *it) {
    free(it->edge), free(it->start), free(it->row), free(it->key), free(it->x);
    free(it->value), free(it->vector), free(it->triangle);
}

static struct results make_results(void) {
    struct results it = {0};
    it.b = make((size_t)lengths.particles, it.bytes[0] = sizeof *it.b);
    it.y = make((size_t)lengths.rows, it.bytes[1] = sizeof *it.y);
    it.count = make((size_t)lengths.keys, it.bytes[2] = sizeof *it.count);
    it.load = make((size_t)lengths.particles, it.bytes[3] = sizeof *it.load);
    it.block = make((size_t)lengths.blocks, it.bytes[4] = sizeof *it.block);
    it.bytes[0] *= (size_t)lengths.particles;
    it.bytes[1] *= (size_t)lengths.rows;
    it.bytes[2] *= (size_t)lengths.keys;
    it.bytes[3] *= (size_t)lengths.particles;
    it.bytes[4] *= (size_t)lengths.blocks;
    return it;
}

static void free_results(struct results *it) {
    free(it->b), free(it->y), free(it->count), free(it->load), free(it->block);
}

#define EXECUTE(suffix)                                                                            \
    static void execute##suffix(int loop, const struct data *it, struct results *to) {             \
        const double(*x)[3] = (const double(*)[3])it->x;                                           \
        if (loop == 0)                                                                             \
            springs##suffix(it->edges, (const int(*)[2])it->edge, x, 0.3, to->b);                  \
        else if (loop == 1)                                                                        \
            product##suffix(lengths.rows, it->start, it->row, it->value, it->vector, to->y);       \
        else if (loop == 2)                                                                        \
            histogram##suffix(it->keys, it->key, to->count);                                       \
        else                                                                                       \
            assemble##suffix(it->triangles, it->triangle, x, to->load, to->block);                 \
    }
EXECUTE(/* by hand */)
EXECUTE(_plain)
#ifdef WITH_OPENMP
EXECUTE(_reduction)
EXECUTE(_atomic)
#else
#define execute_reduction execute_plain
#define execute_atomic execute_plain
#endif

static int are_equal(const struct results *one, const struct results *other) {
    return !memcmp(one->b, other->b, one->bytes[0]) && !memcmp(one->y, other->y, one->bytes[1]) &&
           !memcmp(one->count, other->count, one->bytes[2]) &&
           !memcmp(one->load, other->load, one->bytes[3]) &&
           !memcmp(one->block, other->block, one->bytes[4]);
}

static int check(int side, int calls) {
    struct data it = make_data(side);
    struct results by_hand = make_results(), expected = make_results();
    int differ = 0;
    for (int loop = 0; loop < LOOPS; loop++)
        for (int call = 0; call < calls; call++) {
            if (call == calls / 2 && it.edges > 8) { /* changes subscripts halfway */
                it.edge[it.edges / 2][0] = 1;
                it.row[it.entries / 2] = 0;
                it.key[3] = 0;
                it.triangle[it.triangles / 2].corner[1] = 2;
            }
            execute(loop, &it, &by_hand);
            execute_plain(loop, &it, &expected);
            if (!are_equal(&by_hand, &expected)) {
                printf("%s, side %d, call %d: results differ\n", loop_names[loop], side, call);
                differ = 1;
                break;
            }
        }
    free_results(&by_hand);
    free_results(&expected);
    free_data(&it);
    return differ;
}

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int by_size(const void *one, const void *other) {
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

/* Each round begins with a different version; the first two rounds are not counted. */
static int time_loop(int loop, int side, int rounds) {
    static void (*const execute_version[MOST_VERSIONS])(
        int, const struct data *, struct results *) = {execute_plain, execute, execute_reduction,
                                                       execute_atomic};
    static double taken[VERSIONS][MOST_ROUNDS];
    struct data it = make_data(side);
    struct results to = make_results();
    for (int round = -2; round < rounds; round++)
        for (int turn = 0; turn < VERSIONS; turn++) {
            const int version = (turn + round + 2) % VERSIONS;
            const double began = seconds();
            for (int call = 0; call < 10; call++)
                execute_version[version](loop, &it, &to);
            if (round >= 0)
                taken[version][round] = (seconds() - began) / 10;
        }
    for (int version = 0; version < VERSIONS; version++) {
        qsort(taken[version], (size_t)rounds, sizeof(double), by_size);
        printf("%s,%s,%.4f,%.4f,%.4f\n", loop_names[loop], version_names[version],
               1e3 * taken[version][rounds / 2], 1e3 * taken[version][rounds / 10],
               1e3 * taken[version][rounds - 1 - rounds / 10]);
    }
    free_results(&to);
    free_data(&it);
    return 0;
}

int main(int count, char **arguments) {
    if (count >= 2 && strcmp(arguments[1], "check") == 0) {
        const int calls = count > 2 ? atoi(arguments[2]) : 6;
        return check(60, calls) | check(2, 2) | check(1, 2);
    }
    if (count == 5 && strcmp(arguments[1], "time") == 0) {
        const int side = atoi(arguments[3]), rounds = atoi(arguments[4]);
        for (int loop = 0; loop < LOOPS; loop++)
            if (strcmp(arguments[2], loop_names[loop]) == 0 && side > 1 && rounds > 0 &&
                rounds <= MOST_ROUNDS)
                return time_loop(loop, side, rounds);
    }
    fputs("usage: by-hand check [CALLS] | by-hand time LOOP SIDE ROUNDS (up to 99)\n", stderr);
    return 2;
}
