/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The format: Turk 1994, "The PLY Polygon File Format". */
#include "input/ply.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/whole_file.h"
#include "mesh/mesh_parts.h"

enum { MOST_ELEMENTS = 16, MOST_PROPERTIES = 64, WORD_SIZE = 64, MOST_CORNERS = 4096 };

typedef enum number_type {
    INT8,
    UINT8,
    INT16,
    UINT16,
    INT32,
    UINT32,
    FLOAT32,
    FLOAT64
} number_type;
enum { NO_TYPE = -1 };
static const char *const type_names[][2] = {
    {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
enum { TYPE_COUNT = sizeof type_names / sizeof *type_names };
static const size_t type_size[TYPE_COUNT] = {1, 1, 2, 2, 4, 4, 4, 8};

typedef struct property {
    char name[WORD_SIZE];
    int type;  /* a number_type, of a list's items */
    int count; /* the type of a list's length; NO_TYPE: one number */
} property;

typedef struct element {
    char name[WORD_SIZE];
    long count;
    int property_count;
    property properties[MOST_PROPERTIES];
} element;

typedef enum encoding { ASCII, LITTLE, BIG } encoding;

/** A file being read. */
typedef struct ply_reader {
    const char *path;
    const char *next, *end; /* what is left of it; *end is 0 */
    long line;              /* of the header */
    encoding as;
    int element_count;
    element elements[MOST_ELEMENTS];
    mesh *into;
    int room; /* for triangles */
} ply_reader;

static int complain(const ply_reader *r, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static int complain(const ply_reader *r, const char *format, ...) {
    va_list arguments;
    fprintf(stderr, "%s:", r->path);
    if (r->line > 0)
        fprintf(stderr, "%ld:", r->line);
    fputc(' ', stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return -1;
}

/** The header's next line, without its end. 0, or -1 after a message. */
static int take_line(ply_reader *r, char *line, size_t size) {
    const char *stop = memchr(r->next, '\n', (size_t)(r->end - r->next));
    r->line++;
    if (!stop)
        return complain(r, "the file ends in its header, expected 'end_header'");
    size_t length = (size_t)(stop - r->next);
    if (length >= size)
        return complain(r, "a line of %zu bytes, expected a PLY header", length);
    memcpy(line, r->next, length);
    r->next = stop + 1;
    if (length > 0 && line[length - 1] == '\r')
        length--;
    line[length] = '\0';
    return 0;
}

static int type_of(const char *name) {
    for (int k = 0; k < TYPE_COUNT; k++)
        if (strcmp(name, type_names[k][0]) == 0 || strcmp(name, type_names[k][1]) == 0)
            return k;
    return NO_TYPE;
}

static int add_element(ply_reader *r, const char *name, const char *count) {
    char *end;
    if (r->element_count == MOST_ELEMENTS)
        return complain(r, "more elements than %d", MOST_ELEMENTS);
    for (int k = 0; k < r->element_count; k++)
        if (strcmp(r->elements[k].name, name) == 0)
            return complain(r, "a second element '%s', expected one", name);
    element *e = &r->elements[r->element_count++];
    snprintf(e->name, sizeof e->name, "%s", name);
    e->count = strtol(count, &end, 10);
    if (end == count || *end != '\0' || e->count < 0 || e->count > INT_MAX / 3)
        return complain(r, "'%s' elements, expected a number from 0 to %d", count, INT_MAX / 3);
    return 0;
}

static int add_property(ply_reader *r, const char *count, const char *type, const char *name) {
    if (r->element_count == 0)
        return complain(r, "a property of no element, expected 'element' before it");
    element *e = &r->elements[r->element_count - 1];
    if (e->property_count == MOST_PROPERTIES)
        return complain(r, "more properties than %d", MOST_PROPERTIES);
    property *p = &e->properties[e->property_count++];
    snprintf(p->name, sizeof p->name, "%s", name);
    p->type = type_of(type);
    p->count = count ? type_of(count) : NO_TYPE;
    if (p->type == NO_TYPE || (count && (p->count == NO_TYPE || p->count >= FLOAT32)))
        return complain(r, "the type of '%s', expected char to double", name);
    return 0;
}

/** 1 after the header's last line, 0 to go on, -1 after a message. */
static int take_header_line(ply_reader *r, const char *line) {
    char word[5][WORD_SIZE] = {"", "", "", "", ""};
    const int words =
        sscanf(line, "%63s %63s %63s %63s %63s", word[0], word[1], word[2], word[3], word[4]);
    if (words <= 0 || strcmp(word[0], "comment") == 0 || strcmp(word[0], "obj_info") == 0)
        return 0;
    if (words == 1 && strcmp(word[0], "end_header") == 0)
        return 1;
    if (words == 3 && strcmp(word[0], "element") == 0)
        return add_element(r, word[1], word[2]);
    if (words == 3 && strcmp(word[0], "property") == 0)
        return add_property(r, NULL, word[1], word[2]);
    if (words == 5 && strcmp(word[0], "property") == 0 && strcmp(word[1], "list") == 0)
        return add_property(r, word[2], word[3], word[4]);
    return complain(r, "'%.60s', expected 'element', 'property', 'comment' or 'end_header'", line);
}

static int read_header(ply_reader *r) {
    static const char *const encodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    char line[1024], format[32] = "";
    if (take_line(r, line, sizeof line) != 0)
        return -1;
    if (strcmp(line, "ply") != 0)
        return complain(r, "not a PLY file, expected 'ply' in its first line");
    if (take_line(r, line, sizeof line) != 0)
        return -1;
    int known = 0;
    if (sscanf(line, "format %31s 1.0", format) == 1)
        for (int k = 0; k < 3; k++)
            if (strcmp(format, encodings[k]) == 0) {
                r->as = (encoding)k;
                known = 1;
            }
    if (!known)
        return complain(r,
                        "'%.60s', expected 'format ascii 1.0', binary_little_endian or "
                        "binary_big_endian",
                        line);
    for (int last = 0; last == 0;) {
        if (take_line(r, line, sizeof line) != 0 || (last = take_header_line(r, line)) < 0)
            return -1;
    }
    r->line = 0;
    return 0;
}

/** Bytes in the file's order as a number in this machine's. */
static uint64_t take_word(ply_reader *r, size_t size) {
    uint64_t word = 0;
    for (size_t k = 0; k < size; k++) {
        const size_t shift = 8 * (r->as == BIG ? size - 1 - k : k);
        word |= (uint64_t)(unsigned char)r->next[k] << shift;
    }
    r->next += size;
    return word;
}

static int take_binary(ply_reader *r, int type, double *number) {
    if ((size_t)(r->end - r->next) < type_size[type])
        return -1;
    const uint64_t word = take_word(r, type_size[type]);
    const uint32_t half = (uint32_t)word;
    float single;
    switch ((number_type)type) {
    case INT8:
        *number = (int8_t)(uint8_t)word;
        break;
    case INT16:
        *number = (int16_t)(uint16_t)word;
        break;
    case INT32:
        *number = (int32_t)half;
        break;
    case UINT8:
    case UINT16:
    case UINT32:
        *number = half;
        break;
    case FLOAT32:
        memcpy(&single, &half, sizeof single);
        *number = (double)single;
        break;
    case FLOAT64:
        memcpy(number, &word, sizeof *number);
        break;
    }
    return 0;
}

static int take_number(ply_reader *r, int type, double *number) {
    char *end;
    if (r->as != ASCII)
        return take_binary(r, type, number);
    *number = type == FLOAT32 ? (double)strtof(r->next, &end) : strtod(r->next, &end);
    if (end == r->next)
        return -1;
    r->next = end;
    return 0;
}

/** A whole number from 0 to `most`. */
static int take_whole(ply_reader *r, int type, long most, long *whole) {
    double number;
    if (take_number(r, type, &number) != 0 || !(number >= 0 && number <= (double)most) ||
        number != floor(number))
        return -1;
    *whole = (long)number;
    return 0;
}

static int add_triangle(ply_reader *r, long a, long b, long c) {
    mesh *m = r->into;
    if (m->triangle_count == INT_MAX / 3)
        return complain(r, "more than %d triangles", INT_MAX / 3);
    if (m->triangle_count == r->room) {
        const int room = r->room > INT_MAX / 6 ? INT_MAX / 3 : 2 * r->room + 64;
        int(*more)[3] = realloc(m->triangle, (size_t)room * sizeof *more);
        if (!more)
            return complain(r, "out of memory");
        m->triangle = more;
        r->room = room;
    }
    int *corner = m->triangle[m->triangle_count++];
    corner[0] = (int)a;
    corner[1] = (int)b;
    corner[2] = (int)c;
    return 0;
}

/** Passes over a property, or puts a polygon's triangles into the mesh. */
static int take_list(ply_reader *r, const property *p, int is_polygon, int number) {
    long count, corner[3] = {0, 0, 0};
    if (take_whole(r, p->count, is_polygon ? MOST_CORNERS : INT_MAX, &count) != 0)
        return complain(r, "face %d: a list with no length, expected up to %d corners", number,
                        MOST_CORNERS);
    if (is_polygon && count < 3)
        return complain(r, "face %d has %ld corners, expected 3 or more", number, count);
    for (long k = 0; k < count; k++) {
        double skipped;
        if (!is_polygon) {
            if (take_number(r, p->type, &skipped) != 0)
                return complain(r, "the file ends in a list");
            continue;
        }
        if (take_whole(r, p->type, r->into->vertex_count - 1, &corner[k < 2 ? k : 2]) != 0)
            return complain(r, "face %d, corner %ld: expected the number of a vertex from 0 to %d",
                            number, k, r->into->vertex_count - 1);
        if (k >= 2) {
            if (add_triangle(r, corner[0], corner[1], corner[2]) != 0)
                return -1;
            corner[1] = corner[2];
        }
    }
    return 0;
}

static int is_polygon(const element *e, const property *p) {
    return strcmp(e->name, "face") == 0 && p->count != NO_TYPE &&
           (strcmp(p->name, "vertex_indices") == 0 || strcmp(p->name, "vertex_index") == 0);
}

/** The axis of a coordinate's property, else -1. */
static int axis_of(const element *e, const property *p) {
    const int is_axis = strcmp(e->name, "vertex") == 0 && p->count == NO_TYPE &&
                        p->name[0] >= 'x' && p->name[0] <= 'z' && p->name[1] == '\0';
    return is_axis ? p->name[0] - 'x' : -1;
}

static int take_element(ply_reader *r, const element *e, int number) {
    for (int k = 0; k < e->property_count; k++) {
        const property *p = &e->properties[k];
        const int axis = axis_of(e, p);
        double value;
        if (p->count != NO_TYPE) {
            if (take_list(r, p, is_polygon(e, p), number) != 0)
                return -1;
        } else if (take_number(r, p->type, &value) != 0)
            return complain(r, "%s %d of %ld: no number for '%s'%s", e->name, number, e->count,
                            p->name, r->next == r->end ? ", the file ends" : "");
        else if (axis >= 0)
            r->into->position[number][axis] = value;
    }
    return 0;
}

/** A number takes at least a byte: a count that cannot be true allocates nothing. */
static int check_count(const ply_reader *r, const element *e) {
    if (e->property_count == 0 || e->count <= (r->end - r->next) / e->property_count)
        return 0;
    return complain(r,
                    "%ld times '%s' do not fit in the %ld bytes after the header: the file ends "
                    "too early",
                    e->count, e->name, (long)(r->end - r->next));
}

static const element *find_element(const ply_reader *r, const char *name) {
    for (int k = 0; k < r->element_count; k++)
        if (strcmp(r->elements[k].name, name) == 0)
            return &r->elements[k];
    return NULL;
}

/** There are vertices with x, y and z, before faces with a list of corners. */
static int check_header(const ply_reader *r) {
    const element *vertex = find_element(r, "vertex"), *face = find_element(r, "face");
    int axes = 0, polygons = 0;
    for (int k = 0; vertex && k < vertex->property_count; k++)
        axes |= axis_of(vertex, &vertex->properties[k]) >= 0
                    ? 1 << axis_of(vertex, &vertex->properties[k])
                    : 0;
    for (int k = 0; face && k < face->property_count; k++)
        polygons += is_polygon(face, &face->properties[k]);
    if (axes != 7)
        return complain(r, "no element 'vertex' with x, y and z, expected one");
    if (polygons != 1 || face < vertex)
        return complain(r, "no element 'face' with 'vertex_indices' after 'vertex', expected one");
    if (vertex->count == 0 || face->count == 0)
        return complain(r, "%ld vertices and %ld faces, expected some", vertex->count, face->count);
    return check_count(r, vertex) != 0 ? -1 : 0;
}

static int read_body(ply_reader *r) {
    mesh *m = r->into;
    if (check_header(r) != 0)
        return -1;
    if (mesh_allocate(m, (int)find_element(r, "vertex")->count, 0) != 0)
        return complain(r, "out of memory");
    for (int k = 0; k < r->element_count; k++) {
        const element *e = &r->elements[k];
        if (check_count(r, e) != 0)
            return -1;
        for (int n = 0; e->property_count > 0 && n < e->count; n++)
            if (take_element(r, e, n) != 0)
                return -1;
    }
    for (int v = 0; v < m->vertex_count; v++)
        memcpy(m->material[v], m->position[v], sizeof *m->material);
    return 0;
}

int ply_read(mesh *m, const char *path) {
    size_t size = 0;
    *m = (mesh){0};
    char *bytes = whole_file_read(path, &size);
    ply_reader *r = calloc(1, sizeof *r);
    int status = -1;
    if (bytes && r) {
        *r = (ply_reader){.path = path, .next = bytes, .end = bytes + size, .into = m};
        status = read_header(r) == 0 ? read_body(r) : -1;
        if (status != 0)
            mesh_free(m);
    } else if (bytes)
        fprintf(stderr, "%s: out of memory\n", path);
    free(r);
    free(bytes);
    return status;
}
