/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "lanes_data.h"

#include <stdlib.h>

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

/* Blocks: of node i number 4 i, of the edge from i to its right, lower and opposite neighbour
 * 4 i + 1, 2, 3, and `order` lays them out. */
static int block_of(const int *order, int side, int i, int j) {
    if (i == j)
        return order[4 * i];
    const int low = i < j ? i : j, step = i < j ? j - i : i - j;
    return order[4 * low + (step == 1 ? 1 : step == side ? 2 : 3)];
}

static void make_element(struct element *to, int side, const int corner[3], const int *node,
                         const int *block) {
    int count = 0;
    for (int p = 0; p < 3; p++) {
        to->vertex[p] = node[corner[p]];
        for (int q = p; q < 3; q++)
            to->block[count++] = block_of(block, side, corner[p], corner[q]);
    }
    to->area = 0.5 + 0.01 * uniform();
    for (int p = 0; p < 3; p++) {
        to->u[p] = uniform() - 0.5;
        to->v[p] = uniform() - 0.5;
    }
}

static void make_nodes(struct mesh *m, const int *node) {
    m->x = malloc(sizeof(double[3]) * (size_t)m->nodes);
    m->v = malloc(sizeof(double[3]) * (size_t)m->nodes);
    m->float_x = malloc(sizeof(float[3]) * (size_t)m->nodes);
    m->radius = malloc(sizeof(double) * (size_t)m->nodes);
    m->single = malloc(sizeof(double) * (size_t)m->nodes);
    for (int i = 0; i < m->nodes; i++) {
        const int here = node[i];
        m->x[here][0] = i / m->side + 0.2 * uniform();
        m->x[here][1] = i % m->side + 0.2 * uniform();
        m->x[here][2] = uniform();
        for (int c = 0; c < 3; c++)
            m->v[here][c] = uniform() - 0.5;
        for (int c = 0; c < 3; c++)
            m->float_x[here][c] = (float)m->x[here][c];
        m->radius[here] = 0.3 + 0.3 * uniform();
        m->single[here] = uniform();
    }
}

static void make_edges(struct mesh *m, const int *node, int shuffled) {
    int *place = permutation(m->edges, shuffled);
    m->edge = malloc(sizeof(int[2]) * (size_t)m->edges);
    m->rest = malloc(sizeof(double) * (size_t)m->edges);
    for (int i = 0; i < m->nodes; i++)
        for (int k = 0; k < 3; k++) { /* at the border to a neighbour within the mesh */
            const int step = k == 0 ? 1 : k == 1 ? m->side : m->side + 1;
            const int other = i + step < m->nodes ? i + step : i - step;
            int *edge = m->edge[place[3 * i + k]];
            edge[0] = node[i];
            edge[1] = node[other];
            m->rest[3 * i + k] = 1 + 0.1 * uniform();
        }
    free(place);
}

static void make_elements(struct mesh *m, const int *node, int shuffled) {
    int *place = permutation(m->triangles, shuffled), *block = permutation(4 * m->nodes, shuffled);
    int *square = permutation(m->tetrahedra, shuffled);
    const int side = m->side;
    m->element = malloc(sizeof *m->element * (size_t)m->triangles);
    m->corner = malloc(sizeof(int[4]) * (size_t)m->tetrahedra);
    for (int i = 0; i + 1 < side; i++)
        for (int j = 0; j + 1 < side; j++) {
            const int here = i * side + j, s = i * (side - 1) + j;
            const int low[3] = {here, here + 1, here + side + 1};
            const int high[3] = {here, here + side + 1, here + side};
            make_element(&m->element[place[2 * s]], side, low, node, block);
            make_element(&m->element[place[2 * s + 1]], side, high, node, block);
            int *corner = m->corner[square[s]];
            corner[0] = node[here];
            corner[1] = node[here + 1];
            corner[2] = node[here + side];
            corner[3] = node[here + side + 1];
        }
    free(place);
    free(block);
    free(square);
}

static int by_number(const void *p, const void *q) {
    return (*(const int *)p > *(const int *)q) - (*(const int *)p < *(const int *)q);
}

/* Of each row the columns within `reach` squares in each direction, `later` ones alone. */
static struct pattern make_pattern(const struct mesh *m, const int *node, int only_later) {
    struct pattern it = {malloc(sizeof(int) * ((size_t)m->nodes + 1)),
                         malloc(sizeof(int) * 9 * (size_t)m->nodes)};
    int *grid = malloc(sizeof(int) * (size_t)m->nodes), count = 0;
    for (int i = 0; i < m->nodes; i++)
        grid[node[i]] = i;
    for (int row = 0; row < m->nodes; row++) {
        const int y = grid[row] / m->side, x = grid[row] % m->side;
        it.start[row] = count;
        for (int d = 0; d < 9; d++) {
            const int ny = y + d / 3 - 1, nx = x + d % 3 - 1;
            if (ny < 0 || nx < 0 || ny >= m->side || nx >= m->side)
                continue;
            const int column = node[ny * m->side + nx];
            if (!only_later || column >= row)
                it.column[count++] = column;
        }
        qsort(it.column + it.start[row], (size_t)(count - it.start[row]), sizeof(int), by_number);
    }
    it.start[m->nodes] = count;
    free(grid);
    return it;
}

struct mesh make_mesh(int side, int shuffled) {
    struct mesh m = {.side = side, .nodes = side * side, .edges = 3 * side * side};
    m.tetrahedra = (side - 1) * (side - 1);
    m.triangles = 2 * m.tetrahedra;
    int *node = permutation(m.nodes, shuffled);
    make_nodes(&m, node);
    make_edges(&m, node, shuffled);
    make_elements(&m, node, shuffled);
    m.blocks = make_pattern(&m, node, 0);
    m.upper = make_pattern(&m, node, 1);
    m.value = malloc(sizeof(double) * (size_t)m.upper.start[m.nodes]);
    for (int k = 0; k < m.upper.start[m.nodes]; k++)
        m.value[k] = uniform() - 0.5;
    free(node);
    return m;
}

void free_mesh(struct mesh *m) {
    void *const all[] = {m->x,     m->v,      m->radius,       m->element,       m->edge,
                         m->rest,  m->corner, m->blocks.start, m->blocks.column, m->upper.start,
                         m->value, m->single, m->upper.column, m->float_x};
    for (unsigned i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
}
