/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "input/mesh_file.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "output/obj.h"

enum { ERROR_SIZE = 256, PLACE_SIZE = 64 };

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

/** Writes "triangle 3 (line 12)", both counted from 1. */
static void name_place(const char *path, int triangle, char place[PLACE_SIZE]) {
    const long line = obj_triangle_line(path, triangle);
    if (line > 0)
        snprintf(place, PLACE_SIZE, "triangle %d (line %ld)", triangle + 1, line);
    else
        snprintf(place, PLACE_SIZE, "triangle %d", triangle + 1);
}

static void complain(const char *path, const surface_fault *fault, char *error) {
    char place[PLACE_SIZE], other[PLACE_SIZE];
    if (fault->triangle < 0) {
        snprintf(error, ERROR_SIZE, "%s", fault->what);
        return;
    }
    name_place(path, fault->triangle, place);
    name_place(path, fault->other, other);
    snprintf(error, ERROR_SIZE, "%s %s; the other is %s", place, fault->what, other);
}

surface *surface_read(const char *path, char *error) {
    surface_fault fault;
    surface *made = NULL;
    mesh m = {0};
    if (mesh_file_read(&m, path) != 0)
        snprintf(error, ERROR_SIZE, "it cannot be read");
    else if (surface_check(&m, &fault) != 0)
        snprintf(error, ERROR_SIZE, "out of memory");
    else if (fault.what)
        complain(path, &fault, error);
    else
        made = surface_new(&m, error);
    mesh_free(&m);
    return made;
}
