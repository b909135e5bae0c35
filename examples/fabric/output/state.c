/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/state.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/fresh_file.h"

typedef struct file_header {
    char magic[8];
    uint32_t byte_order;
    uint32_t version;
    uint32_t parts;
    int32_t vertex_count;
    int32_t triangle_count;
    uint32_t zero;
    double time;
    int64_t step;
    uint64_t payload_size;
    uint64_t checksum;
} file_header;
_Static_assert(sizeof(file_header) == 64, "the file's header has no padding");

static const char MAGIC[8] = {'F', 'A', 'B', 'R', 'I', 'C', 'S', 'T'};
enum { BYTE_ORDER_MARK = 0x01020304, BYTE_ORDER_SWAPPED = 0x04030201, VERSION = 1 };
enum { KNOWN_PARTS = STATE_VELOCITIES | STATE_TRIANGLES | STATE_ORIGINAL | STATE_SINGLE };
enum { SINGLE_WITH_VELOCITIES = STATE_SINGLE | STATE_VELOCITIES }; /* would not be aligned */

static int complain(const char *path, const char *what) {
    fprintf(stderr, "%s: %s\n", path, what);
    return -1;
}

static int complain_errno(const char *path, const char *what) {
    fprintf(stderr, "%s: %s: %s\n", path, what, strerror(errno));
    return -1;
}

/** FNV-1a (Fowler, Noll, Vo), continued from `hash`. */
static uint64_t checksum(uint64_t hash, const void *bytes, size_t size) {
    const unsigned char *byte = bytes;
    for (size_t k = 0; k < size; k++)
        hash = (hash ^ byte[k]) * 0x100000001b3u;
    return hash;
}

static uint64_t file_checksum(file_header header, const void *payload) {
    header.checksum = 0;
    return checksum(checksum(0xcbf29ce484222325u, &header, sizeof header), payload,
                    header.payload_size);
}

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

static int write_file(const char *path, const file_header *header, const char *payload) {
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    fwrite(header, sizeof *header, 1, f.file);
    fwrite(payload, 1, header->payload_size, f.file);
    return fresh_file_close(&f, 0);
}

int state_write(const state *s, const char *path) {
    const layout l = layout_of(s->parts, s->vertex_count, s->triangle_count);
    file_header header = {.byte_order = BYTE_ORDER_MARK,
                          .version = VERSION,
                          .parts = s->parts,
                          .vertex_count = s->vertex_count,
                          .triangle_count = s->triangle_count,
                          .time = s->time,
                          .step = s->step,
                          .payload_size = layout_size(l)};
    memcpy(header.magic, MAGIC, sizeof MAGIC);
    char *payload = malloc(header.payload_size + 1);
    if (!payload)
        return complain(path, "out of memory");
    pack(s, l, payload);
    header.checksum = file_checksum(header, payload);
    const int status = write_file(path, &header, payload);
    free(payload);
    return status;
}

static int check_header(const file_header *header, const char *path) {
    if (memcmp(header->magic, MAGIC, sizeof MAGIC) != 0)
        return complain(path, "not a state of fabric's");
    if (header->byte_order == BYTE_ORDER_SWAPPED)
        return complain(path, "written by a machine of the other byte order");
    if (header->byte_order != BYTE_ORDER_MARK)
        return complain(path, "damaged: its byte order is none");
    if (header->version != VERSION) {
        fprintf(stderr, "%s: of format version %u, this program reads version %d\n", path,
                header->version, VERSION);
        return -1;
    }
    if (header->vertex_count <= 0 || header->triangle_count < 0 ||
        (header->parts & ~(unsigned)KNOWN_PARTS) != 0 ||
        (header->parts & SINGLE_WITH_VELOCITIES) == SINGLE_WITH_VELOCITIES ||
        header->payload_size !=
            layout_size(layout_of(header->parts, header->vertex_count, header->triangle_count)))
        return complain(path, "damaged: its header contradicts itself");
    return 0;
}

/** Reads `size` bytes, no more than the file claims and no more than it has. */
static int read_payload(FILE *file, const file_header *header, char *payload, const char *path) {
    const size_t found = fread(payload, 1, header->payload_size, file);
    if (found < header->payload_size) {
        fprintf(stderr, "%s: torn: %zu of %llu bytes\n", path, found + sizeof *header,
                (unsigned long long)header->payload_size + sizeof *header);
        return -1;
    }
    if (fgetc(file) != EOF)
        return complain(path, "damaged: it goes on after its end");
    if (file_checksum(*header, payload) != header->checksum)
        return complain(path, "damaged: its checksum differs");
    return 0;
}

static int check_numbers(const int *numbers, size_t count, int below) {
    for (size_t k = 0; k < count; k++)
        if (numbers[k] < 0 || numbers[k] >= below)
            return -1;
    return 0;
}

/** Points the state's arrays into memory: positions as double, then the payload as it is. */
static void unpack(state *s, layout l, double *positions, const char *payload) {
    if ((s->parts & STATE_SINGLE) != 0)
        for (size_t k = 0; k < 3 * (size_t)s->vertex_count; k++) {
            float single;
            memcpy(&single, payload + k * sizeof single, sizeof single);
            positions[k] = (double)single;
        }
    else
        memcpy(positions, payload, l.positions);
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
}

static int read_state(state *s, FILE *file, const char *path) {
    file_header header;
    const size_t found = fread(&header, 1, sizeof header, file);
    if (found < sizeof header)
        return complain(path, found >= sizeof MAGIC && memcmp(&header, MAGIC, sizeof MAGIC) == 0
                                  ? "torn: it ends in its header"
                                  : "not a state of fabric's");
    if (check_header(&header, path) != 0)
        return -1;
    const layout l = layout_of(header.parts, header.vertex_count, header.triangle_count);
    const size_t as_double = 3 * (size_t)header.vertex_count * sizeof(double);
    s->memory = malloc(as_double + header.payload_size);
    if (!s->memory)
        return complain(path, "out of memory");
    char *payload = (char *)s->memory + as_double;
    if (read_payload(file, &header, payload, path) != 0)
        return -1;
    s->vertex_count = header.vertex_count;
    s->triangle_count = header.triangle_count;
    s->time = header.time;
    s->step = (long)header.step;
    s->parts = header.parts;
    unpack(s, l, s->memory, payload);
    if ((s->triangle &&
         check_numbers(s->triangle, 3 * (size_t)s->triangle_count, s->vertex_count) != 0) ||
        (s->original && check_numbers(s->original, (size_t)s->vertex_count, s->vertex_count) != 0))
        return complain(path, "damaged: it names a vertex that it does not have");
    return 0;
}

int state_read(state *s, const char *path) {
    *s = (state){0};
    FILE *file = fopen(path, "rb");
    if (!file)
        return complain_errno(path, "cannot be read");
    const int status = read_state(s, file, path);
    fclose(file);
    if (status != 0)
        state_free(s);
    return status;
}

void state_free(state *s) {
    free(s->memory);
    *s = (state){0};
}
