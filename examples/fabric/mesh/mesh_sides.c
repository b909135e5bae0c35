/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "mesh_sides.h"

#include <assert.h>
#include <stdlib.h>

/* Order for qsort of sides with the same lower vertex: by higher vertex, then by triangle. */
static int compare(const void *left, const void *right) {
    const mesh_side *a = left, *b = right;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->triangle != b->triangle ? (a->triangle < b->triangle ? -1 : 1)
                                      : a->number - b->number;
}

/* Sorts the sides by their lower vertex: those with lower vertex v begin at sides[start[v]] and end
 * before sides[start[v + 1]]. start: [vertex_count + 1], zeroed. */
static void collect(const mesh *m, mesh_side *sides, int *start) {
    for (int t = 0; t < m->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int a = m->triangle[t][k], b = m->triangle[t][(k + 1) % 3];
            start[a < b ? a : b]++;
        }
    for (int v = 0, sum = 0; v <= m->vertex_count; v++) {
        sum += start[v];
        start[v] = sum;
    }
    for (int t = m->triangle_count - 1; t >= 0; t--)
        for (int k = 2; k >= 0; k--) {
            const int a = m->triangle[t][k], b = m->triangle[t][(k + 1) % 3];
            const int low = a < b ? a : b;
            sides[--start[low]] = (mesh_side){low, a < b ? b : a, t, k};
        }
    assert(start[0] == 0 && start[m->vertex_count] == 3 * m->triangle_count);
}

mesh_side *mesh_sides_new(const mesh *m) {
    mesh_side *sides = malloc(sizeof *sides * (3 * (size_t)m->triangle_count + 1));
    int *start = calloc((size_t)m->vertex_count + 1, sizeof *start);
    if (sides && start) {
        collect(m, sides, start);
        for (int v = 0; v < m->vertex_count; v++)
            qsort(sides + start[v], (size_t)(start[v + 1] - start[v]), sizeof *sides, compare);
    } else {
        free(sides);
        sides = NULL;
    }
    free(start);
    return sides;
}

int mesh_sides_together(const mesh_side *first, int count) {
    assert(count >= 1);
    int together = 1;
    while (together < count && first[together].low == first->low &&
           first[together].high == first->high)
        together++;
    return together;
}
