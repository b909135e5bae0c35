/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "scene_sheet.h"

#include <stdlib.h>
#include <string.h>

#include "input/mesh_file.h"
#include "mesh/mesh_parts.h"

/** All in one plane of z: x and y are then the flat cloth's own coordinates. */
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
    m->rest_in_space = rest == REST_POSITIONS; /* as for the checks; vt is kept */
    if (mesh_file_prepare(m, path, found, error) == 0)
        return m;
    mesh_free(m);
    free(m);
    return NULL;
}

int scene_sheet_copy(const scene *s, mesh *m) {
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
