/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/obj.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "mesh/mesh_parts.h"
#include "output/fresh_file.h"

int obj_write(const mesh *m, const char *path) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    for (int v = 0; v < m->vertex_count; v++)
        fprintf(f.file, "v %.17g %.17g %.17g\n", m->position[v][0], m->position[v][1],
                m->position[v][2]);
    for (int v = 0; v < m->vertex_count; v++)
        fprintf(f.file, "vt %.17g %.17g\n", m->material[v][0], m->material[v][1]);
    for (int t = 0; t < m->triangle_count; t++) {
        const int *c = m->triangle[t];
        fprintf(f.file, "f %d/%d %d/%d %d/%d\n", c[0] + 1, c[0] + 1, c[1] + 1, c[1] + 1, c[2] + 1,
                c[2] + 1);
    }
    return fresh_file_close(&f, 0);
}

/** A file that is read line by line, twice: first to count its items, then to fill the mesh. */
typedef struct obj_reader {
    const char *path;
    long line;
    int vertices, materials, triangles;
    double (*material)[2]; /* [materials] coordinates of the vt lines */
    mesh *into;            /* NULL while items are only counted */
    int wanted;            /* index of the triangle to find */
    long wanted_line;      /* the line of that triangle; 0: not read yet */
} obj_reader;

static int complain(const obj_reader *r, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static int complain(const obj_reader *r, const char *format, ...) {
    va_list arguments;
    fprintf(stderr, "%s:%ld: ", r->path, r->line);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return -1;
}

static int read_numbers(const obj_reader *r, const char *text, double *number, int count) {
    for (int k = 0; k < count; k++) {
        char *end;
        number[k] = strtod(text, &end);
        if (end == text || !isfinite(number[k]))
            return complain(r, "expected %d finite numbers", count);
        text = end;
    }
    return 0;
}

/** Converts a reference to an index from 0, or -1 if it is invalid. Negative references count back
 *  from the last item read. */
static int resolve(long reference, int count) {
    if (reference < 0)
        reference += count + 1;
    return reference >= 1 && reference <= count ? (int)(reference - 1) : -1;
}

/** Reads one corner: "vertex" or "vertex/material", optionally followed by "/normal". Returns the
 *  text after it, or NULL after a message. */
static const char *read_corner(const obj_reader *r, const char *text, int *vertex, int *material) {
    char *end;
    *vertex = resolve(strtol(text, &end, 10), r->vertices);
    *material = -1;
    if (end == text || *vertex < 0) {
        complain(r, "expected the number of a vertex from 1 to %d", r->vertices);
        return NULL;
    }
    if (*end == '/' && end[1] != '/') {
        const char *second = end + 1;
        *material = resolve(strtol(second, &end, 10), r->materials);
        if (end == second || *material < 0) {
            complain(r, "expected the number of a vt line from 1 to %d", r->materials);
            return NULL;
        }
    }
    return end + strcspn(end, " \t\r\n");
}

static int add_triangle(obj_reader *r, const int corner[3], const int material[3]) {
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
        return complain(r, "a triangle with one vertex twice");
    if (r->triangles == INT_MAX / 3)
        return complain(r, "more than %d triangles", INT_MAX / 3);
    if (r->into)
        for (int k = 0; k < 3; k++) {
            r->into->triangle[r->triangles][k] = corner[k];
            if (material[k] >= 0)
                memcpy(r->into->material[corner[k]], r->material[material[k]], sizeof *r->material);
        }
    if (r->triangles == r->wanted)
        r->wanted_line = r->line;
    r->triangles++;
    return 0;
}

/** Reads a polygon as a fan of triangles around its first corner. */
static int read_face(obj_reader *r, const char *text) {
    int corner[3], material[3], count = 0;
    while (text[strspn(text, " \t\r\n")] != '\0' || count < 3) {
        const int k = count < 2 ? count : 2;
        if (!(text = read_corner(r, text, &corner[k], &material[k])))
            return -1;
        if (++count < 3)
            continue;
        if (add_triangle(r, corner, material) != 0)
            return -1;
        corner[1] = corner[2];
        material[1] = material[2];
    }
    return 0;
}

static int read_line(obj_reader *r, const char *line) {
    double number[3];
    if (strncmp(line, "v ", 2) == 0) {
        if (read_numbers(r, line + 2, number, 3) != 0)
            return -1;
        if (r->into) {
            memcpy(r->into->position[r->vertices], number, sizeof number);
            memcpy(r->into->material[r->vertices], number, sizeof *r->into->material);
        }
        r->vertices++;
    } else if (strncmp(line, "vt ", 3) == 0) {
        if (read_numbers(r, line + 3, number, 2) != 0)
            return -1;
        if (r->into)
            memcpy(r->material[r->materials], number, sizeof *r->material);
        r->materials++;
    } else if (strncmp(line, "f ", 2) == 0)
        return read_face(r, line + 2);
    return 0;
}

static int read_lines(obj_reader *r, FILE *file) {
    char *line = NULL;
    size_t size = 0;
    int status = 0;
    rewind(file);
    r->line = 0;
    r->vertices = r->materials = r->triangles = 0;
    while (status == 0 && getline(&line, &size, file) >= 0) {
        r->line++;
        status = read_line(r, line);
    }
    free(line);
    return status;
}

static int read_file(obj_reader *r, mesh *m, FILE *file) {
    if (read_lines(r, file) != 0)
        return -1;
    if (r->vertices == 0 || r->triangles == 0)
        return complain(r, "the file ends with %d vertices and %d triangles, expected some",
                        r->vertices, r->triangles);
    r->material = malloc((size_t)r->materials * sizeof *r->material + 1);
    if (!r->material || mesh_allocate(m, r->vertices, r->triangles) != 0) {
        free(r->material);
        return complain(r, "out of memory");
    }
    r->into = m;
    const int status = read_lines(r, file);
    free(r->material);
    if (status != 0)
        mesh_free(m);
    return status;
}

int obj_read(mesh *m, const char *path) {
    obj_reader r = {.path = path};
    *m = (mesh){0};
    FILE *file = files_open(path);
    if (!file)
        return -1;
    const int status = read_file(&r, m, file);
    fclose(file);
    return status;
}

long obj_triangle_line(const char *path, int triangle) {
    obj_reader r = {.path = path, .wanted = triangle};
    FILE *file = fopen(path, "rb");
    if (!file)
        return 0;
    const int status = read_lines(&r, file);
    fclose(file);
    return status == 0 ? r.wanted_line : 0;
}
