/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "input/mesh_file.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "input/foreign.h"
#include "input/ply.h"
#include "output/obj.h"

enum { ERROR_SIZE = 256 };

typedef struct format {
    const char *ending, *name;
    const char *begins; /* what such files begin with, after white space; NULL: anything */
    int is_foreign, y_up;
    int (*read)(mesh *, const char *); /* if not foreign */
} format;

static const format formats[] = {
    {".obj", "an OBJ", NULL, 0, 0, obj_read}, {".ply", "a PLY", "ply", 0, 0, ply_read},
    {".gltf", "a glTF", "{", 1, 1, NULL},     {".glb", "a binary glTF", "glTF", 1, 1, NULL},
    {".stl", "an STL", NULL, 1, 0, NULL},
};
enum { FORMAT_COUNT = sizeof formats / sizeof *formats };

static const format *format_of(const char *path) {
    const char *dot = strrchr(path, '.');
    for (int k = 0; dot && k < FORMAT_COUNT; k++)
        if (strcasecmp(dot, formats[k].ending) == 0)
            return &formats[k];
    return NULL;
}

int mesh_file_has_texture(const char *path) {
    const format *f = format_of(path);
    return f && f->read == obj_read;
}

long mesh_file_line(const char *path, int triangle) {
    const format *f = format_of(path);
    return f && f->read == obj_read ? obj_triangle_line(path, triangle) : 0;
}

/** 0 where the file begins as one of its format does or cannot be read, -1 after a message. */
static int check_beginning(const format *f, const char *path) {
    char begins[8] = "";
    size_t length = 0;
    int byte = ' ';
    FILE *file = f->begins ? fopen(path, "rb") : NULL;
    if (!file)
        return 0;
    while (isspace(byte))
        byte = fgetc(file);
    for (; byte != EOF && length < strlen(f->begins); byte = fgetc(file))
        begins[length++] = (char)byte;
    fclose(file);
    if (strcmp(begins, f->begins) == 0)
        return 0;
    fprintf(stderr, "%s: not %s file, expected '%s' at its beginning\n", path, f->name, f->begins);
    return -1;
}

/** A vertex' place and number. */
typedef struct place {
    double at[3];
    int vertex;
} place;

static int same_place(const place *a, const place *b) {
    return a->at[0] == b->at[0] && a->at[1] == b->at[1] && a->at[2] == b->at[2];
}

static int compare_places(const void *left, const void *right) {
    const place *a = left, *b = right;
    for (int k = 0; k < 3; k++)
        if (a->at[k] < b->at[k] || a->at[k] > b->at[k])
            return a->at[k] < b->at[k] ? -1 : 1;
    return a->vertex < b->vertex ? -1 : 1;
}

/** The first vertex at each one's place. */
static void find_first(const mesh *m, place *places, int *first) {
    for (int v = 0; v < m->vertex_count; v++) {
        memcpy(places[v].at, m->position[v], sizeof places[v].at);
        places[v].vertex = v;
    }
    qsort(places, (size_t)m->vertex_count, sizeof *places, compare_places);
    for (int k = 0, start = 0; k < m->vertex_count; k++) {
        if (!same_place(&places[k], &places[start]))
            start = k;
        first[places[k].vertex] = places[start].vertex;
    }
}

int mesh_join_vertices(mesh *m) {
    const size_t count = (size_t)m->vertex_count;
    place *places = malloc(count * sizeof *places + 1);
    int *first = malloc(count * sizeof *first + 1), *number = malloc(count * sizeof *number + 1);
    const int status = places && first && number ? 0 : -1;
    if (status == 0) {
        int kept = 0;
        find_first(m, places, first);
        for (int v = 0; v < m->vertex_count; v++) {
            number[v] = first[v] == v ? kept++ : number[first[v]];
            if (first[v] != v)
                continue;
            memmove(m->position[number[v]], m->position[v], sizeof *m->position);
            memmove(m->material[number[v]], m->material[v], sizeof *m->material);
        }
        for (int t = 0; t < m->triangle_count; t++)
            for (int p = 0; p < 3; p++)
                m->triangle[t][p] = number[m->triangle[t][p]];
        m->vertex_count = kept;
    }
    free(places);
    free(first);
    free(number);
    return status;
}

/** -1 in error: a number that is not finite, or a vertex that does not exist. */
static int read_foreign(mesh *m, const format *f, const char *path) {
    char error[ERROR_SIZE] = "out of memory";
    if (foreign_read(m, path, f->y_up) != 0)
        return -1;
    if (mesh_check_numbers(m, error) == 0 && mesh_join_vertices(m) == 0)
        return 0;
    fprintf(stderr, "%s: %s\n", path, error);
    mesh_free(m);
    return -1;
}

int mesh_file_read(mesh *m, const char *path) {
    const format *f = format_of(path);
    *m = (mesh){0};
    if (!f) {
        fprintf(stderr, "%s: not a mesh by its name, expected .obj, .ply, .gltf, .glb or .stl\n",
                path);
        return -1;
    }
    if (check_beginning(f, path) != 0)
        return -1;
    return f->is_foreign ? read_foreign(m, f, path) : f->read(m, path);
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
