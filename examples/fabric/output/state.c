/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/state.h"

#include <stdlib.h>
#include <string.h>

#include "output/sealed_file.h"

enum { KNOWN_PARTS = STATE_VELOCITIES | STATE_TRIANGLES | STATE_ORIGINAL | STATE_SINGLE };
enum {
    SINGLE_WITH_VELOCITIES = STATE_SINGLE | STATE_VELOCITIES
}; /* not allowed: velocities would be unaligned */

/** Sizes of the payload's parts, in their order. */
typedef struct layout {
    size_t positions, velocities, triangles, originals;
} layout;

static layout layout_of(unsigned parts, int vertex_count, int triangle_count) {
    const size_t vertices = (size_t)vertex_count, triangles = (size_t)triangle_count;
    return (layout){
        3 * vertices * ((parts & STATE_SINGLE) != 0 ? sizeof(float) : sizeof(double)),
        (parts & STATE_VELOCITIES) != 0 ? 3 * vertices * sizeof(double) : 0,
        (parts & STATE_TRIANGLES) != 0 ? 3 * triangles * sizeof(int32_t) : 0,
        (parts & STATE_ORIGINAL) != 0 ? vertices * sizeof(int32_t) : 0,
    };
}

static size_t layout_size(layout l) {
    return l.positions + l.velocities + l.triangles + l.originals;
}

static int check_header(const sealed_header *header) {
    const unsigned parts = header->parts;
    return header->vertex_count <= 0 || header->triangle_count < 0 ||
                   (parts & ~(unsigned)KNOWN_PARTS) != 0 ||
                   (parts & SINGLE_WITH_VELOCITIES) == SINGLE_WITH_VELOCITIES ||
                   header->payload_size !=
                       layout_size(layout_of(parts, header->vertex_count, header->triangle_count))
               ? -1
               : 0;
}

static const sealed_kind STATE_KIND = {"FABRICST", 1, "a state", 0, check_header};

static char *append(char *to, const void *from, size_t size) {
    if (size > 0)
        memcpy(to, from, size);
    return to + size;
}

static void pack(const state *s, layout l, char *payload) {
    if ((s->parts & STATE_SINGLE) != 0)
        for (size_t k = 0; k < 3 * (size_t)s->vertex_count; k++) {
            const float single = (float)s->position[k];
            payload = append(payload, &single, sizeof single);
        }
    else
        payload = append(payload, s->position, l.positions);
    payload = append(payload, s->velocity, l.velocities);
    payload = append(payload, s->triangle, l.triangles);
    append(payload, s->original, l.originals);
}

int state_write(const state *s, const char *path) {
    const layout l = layout_of(s->parts, s->vertex_count, s->triangle_count);
    sealed_header header = {.parts = s->parts,
                            .vertex_count = s->vertex_count,
                            .triangle_count = s->triangle_count,
                            .time = s->time,
                            .step = s->step,
                            .payload_size = layout_size(l)};
    char *payload = malloc(header.payload_size + 1);
    if (!payload)
        return sealed_file_complain(path, "out of memory");
    pack(s, l, payload);
    const int status = sealed_file_write(&STATE_KIND, &header, payload, path);
    free(payload);
    return status;
}

static int check_numbers(const int *numbers, size_t count, int below) {
    for (size_t k = 0; k < count; k++)
        if (numbers[k] < 0 || numbers[k] >= below)
            return -1;
    return 0;
}

/** Sets the state's arrays to point into the payload in s->memory. Single-precision positions are
 *  converted to doubles, which follow the payload. Returns 0, or -1 after a message. */
static int unpack(state *s, layout l, const char *path) {
    const size_t count = 3 * (size_t)s->vertex_count;
    const size_t behind = (layout_size(l) + sizeof(double)) / sizeof(double) * sizeof(double);
    if ((s->parts & STATE_SINGLE) != 0) {
        void *more = realloc(s->memory, behind + count * sizeof(double));
        if (!more)
            return sealed_file_complain(path, "out of memory");
        s->memory = more;
    }
    char *payload = s->memory;
    double *positions = (double *)(void *)payload;
    if ((s->parts & STATE_SINGLE) != 0) {
        positions = (double *)(void *)(payload + behind);
        for (size_t k = 0; k < count; k++) {
            float single;
            memcpy(&single, payload + k * sizeof single, sizeof single);
            positions[k] = (double)single;
        }
    }
    s->position = positions;
    payload += l.positions;
    if (l.velocities > 0)
        s->velocity = (const double *)(const void *)payload;
    payload += l.velocities;
    if ((s->parts & STATE_TRIANGLES) != 0)
        s->triangle = (const int *)(const void *)payload;
    payload += l.triangles;
    if (l.originals > 0)
        s->original = (const int *)(const void *)payload;
    if ((s->triangle &&
         check_numbers(s->triangle, 3 * (size_t)s->triangle_count, s->vertex_count) != 0) ||
        (s->original && check_numbers(s->original, (size_t)s->vertex_count, s->vertex_count) != 0))
        return sealed_file_complain(path, "damaged: it names a vertex that it does not have");
    return 0;
}

int state_read(state *s, const char *path) {
    sealed_header header;
    *s = (state){.memory = sealed_file_read(&STATE_KIND, &header, path)};
    if (!s->memory)
        return -1;
    s->vertex_count = header.vertex_count;
    s->triangle_count = header.triangle_count;
    s->time = header.time;
    s->step = (long)header.step;
    s->parts = header.parts;
    if (unpack(s, layout_of(s->parts, s->vertex_count, s->triangle_count), path) == 0)
        return 0;
    state_free(s);
    return -1;
}

void state_free(state *s) {
    free(s->memory);
    *s = (state){0};
}
