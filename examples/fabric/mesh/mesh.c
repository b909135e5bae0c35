/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A mesh's memory, and the edges and hinges that follow from its triangles. */
#include "mesh.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/vector.h"
#include "mesh_parts.h"
#include "mesh_sides.h"

enum { ERROR_SIZE = 256 };

int mesh_allocate(mesh *m, int vertices, int triangles) {
    assert(vertices >= 0 && triangles >= 0);
    *m = (mesh){.vertex_count = vertices, .triangle_count = triangles};
    m->position = calloc((size_t)vertices, sizeof *m->position);
    m->material = calloc((size_t)vertices, sizeof *m->material);
    m->triangle = calloc((size_t)triangles, sizeof *m->triangle);
    if (m->position && m->material && m->triangle)
        return 0;
    mesh_free(m);
    return -1;
}

void mesh_free(mesh *m) {
    free(m->position);
    free(m->material);
    free(m->triangle);
    free(m->edge);
    free(m->hinge);
    free(m->number);
    *m = (mesh){0};
}

/** Appends the edge in which `count` sides coincide, and its hinge if it has one. */
static void add_edge(mesh *m, const mesh_side *sides, int count) {
    assert(count >= 1 && sides[0].low < sides[0].high && sides[0].high < m->vertex_count);
    int *edge = m->edge[m->edge_count++];
    edge[0] = sides[0].low;
    edge[1] = sides[0].high;
    if (count < 2)
        return;
    /* Wing 2 is on the left of the edge, wing 3 on its right, if both triangles have the same
     * orientation. */
    int *hinge = m->hinge[m->hinge_count++];
    const int left = mesh_side_ascends(m, &sides[0]) || !mesh_side_ascends(m, &sides[1]) ? 0 : 1;
    hinge[0] = edge[0];
    hinge[1] = edge[1];
    hinge[2] = mesh_side_wing(m, &sides[left]);
    hinge[3] = mesh_side_wing(m, &sides[1 - left]);
}

int mesh_connect(mesh *m, int *non_manifold, char *error) {
    const int side_count = 3 * m->triangle_count;
    mesh_side *sides = mesh_sides_new(m);
    free(m->edge);
    free(m->hinge);
    m->edge_count = m->hinge_count = 0;
    m->edge = malloc((size_t)side_count * sizeof *m->edge);
    m->hinge = malloc((size_t)side_count / 2 * sizeof *m->hinge);
    *non_manifold = 0;
    if (!sides || !m->edge || !m->hinge) {
        free(m->edge);
        free(m->hinge);
        free(sides);
        m->edge = NULL;
        m->hinge = NULL;
        snprintf(error, ERROR_SIZE, "out of memory");
        return -1;
    }
    for (int i = 0, together; i < side_count; i += together) {
        together = mesh_sides_together(&sides[i], side_count - i);
        add_edge(m, &sides[i], together);
        *non_manifold += together > 2;
    }
    assert(m->edge_count <= side_count && m->hinge_count <= side_count / 2);
    free(sides);
    return 0;
}

double mesh_mean_edge(const mesh *m) {
    double sum = 0;
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            double side[3];
            const int *v = m->triangle[t];
            vector_subtract(m->position[v[p]], m->position[v[(p + 1) % 3]], side);
            sum += vector_length(side);
        }
    return m->triangle_count > 0 ? sum / (3.0 * m->triangle_count) : INFINITY;
}
