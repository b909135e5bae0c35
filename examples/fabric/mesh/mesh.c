/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A mesh's memory, and the edges and hinges that follow from its triangles. */
#include "mesh.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/vector.h"
#include "mesh_parts.h"

enum { ERROR_SIZE = 256 };

/** A triangle's side, seen from its lower vertex. */
typedef struct half_edge {
    int low, high; /* the side's vertices, low < high */
    int wing;      /* the triangle's third vertex */
    int forward;   /* the triangle runs from low to high */
} half_edge;

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

/** Sides by their lower vertex: those of vertex v at sides[start[v]] .. sides[start[v + 1] - 1],
 *  in the order of their triangles. start: [vertex_count + 1], zeroed. */
static void collect_sides(const mesh *m, half_edge *sides, int *start) {
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
            sides[--start[low]] =
                (half_edge){low, a < b ? b : a, m->triangle[t][(k + 2) % 3], a < b};
        }
}

/** Insertion sort by the higher vertex: stable, and a vertex has few sides. */
static void sort_by_high(half_edge *sides, int count) {
    for (int i = 1; i < count; i++) {
        const half_edge moving = sides[i];
        int k = i;
        for (; k > 0 && sides[k - 1].high > moving.high; k--)
            sides[k] = sides[k - 1];
        sides[k] = moving;
    }
}

/** One edge from the `count` sides that coincide in it, and its hinge if it has one. */
static void add_edge(mesh *m, const half_edge *sides, int count) {
    assert(count >= 1 && sides[0].low < sides[0].high && sides[0].high < m->vertex_count);
    int *edge = m->edge[m->edge_count++];
    edge[0] = sides[0].low;
    edge[1] = sides[0].high;
    if (count < 2)
        return;
    /* Wing 2 is left of the edge, wing 3 right, if the triangles have the same orientation. */
    int *hinge = m->hinge[m->hinge_count++];
    const int left = sides[0].forward || !sides[1].forward ? 0 : 1;
    hinge[0] = edge[0];
    hinge[1] = edge[1];
    hinge[2] = sides[left].wing;
    hinge[3] = sides[1 - left].wing;
}

static void join_sides(mesh *m, half_edge *sides, const int *start, int *non_manifold) {
    for (int v = 0; v < m->vertex_count; v++) {
        sort_by_high(sides + start[v], start[v + 1] - start[v]);
        for (int i = start[v], next; i < start[v + 1]; i = next) {
            for (next = i + 1; next < start[v + 1] && sides[next].high == sides[i].high;)
                next++;
            add_edge(m, sides + i, next - i);
            *non_manifold += next - i > 2;
        }
    }
}

int mesh_connect(mesh *m, int *non_manifold, char *error) {
    const size_t side_count = 3 * (size_t)m->triangle_count;
    half_edge *sides = malloc(side_count * sizeof *sides);
    int *start = calloc((size_t)m->vertex_count + 1, sizeof *start);
    free(m->edge);
    free(m->hinge);
    m->edge_count = m->hinge_count = 0;
    m->edge = malloc(side_count * sizeof *m->edge);
    m->hinge = malloc(side_count / 2 * sizeof *m->hinge);
    *non_manifold = 0;
    int status = -1;
    if (sides && start && m->edge && m->hinge) {
        collect_sides(m, sides, start);
        assert(start[0] == 0 && (size_t)start[m->vertex_count] == side_count);
        join_sides(m, sides, start, non_manifold);
        assert((size_t)m->edge_count <= side_count && m->hinge_count <= m->edge_count);
        status = 0;
    } else {
        free(m->edge);
        free(m->hinge);
        m->edge = NULL;
        m->hinge = NULL;
        snprintf(error, ERROR_SIZE, "out of memory");
    }
    free(sides);
    free(start);
    return status;
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
