/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Defects of meshes that cloth must not have. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "base/vector.h"
#include "mesh_rest.h"

enum { ERROR_SIZE = 256 };

const char *mesh_problem_name(int problem) {
    assert(problem >= 0 && problem < MESH_PROBLEM_COUNT);
    static const char *const names[MESH_PROBLEM_COUNT] = {
        [MESH_FLAT_TRIANGLE] = "triangles without area, which carry no force",
        [MESH_NO_MATERIAL] = "triangles without material coordinates, taken as they start",
        [MESH_FLIPPED] = "triangles folded over their neighbours",
        [MESH_SEAM] = "vertices in the place of another one, where the cloth is open",
        [MESH_LONE_VERTEX] = "vertices of no triangle, held in place",
        [MESH_NON_MANIFOLD] = "edges of more than two triangles, which bend at the first two",
        [MESH_DUPLICATE] = "triangles that are there twice, removed",
        [MESH_REPEATED_VERTEX] = "triangles with a vertex twice, removed"};
    return names[problem];
}

static void note(mesh_problem *found, int problem, int number) {
    assert(problem >= 0 && problem < MESH_PROBLEM_COUNT);
    if (found[problem].count++ == 0)
        found[problem].first = number;
}

int mesh_check_numbers(const mesh *m, char *error) {
    for (int v = 0; v < m->vertex_count; v++) {
        const double *at = m->position[v], *flat = m->material[v];
        if (isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2]) && isfinite(flat[0]) &&
            isfinite(flat[1]))
            continue;
        snprintf(error, ERROR_SIZE, "vertex %d has a coordinate that is not finite", v + 1);
        return -1;
    }
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++)
            if (m->triangle[t][p] < 0 || m->triangle[t][p] >= m->vertex_count) {
                snprintf(error, ERROR_SIZE, "triangle %d names vertex %d of %d", t + 1,
                         m->triangle[t][p] + 1, m->vertex_count);
                return -1;
            }
    return 0;
}

/** A triangle's vertices, ascending, and its index. */
typedef struct sorted_triangle {
    int vertex[3];
    int number;
} sorted_triangle;

static int compare(const void *left, const void *right) {
    const sorted_triangle *a = left, *b = right;
    for (int p = 0; p < 3; p++)
        if (a->vertex[p] != b->vertex[p])
            return a->vertex[p] < b->vertex[p] ? -1 : 1;
    return a->number < b->number ? -1 : 1;
}

static sorted_triangle sorted(const int corner[3], int number) {
    sorted_triangle s = {{corner[0], corner[1], corner[2]}, number};
    for (int p = 0; p < 2; p++)
        for (int q = 0; q < 2 - p; q++)
            if (s.vertex[q] > s.vertex[q + 1]) {
                const int swap = s.vertex[q];
                s.vertex[q] = s.vertex[q + 1];
                s.vertex[q + 1] = swap;
            }
    assert(s.vertex[0] <= s.vertex[1] && s.vertex[1] <= s.vertex[2]);
    return s;
}

/* Marks in `removed` all copies of a triangle but the first, and triangles with a vertex twice. */
static int mark(const mesh *m, mesh_problem *found, unsigned char *removed) {
    sorted_triangle *all = malloc(((size_t)m->triangle_count + 1) * sizeof *all);
    if (!all)
        return -1;
    for (int t = 0; t < m->triangle_count; t++)
        all[t] = sorted(m->triangle[t], t);
    qsort(all, (size_t)m->triangle_count, sizeof *all, compare);
    for (int k = 0; k < m->triangle_count; k++) {
        const int *v = all[k].vertex;
        if (v[0] == v[1] || v[1] == v[2])
            note(found, MESH_REPEATED_VERTEX, all[k].number);
        else if (k > 0 && memcmp(v, all[k - 1].vertex, sizeof all[k].vertex) == 0)
            note(found, MESH_DUPLICATE, all[k].number);
        else
            continue;
        removed[all[k].number] = 1;
    }
    free(all);
    return 0;
}

int mesh_clean(mesh *m, mesh_problem *found, char *error) {
    for (int k = 0; k < MESH_PROBLEM_COUNT; k++)
        found[k] = (mesh_problem){0, -1};
    if (mesh_check_numbers(m, error) != 0)
        return -1;
    unsigned char *removed = calloc((size_t)m->triangle_count + 1, 1);
    if (!removed || mark(m, found, removed) != 0) {
        free(removed);
        snprintf(error, ERROR_SIZE, "out of memory");
        return -1;
    }
    int kept = 0;
    for (int t = 0; t < m->triangle_count; t++)
        if (!removed[t])
            memmove(m->triangle[kept++], m->triangle[t], sizeof *m->triangle);
    m->triangle_count = kept;
    free(removed);
    if (kept > 0)
        return 0;
    snprintf(error, ERROR_SIZE, "no triangle is left");
    return -1;
}

static void doubled_area(const mesh *m, int t, double area[3]) {
    const int *v = m->triangle[t];
    vector_normal(m->position[v[0]], m->position[v[1]], m->position[v[2]], area);
}

/* A triangle is folded over its neighbours if its normal points away from the sum, over its three
 * corners, of the other triangles' normals. around: [vertices], zeroed. */
static void check_folds(const mesh *m, mesh_problem *found, double (*around)[3]) {
    for (int t = 0; t < m->triangle_count; t++) {
        double area[3];
        doubled_area(m, t, area);
        for (int p = 0; p < 3; p++)
            vector_add_scaled(around[m->triangle[t][p]], 1, area, around[m->triangle[t][p]]);
    }
    for (int t = 0; t < m->triangle_count; t++) {
        double area[3], others = 0;
        doubled_area(m, t, area);
        for (int p = 0; p < 3; p++)
            others += vector_dot(around[m->triangle[t][p]], area) - vector_dot(area, area);
        if (others < 0)
            note(found, MESH_FLIPPED, t);
    }
}

static void check_triangles(const mesh *m, mesh_problem *found, unsigned char *used) {
    for (int t = 0; t < m->triangle_count; t++) {
        const int *v = m->triangle[t];
        double uv[3][2];
        const mesh_rest_kind kind = mesh_rest_triangle(m, v[0], v[1], v[2], uv);
        if (kind == MESH_REST_NONE)
            note(found, MESH_FLAT_TRIANGLE, t);
        else if (kind == MESH_REST_POSITION && !m->rest_in_space)
            note(found, MESH_NO_MATERIAL, t);
        used[v[0]] = used[v[1]] = used[v[2]] = 1;
    }
    for (int v = 0; v < m->vertex_count; v++)
        if (!used[v])
            note(found, MESH_LONE_VERTEX, v);
}

/** A vertex's position and index. */
typedef struct place {
    double at[3];
    int vertex;
} place;

static int compare_places(const void *left, const void *right) {
    const place *a = left, *b = right;
    for (int k = 0; k < 3; k++)
        if (a->at[k] < b->at[k] || a->at[k] > b->at[k])
            return a->at[k] < b->at[k] ? -1 : 1;
    return a->vertex < b->vertex ? -1 : 1;
}

/* Counts vertices at the same position. Programs that write one vertex per triangle or texture
 * coordinate leave such unjoined seams, at which cloth separates. places, twin: [vertices]. */
static void check_seams(const mesh *m, mesh_problem *found, place *places, unsigned char *twin) {
    for (int v = 0; v < m->vertex_count; v++) {
        memcpy(places[v].at, m->position[v], sizeof places[v].at);
        places[v].vertex = v;
    }
    qsort(places, (size_t)m->vertex_count, sizeof *places, compare_places);
    for (int k = 1; k < m->vertex_count; k++) {
        const double *a = places[k - 1].at, *b = places[k].at;
        twin[places[k].vertex] = a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    }
    for (int v = 0; v < m->vertex_count; v++)
        if (twin[v])
            note(found, MESH_SEAM, v);
}

int mesh_check(const mesh *m, mesh_problem *found) {
    arrays own = {0};
    place *places = arrays_add(&own, (size_t)m->vertex_count + 1, sizeof *places);
    double(*around)[3] = arrays_add(&own, (size_t)m->vertex_count + 1, sizeof *around);
    unsigned char *used = arrays_add(&own, (size_t)m->vertex_count + 1, 1);
    unsigned char *twin = arrays_add(&own, (size_t)m->vertex_count + 1, 1);
    if (!own.failed) {
        check_triangles(m, found, used);
        check_folds(m, found, around);
        check_seams(m, found, places, twin);
    }
    arrays_free(&own);
    return own.failed ? -1 : 0;
}
