/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Writes the format of Khronos Group 2021, "glTF 2.0 Specification". */
#include "view/gltf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/shape.h"
#include "output/fresh_file.h"
#include "view/byte_sink.h"
#include "view/gltf_parts.h"

static bounds no_bounds(void) {
    return (bounds){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

static void stretch_bounds(bounds *b, const double p[3]) {
    for (int a = 0; a < 3; a++) {
        const float x = (float)p[a];
        b->low[a] = x < b->low[a] ? x : b->low[a];
        b->high[a] = x > b->high[a] ? x : b->high[a];
    }
}

/** Computes vertex v of a frame as the file stores it: a position in the first frame, in others the
 *  displacement from it. */
static void vertex_of(const gltf *g, const state *s, int number, int v, double turned[3]) {
    double p[3];
    for (int a = 0; a < 3; a++)
        p[a] = s->position[3 * v + a] - (number > 0 ? g->first.position[3 * v + a] : 0);
    gltf_turn(p, turned);
}

void gltf_measure(const gltf *g, uint64_t size[PARTS]) {
    const uint64_t frames = (uint64_t)g->frames->count;
    const uint64_t vertices = (uint64_t)g->frames->vertex_count;
    memset(size, 0, PARTS * sizeof *size);
    size[CLOTH] = 12 * vertices;
    size[CORNERS] = 12 * (uint64_t)g->frames->triangle_count;
    if (frames > 1) {
        size[TARGETS] = 12 * vertices * (frames - 1);
        size[TIMES] = 4 * frames;
        size[WEIGHTS] = 4 * frames * (frames - 1);
        size[PATHS] = 12 * frames * (uint64_t)gltf_moving_before(g, g->solid_count);
        size[TURNS] = 16 * frames * (uint64_t)gltf_rotating_before(g, g->solid_count);
    }
    for (int k = 0; k < g->solid_count; k++) {
        size[SOLIDS] += 12 * (uint64_t)g->solids[k].surface.vertex_count;
        size[SOLID_CORNERS] += 12 * (uint64_t)g->solids[k].surface.triangle_count;
    }
}

static int measure_frames(gltf *g, double middle[3], double *reach) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int k = 0; k < g->frames->count; k++) {
        state s;
        if (g->frames->read(g->frames->context, k, &s) != 0)
            return -1;
        g->frame[k] = no_bounds();
        for (int v = 0; v < g->frames->vertex_count; v++) {
            double turned[3];
            vertex_of(g, &s, k, v, turned);
            stretch_bounds(&g->frame[k], turned);
            for (int a = 0; a < 3; a++) {
                low[a] = fmin(low[a], s.position[3 * v + a]);
                high[a] = fmax(high[a], s.position[3 * v + a]);
            }
        }
        state_free(&s);
    }
    *reach = 0;
    for (int a = 0; a < 3; a++) {
        middle[a] = 0.5 * (low[a] + high[a]);
        *reach = fmax(*reach, 2 * (high[a] - low[a]));
    }
    return 0;
}

static int make_solids(gltf *g, const scene *of, const double middle[3], double reach) {
    g->solids = calloc((size_t)of->collider_count + 1, sizeof *g->solids);
    if (!g->solids)
        return -1;
    for (int n = 0; n < of->collider_count; n++) {
        solid *s = &g->solids[g->solid_count++];
        *s = (solid){&of->colliders[n], {0}, no_bounds()};
        if (solid_mesh(s->of, middle, reach, &s->surface) != 0)
            return -1;
        for (int v = 0; v < s->surface.vertex_count; v++) {
            double turned[3];
            gltf_turn(s->surface.position[v], turned);
            stretch_bounds(&s->box, turned);
        }
    }
    return 0;
}

static void put_point(byte_sink *to, const double p[3]) {
    for (int a = 0; a < 3; a++)
        byte_sink_float(to, p[a]);
}

static void put_corners(byte_sink *to, const int *corner, int triangles) {
    for (size_t k = 0; k < 3 * (size_t)triangles; k++)
        byte_sink_word(to, (uint32_t)corner[k]);
}

static int put_frames(const gltf *g, byte_sink *to) {
    for (int k = 0; k < g->frames->count; k++) {
        state s;
        if (g->frames->read(g->frames->context, k, &s) != 0)
            return -1;
        for (int v = 0; v < g->frames->vertex_count; v++) {
            double turned[3];
            vertex_of(g, &s, k, v, turned);
            put_point(to, turned);
        }
        state_free(&s);
    }
    return 0;
}

static void put_weights(const gltf *g, byte_sink *to) {
    for (int k = 0; k < g->frames->count; k++)
        byte_sink_float(to, g->frames->time[k]);
    for (int k = 0; k < g->frames->count; k++)
        for (int target = 1; target < g->frames->count; target++)
            byte_sink_float(to, target == k);
}

static void put_solids(const gltf *g, byte_sink *to) {
    for (int k = 0; k < g->solid_count; k++)
        for (int v = 0; v < g->solids[k].surface.vertex_count; v++) {
            double turned[3];
            gltf_turn(g->solids[k].surface.position[v], turned);
            put_point(to, turned);
        }
    for (int k = 0; k < g->solid_count; k++)
        put_corners(to, &g->solids[k].surface.triangle[0][0], g->solids[k].surface.triangle_count);
    for (int k = 0; k < g->solid_count && g->frames->count > 1; k++)
        for (int n = 0; gltf_is_moving(g->solids[k].of) && n < g->frames->count; n++) {
            double at[3];
            gltf_place(g->solids[k].of, g->frames->time[n], at);
            put_point(to, at);
        }
    for (int k = 0; k < g->solid_count && g->frames->count > 1; k++)
        for (int n = 0; motion_rotates(g->solids[k].of) && n < g->frames->count; n++) {
            double quaternion[4];
            gltf_rotation(g->solids[k].of, g->frames->time[n], quaternion);
            for (int a = 0; a < 4; a++)
                byte_sink_float(to, quaternion[a]);
        }
}

/** Writes the buffer, in the order of the parts. */
static int put_buffer(const gltf *g, byte_sink *to) {
    if (put_frames(g, to) != 0)
        return -1;
    put_corners(to, g->frames->triangle, g->frames->triangle_count);
    if (g->frames->count > 1)
        put_weights(g, to);
    put_solids(g, to);
    byte_sink_end(to);
    return 0;
}

static int write_text(const gltf *g, const char *json, FILE *file) {
    byte_sink to = {file, 1, {0}, 0};
    fprintf(file, "%s,\"uri\":\"data:application/octet-stream;base64,", json);
    const int status = put_buffer(g, &to);
    fputs("\"}]}\n", file);
    return status;
}

/** Writes a header and two chunks, whose lengths are multiples of 4: JSON, padded with spaces, and
 * the numbers. */
static int write_binary(const gltf *g, const char *json, size_t length, FILE *file) {
    const uint32_t text = (uint32_t)(length + 3 + 3) / 4 * 4, bytes = (uint32_t)g->bytes;
    byte_sink to = {file, 0, {0}, 0};
    const uint32_t head[] = {0x46546C67, 2, 12 + 8 + text + 8 + bytes, text, 0x4E4F534A};
    for (int k = 0; k < 5; k++)
        byte_sink_word(&to, head[k]);
    fprintf(file, "%s}]}%*s", json, (int)(text - length - 3), "");
    byte_sink_word(&to, bytes);
    byte_sink_word(&to, 0x004E4942);
    return put_buffer(g, &to);
}

static int check_size(const gltf *g, const char *path) {
    if (g->frames->count > GLTF_MOST_FRAMES)
        fprintf(stderr,
                "%s: %d frames, expected up to %d in a glTF file: run with fewer --frames, "
                "or use 'fabric export' (VTK files)\n",
                path, g->frames->count, GLTF_MOST_FRAMES);
    else if (g->bytes > 1000000ull * GLTF_MOST_MEGABYTES)
        fprintf(stderr,
                "%s: %llu MB, expected up to %d in a glTF file: run with fewer --frames, or "
                "use 'fabric export' (VTK files)\n",
                path, (unsigned long long)(g->bytes / 1000000), GLTF_MOST_MEGABYTES);
    else
        return 0;
    return -1;
}

static int write_file(const gltf *g, int binary, const char *path) {
    size_t length;
    fresh_file f;
    char *json = gltf_json(g, &length);
    if (!json) {
        fprintf(stderr, "%s: out of memory\n", path);
        return -1;
    }
    int status = fresh_file_open(&f, path);
    if (status == 0)
        status = fresh_file_close(&f, binary ? write_binary(g, json, length, f.file)
                                             : write_text(g, json, f.file));
    free(json);
    return status;
}

/** Collects the data before writing. Returns 0, -1 if out of memory, or -2 after a message. */
static int prepare(gltf *g, const scene *of, const char *path) {
    uint64_t size[PARTS];
    double middle[3], reach;
    g->frame = calloc((size_t)g->frames->count + 1, sizeof *g->frame);
    if (!g->frame)
        return -1;
    /* Checks the size before all frames are read, without colliders, which are small. */
    gltf_measure(g, size);
    for (int part = 0; part < PARTS; part++)
        g->bytes += size[part];
    if (check_size(g, path) != 0 || g->frames->read(g->frames->context, 0, &g->first) != 0 ||
        measure_frames(g, middle, &reach) != 0)
        return -2;
    if (make_solids(g, of, middle, reach) != 0)
        return -1;
    gltf_measure(g, size);
    g->bytes = 0;
    for (int part = 0; part < PARTS; part++)
        g->bytes += size[part];
    return check_size(g, path) == 0 ? 0 : -2;
}

int gltf_write(const cloth_frames *frames, const scene *of, int binary, const char *path) {
    gltf g = {.frames = frames};
    const int prepared = prepare(&g, of, path);
    if (prepared == -1)
        fprintf(stderr, "%s: out of memory\n", path);
    const int status = prepared == 0 ? write_file(&g, binary, path) : -1;
    for (int k = 0; k < g.solid_count; k++)
        mesh_free(&g.solids[k].surface);
    free(g.solids);
    free(g.frame);
    state_free(&g.first);
    return status;
}
