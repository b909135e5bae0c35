/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "mesh_sides.h"

#include <stdlib.h>

static int compare(const void *left, const void *right) {
    const mesh_side *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->triangle != b->triangle ? (a->triangle < b->triangle ? -1 : 1)
                                      : a->number - b->number;
}

mesh_side *mesh_sides_new(const mesh *m) {
    const size_t count = 3 * (size_t)m->triangle_count;
    mesh_side *sides = malloc(sizeof *sides * (count + 1));
    if (!sides)
        return NULL;
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            const int a = m->triangle[t][p], b = m->triangle[t][(p + 1) % 3];
            sides[3 * t + p] = (mesh_side){a < b ? a : b, a < b ? b : a, t, p};
        }
    qsort(sides, count, sizeof *sides, compare);
    return sides;
}

int mesh_sides_together(const mesh_side *first, int count) {
    int together = 1;
    while (together < count && first[together].low == first->low &&
           first[together].high == first->high)
        together++;
    return together;
}
