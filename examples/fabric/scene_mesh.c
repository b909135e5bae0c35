/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The cloth of a scene: generated, put where the scene wants it, numbered as it wants. */
#include "scene.h"

#include <math.h>

/** Unit vectors of the sheet's plane: `right` horizontal, `up` as far up as the plane allows; in a
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
    plane_axes(s->normal, right, up);
    for (int v = 0; v < m->vertex_count; v++)
        for (int k = 0; k < 3; k++)
            m->position[v][k] =
                s->origin[k] + m->material[v][0] * right[k] + m->material[v][1] * up[k];
}

int scene_mesh(const scene *s, mesh *m, int *new_of_old, char *error) {
    int non_manifold;
    if (mesh_generate(m, s->vertices, s->boundary, s->side, s->seed, error) != 0)
        return -1;
    place(s, m);
    if (mesh_connect(m, &non_manifold, error) == 0 &&
        mesh_reorder(m, s->order, s->seed, new_of_old, error) == 0)
        return 0;
    mesh_free(m);
    return -1;
}
