/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What prefetching brings to executors, by kernel (lanes_kernels.c), order of the data and threads:
 * the untouched loop, and the translated one without and with it, one after the other in each
 * round. Of two executions in a row the second is timed; the bits are compared each time.
 *
 *   OMP_NUM_THREADS=2 REDCC_METHOD=localwrite lanes ROUNDS
 *
 * Prints lines: kernel,order,threads,serial_seconds,plain,plain_low,plain_high,prefetch,
 * prefetch_low,prefetch_high,gain - speed-ups against the untouched loop, medians and the 5th and
 * 95th percentile of the rounds' own; gain is the median of without over with.
 */
#include "lanes_kernels.h"

#include "settings.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 467, NODES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1) };
enum { MOST_EDGES = 3 * NODES, MOST_ROUNDS = 999 };

struct mesh {
    double (*x)[3], (*v)[3], *radius, *rest;
    struct element *element;
    int (*edge)[2];
    int edges, blocks;
};

static unsigned long state = 88172645463325252u;

static unsigned long next(void) {
    state ^= state << 13;
    state ^= state >> 7;
    return state ^= state << 17;
}

static double uniform(void) {
    return (double)(next() >> 11) * 0x1p-53;
}

static int *permutation(int count, int shuffled) {
    int *place = malloc((size_t)count * sizeof *place);
    for (int i = 0; i < count; i++)
        place[i] = i;
    for (int i = count - 1; shuffled && i > 0; i--) {
        const int j = (int)(next() % (unsigned long)(i + 1)), other = place[j];
        place[j] = place[i];
        place[i] = other;
    }
    return place;
}

/* Blocks: of vertex i number i, of the edge from i to its right, lower and opposite neighbour
 * NODES + 3 i + 0, 1, 2, and `order` lays them out. */
static int block_of(const int *order, int i, int j) {
    if (i == j)
        return order[4 * i];
    const int low = i < j ? i : j, step = i < j ? j - i : i - j;
    return order[4 * low + (step == 1 ? 1 : step == SIDE ? 2 : 3)];
}

static void make_element(struct element *to, const int corner[3], const int *node,
                         const int *block) {
    int count = 0;
    for (int p = 0; p < 3; p++) {
        to->vertex[p] = node[corner[p]];
        for (int q = p; q < 3; q++)
            to->block[count++] = block_of(block, corner[p], corner[q]);
    }
    to->area = 0.5 + 0.01 * uniform();
    for (int p = 0; p < 3; p++) {
        to->u[p] = uniform() - 0.5;
        to->v[p] = uniform() - 0.5;
    }
}

static struct mesh make_mesh(int shuffled) {
    struct mesh m = {.blocks = 4 * NODES};
    int *node = permutation(NODES, shuffled), *place = permutation(TRIANGLES, shuffled);
    int *block = permutation(4 * NODES, shuffled), *edge_place = permutation(MOST_EDGES, shuffled);
    m.x = malloc(sizeof(double[3]) * NODES);
    m.v = malloc(sizeof(double[3]) * NODES);
    m.radius = malloc(sizeof(double) * NODES);
    m.element = malloc(sizeof *m.element * TRIANGLES);
    m.edge = malloc(sizeof(int[2]) * MOST_EDGES);
    m.rest = malloc(sizeof(double) * MOST_EDGES);
    for (int i = 0; i < NODES; i++) {
        const int here = node[i];
        m.x[here][0] = i / SIDE + 0.2 * uniform();
        m.x[here][1] = i % SIDE + 0.2 * uniform();
        m.x[here][2] = uniform();
        for (int c = 0; c < 3; c++)
            m.v[here][c] = uniform() - 0.5;
        m.radius[here] = 0.3 + 0.3 * uniform();
        for (int k = 0; k < 3; k++) { /* at the rim an edge to itself's neighbour within the mesh */
            static const int steps[3] = {1, SIDE, SIDE + 1};
            const int other = i + steps[k] < NODES ? i + steps[k] : i - steps[k];
            int *edge = m.edge[edge_place[3 * i + k]];
            edge[0] = here;
            edge[1] = node[other];
            m.rest[3 * i + k] = 1 + 0.1 * uniform();
        }
    }
    m.edges = MOST_EDGES;
    for (int i = 0; i + 1 < SIDE; i++)
        for (int j = 0; j + 1 < SIDE; j++) {
            const int here = i * SIDE + j, t = 2 * (i * (SIDE - 1) + j);
            const int low[3] = {here, here + 1, here + SIDE + 1};
            const int high[3] = {here, here + SIDE + 1, here + SIDE};
            make_element(&m.element[place[t]], low, node, block);
            make_element(&m.element[place[t + 1]], high, node, block);
        }
    free(node);
    free(place);
    free(block);
    free(edge_place);
    return m;
}

enum { MEMBRANE, CONTACTS, SPRINGS, KERNELS };
static const char *const names[] = {"membrane", "contacts", "springs"};

static double run(int kernel, int translated, const struct mesh *m, double (*b)[3],
                  double (*a)[3][3]) {
    const double(*x)[3] = (const double(*)[3])m->x;
    const double(*v)[3] = (const double(*)[3])m->v;
    const int(*edge)[2] = (const int(*)[2])m->edge;
    const double began = omp_get_wtime();
    switch (kernel) {
    case MEMBRANE:
        (translated ? membrane : serial_membrane)(TRIANGLES, m->element, x, b, a);
        break;
    case CONTACTS:
        (translated ? contacts : serial_contacts)(m->edges, edge, x, v, m->radius, b);
        break;
    default:
        (translated ? springs : serial_springs)(m->edges, edge, m->rest, x, b);
        break;
    }
    return omp_get_wtime() - began;
}

enum { SERIAL, PLAIN, PREFETCH, COURSES };

struct arrays {
    double (*b)[3], (*a)[3][3];
    size_t b_bytes, a_bytes;
};

static double timed(int course, int kernel, const struct mesh *m, struct arrays to) {
    struct settings *settings = (struct settings *)redcc_settings();
    settings->prefetch = course == PREFETCH ? PREFETCH_ON : PREFETCH_OFF;
    double seconds = 0;
    for (int i = 0; i < 2; i++) {
        memset(to.b, 0, to.b_bytes);
        memset(to.a, 0, to.a_bytes);
        seconds = run(kernel, course != SERIAL, m, to.b, to.a);
    }
    return seconds;
}

static int ascending(const void *p, const void *q) {
    const double x = *(const double *)p, y = *(const double *)q;
    return (x > y) - (x < y);
}

/* Prints median, 5th and 95th percentile of above[] over below[]. */
static void print_ratio(const double *above, const double *below, int rounds, int with_spread) {
    double ratio[MOST_ROUNDS];
    for (int r = 0; r < rounds; r++)
        ratio[r] = above[r] / below[r];
    qsort(ratio, (size_t)rounds, sizeof *ratio, ascending);
    printf(",%.3f", ratio[rounds / 2]);
    if (with_spread)
        printf(",%.3f,%.3f", ratio[rounds / 20], ratio[rounds - 1 - rounds / 20]);
}

static int measure(int kernel, const char *order, const struct mesh *m, int rounds) {
    static double seconds[COURSES][MOST_ROUNDS], sorted[MOST_ROUNDS];
    struct arrays of[2];
    for (int i = 0; i < 2; i++) {
        of[i].b_bytes = sizeof(double[3]) * NODES;
        of[i].a_bytes = kernel == MEMBRANE ? sizeof(double[3][3]) * (size_t)m->blocks : 0;
        of[i].b = malloc(of[i].b_bytes);
        of[i].a = malloc(of[i].a_bytes + 1);
    }
    int differ = 0;
    for (int r = 0; r < rounds; r++)
        for (int course = 0; course < COURSES; course++) {
            seconds[course][r] = timed(course, kernel, m, of[course != SERIAL]);
            differ |= course != SERIAL && (memcmp(of[0].b, of[1].b, of[0].b_bytes) != 0 ||
                                           memcmp(of[0].a, of[1].a, of[0].a_bytes) != 0);
        }
    memcpy(sorted, seconds[SERIAL], sizeof sorted);
    qsort(sorted, (size_t)rounds, sizeof *sorted, ascending);
    printf("%s,%s,%d,%.5f", names[kernel], order, omp_get_max_threads(), sorted[rounds / 2]);
    print_ratio(seconds[SERIAL], seconds[PLAIN], rounds, 1);
    print_ratio(seconds[SERIAL], seconds[PREFETCH], rounds, 1);
    print_ratio(seconds[PLAIN], seconds[PREFETCH], rounds, 0);
    printf("%s\n", differ ? ",BITS DIFFER" : "");
    fflush(stdout);
    for (int i = 0; i < 2; i++) {
        free(of[i].b);
        free(of[i].a);
    }
    return differ;
}

static void free_mesh(struct mesh *m) {
    free(m->x);
    free(m->v);
    free(m->radius);
    free(m->rest);
    free(m->element);
    free(m->edge);
}

int main(int argc, char **argv) {
    int rounds = argc > 1 ? atoi(argv[1]) : 15, differ = 0;
    rounds = rounds < 1 ? 1 : rounds > MOST_ROUNDS ? MOST_ROUNDS : rounds;
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        struct mesh m = make_mesh(shuffled);
        for (int kernel = 0; kernel < KERNELS; kernel++)
            differ |= measure(kernel, shuffled ? "shuffled" : "sorted", &m, rounds);
        free_mesh(&m);
    }
    return differ;
}
