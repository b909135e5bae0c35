/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The cloth of a scene: generated or from a file, placed and numbered according to the scene. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/mesh_file.h"
#include "mesh/mesh_parts.h"
#include "scene_keys.h"

enum { ERROR_SIZE = 256 };

/** Unit vectors of the sheet's plane: `right` is horizontal, `up` the steepest direction; in a
 *  horizontal plane `right` is x. right x up = normal. */
static void plane_axes(const double normal[3], double right[3], double up[3]) {
    const double horizontal = sqrt(normal[0] * normal[0] + normal[1] * normal[1]);
    right[0] = horizontal > 1e-9 ? -normal[1] / horizontal : 1.0;
    right[1] = horizontal > 1e-9 ? normal[0] / horizontal : 0.0;
    right[2] = 0.0;
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        up[k] = normal[i] * right[j] - normal[j] * right[i];
    }
}

static void place(const scene *s, mesh *m) {
    double right[3], up[3];
    plane_axes(s->mesh.normal, right, up);
    for (int v = 0; v < m->vertex_count; v++)
        for (int k = 0; k < 3; k++)
            m->position[v][k] =
                s->mesh.origin[k] + m->material[v][0] * right[k] + m->material[v][1] * up[k];
}

/** Places a cloth that need not be flat: its z axis becomes the normal. */
static void place_in_space(const scene *s, mesh *m) {
    double right[3], up[3];
    plane_axes(s->mesh.normal, right, up);
    for (int v = 0; v < m->vertex_count; v++) {
        const double p[3] = {m->position[v][0], m->position[v][1], m->position[v][2]};
        for (int k = 0; k < 3; k++)
            m->position[v][k] =
                s->mesh.origin[k] + p[0] * right[k] + p[1] * up[k] + p[2] * s->mesh.normal[k];
    }
}

/** Do all vertices have the same z? Then x and y are the cloth's material coordinates. */
static int is_level(const mesh *m) {
    for (int v = 1; v < m->vertex_count; v++)
        if (m->position[v][2] < m->position[0][2] || m->position[v][2] > m->position[0][2])
            return 0;
    return 1;
}

static void choose_rest(mesh *m, int rest) {
    m->rest_in_space = rest == REST_POSITIONS && !is_level(m);
    for (int v = 0; rest == REST_POSITIONS && v < m->vertex_count; v++)
        memcpy(m->material[v], m->position[v], sizeof *m->material);
}

mesh *scene_sheet_read(const char *path, int rest, char *error) {
    mesh_problem found[MESH_PROBLEM_COUNT];
    mesh *m = calloc(1, sizeof *m);
    if (!m || mesh_file_read(m, path) != 0) {
        free(m);
        return NULL;
    }
    m->rest_in_space = rest == REST_POSITIONS; /* the checks need it; texture coordinates stay as
                                                * they are */
    if (mesh_file_prepare(m, path, found, error) == 0)
        return m;
    mesh_free(m);
    free(m);
    return NULL;
}

/** Copies the scene's sheet, converted to metres, at the file's positions and with the rest shape
 *  that the scene requests. Returns 0, or -1 if out of memory. */
static int copy_sheet(const scene *s, mesh *m) {
    const mesh *from = s->mesh.sheet;
    if (mesh_allocate(m, from->vertex_count, from->triangle_count) != 0)
        return -1;
    memcpy(m->triangle, from->triangle, (size_t)from->triangle_count * sizeof *m->triangle);
    for (int v = 0; v < m->vertex_count; v++) {
        for (int a = 0; a < 3; a++)
            m->position[v][a] = s->mesh.scale * from->position[v][a];
        for (int a = 0; a < 2; a++)
            m->material[v][a] = s->mesh.scale * from->material[v][a];
    }
    choose_rest(m, s->mesh.rest);
    m->bent_at_rest = s->mesh.rest_angles == ANGLES_OF_MESH;
    return 0;
}

static int make_sheet(const scene *s, mesh *m, char *error) {
    if (s->mesh.from == SHEET_GENERATED) {
        if (mesh_generate(m, s->mesh.vertices, s->mesh.boundary, s->mesh.side, s->mesh.seed,
                          error) != 0)
            return -1;
        place(s, m);
        return 0;
    }
    if (copy_sheet(s, m) == 0) {
        place_in_space(s, m);
        return 0;
    }
    snprintf(error, ERROR_SIZE, "out of memory");
    return -1;
}

/** Stores the vertex numbers before reordering if pins refer to them. Returns 0, or -1 if out of
 *  memory. */
static int keep_numbers(const scene *s, mesh *m) {
    int wanted = 0;
    for (int k = 0; k < s->pin_count; k++)
        wanted += s->pins[k].by == PIN_VERTICES || s->pins[k].by == PIN_NEAREST;
    if (wanted == 0)
        return 0;
    m->number = malloc((size_t)m->vertex_count * sizeof *m->number);
    for (int v = 0; m->number && v < m->vertex_count; v++)
        m->number[v] = v;
    return m->number ? 0 : -1;
}

int scene_mesh(const scene *s, mesh *m, int *new_of_old) {
    char error[ERROR_SIZE] = "out of memory";
    int non_manifold;
    *m = (mesh){0};
    if (make_sheet(s, m, error) == 0 && keep_numbers(s, m) == 0 &&
        mesh_connect(m, &non_manifold, error) == 0 &&
        mesh_reorder(m, s->mesh.order, s->mesh.seed, new_of_old, error) == 0)
        return 0;
    fprintf(stderr, "%s: mesh: %s\n", s->name, error);
    mesh_free(m);
    return -1;
}
