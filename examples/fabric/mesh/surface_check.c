/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "surface.h"

#include <stdlib.h>

#include "base/vector.h"
#include "mesh_sides.h"

/* Checks an edge whose `count` triangles have the sides of[0 ..]. */
static void check_edge(const mesh *m, const mesh_side *of, int count, surface_fault *fault) {
    for (int k = 1; k < count; k++)
        if (mesh_side_wing(m, &of[k]) == mesh_side_wing(m, &of[0])) {
            *fault = (surface_fault){"has the three vertices of another, expected each once",
                                     of[k].triangle, of[0].triangle};
            return;
        }
    if (count > 2)
        *fault = (surface_fault){"is the third at an edge, expected two at most", of[2].triangle,
                                 of[0].triangle};
    else if (count == 2 && mesh_side_ascends(m, &of[0]) == mesh_side_ascends(m, &of[1]))
        *fault = (surface_fault){
            "faces the other way than its neighbour, expected all counter-clockwise from outside",
            of[1].triangle, of[0].triangle};
}

/* Returns six times the volume. It is computed relative to the first vertex, so that a solid far
 * away loses no digits. */
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
    mesh_side *sides = mesh_sides_new(m);
    *fault = (surface_fault){NULL, -1, -1};
    if (!sides)
        return -1;
    for (int i = 0, together; i < count && !fault->what; i += together) {
        together = mesh_sides_together(&sides[i], count - i);
        closed = closed && together == 2;
        check_edge(m, &sides[i], together, fault);
    }
    free(sides);
    if (!fault->what && closed && volume(m) < 0)
        fault->what = "all triangles face inwards, expected counter-clockwise seen from outside";
    return 0;
}
