/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "surface_check.h"

#include <stdlib.h>

#include "vector.h"

/** A side of a triangle: its vertices ascending, and whether the triangle goes from low to high. */
typedef struct side {
    int low, high, opposite, triangle, ascends;
} side;

static int compare_sides(const void *left, const void *right) {
    const side *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static void list_sides(const mesh *m, side *sides) {
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            const int *v = m->triangle[t];
            const int a = v[p], b = v[(p + 1) % 3];
            sides[3 * t + p] = (side){a < b ? a : b, a < b ? b : a, v[(p + 2) % 3], t, a < b};
        }
}

/* Of an edge with all its `count` triangles. */
static void check_edge(const side *of, int count, surface_fault *fault) {
    for (int k = 1; k < count; k++)
        if (of[k].opposite == of[0].opposite) {
            *fault = (surface_fault){"has the three vertices of another, expected each once",
                                     of[k].triangle, of[0].triangle};
            return;
        }
    if (count > 2)
        *fault = (surface_fault){"is the third at an edge, expected two at most", of[2].triangle,
                                 of[0].triangle};
    else if (count == 2 && of[0].ascends == of[1].ascends)
        *fault = (surface_fault){
            "faces the other way than its neighbour, expected all counter-clockwise from outside",
            of[1].triangle, of[0].triangle};
}

/* Six times the volume, seen from the first vertex, so that a solid far away loses no digits. */
static double volume(const mesh *m) {
    const double *from = m->position[m->triangle[0][0]];
    double sum = 0;
    for (int t = 0; t < m->triangle_count; t++) {
        double corner[3][3], cross[3];
        for (int p = 0; p < 3; p++)
            vector_subtract(m->position[m->triangle[t][p]], from, corner[p]);
        vector_cross(corner[1], corner[2], cross);
        sum += vector_dot(corner[0], cross);
    }
    return sum;
}

int surface_check(const mesh *m, surface_fault *fault) {
    const int count = 3 * m->triangle_count;
    int closed = 1;
    side *sides = malloc(sizeof *sides * ((size_t)count + 1));
    *fault = (surface_fault){NULL, -1, -1};
    if (!sides)
        return -1;
    list_sides(m, sides);
    qsort(sides, (size_t)count, sizeof *sides, compare_sides);
    for (int i = 0, next; i < count && !fault->what; i = next) {
        for (next = i + 1;
             next < count && sides[next].low == sides[i].low && sides[next].high == sides[i].high;
             next++) {
        }
        closed = closed && next - i == 2;
        check_edge(&sides[i], next - i, fault);
    }
    free(sides);
    if (!fault->what && closed && volume(m) < 0)
        fault->what = "all triangles face inwards, expected counter-clockwise seen from outside";
    return 0;
}
