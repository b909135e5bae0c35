/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "input/mesh_file.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "output/obj.h"

enum { ERROR_SIZE = 256 };

int mesh_file_read(mesh *m, const char *path) {
    const char *dot = strrchr(path, '.');
    if (dot && strcasecmp(dot, ".obj") == 0)
        return obj_read(m, path);
    *m = (mesh){0};
    fprintf(stderr,
            "%s: not an OBJ file by its name, expected .obj; Blender and MeshLab convert other "
            "meshes\n",
            path);
    return -1;
}

static void print_problems(const mesh_problem *found, const char *name) {
    for (int k = 0; k < MESH_PROBLEM_COUNT; k++)
        if (found[k].count > 0) {
            fprintf(stderr, "%s: %d %s", name, found[k].count, mesh_problem_name(k));
            if (found[k].first >= 0)
                fprintf(stderr, "; the first is number %d", found[k].first + 1);
            fputc('\n', stderr);
        }
}

int mesh_file_prepare(mesh *m, const char *name, mesh_problem *found, char *error) {
    int non_manifold;
    if (mesh_clean(m, found, error) != 0 || mesh_connect(m, &non_manifold, error) != 0)
        return -1;
    found[MESH_NON_MANIFOLD].count = non_manifold;
    if (mesh_check(m, found) == 0) {
        print_problems(found, name);
        return 0;
    }
    snprintf(error, ERROR_SIZE, "out of memory");
    return -1;
}
