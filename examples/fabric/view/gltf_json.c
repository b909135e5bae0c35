/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The JSON of a glTF file. */
#include <stdio.h>
#include <stdlib.h>

#include "view/gltf_parts.h"

static const char *const collider_names[] = {"plane", "box", "sphere", "cylinder", "mesh"};

/** Returns the index of a part's bufferView. Parts without bytes have none. */
static int view_of(const uint64_t size[PARTS], int part) {
    int view = 0;
    for (int k = 0; k < part; k++)
        view += size[k] > 0;
    return view;
}

/* Indices of accessors: two for the cloth, its targets, times and weights, two for each solid, one
 * for each solid that moves, and one for each that rotates. */
enum { CLOTH_ACCESSOR, CORNERS_ACCESSOR, TARGET_ACCESSOR };

static int times_accessor(const gltf *g) {
    return TARGET_ACCESSOR + g->frames->count - 1;
}

static int solid_accessor(const gltf *g, int number) {
    return times_accessor(g) + (g->frames->count > 1 ? 2 : 0) + 2 * number;
}

static int path_accessor(const gltf *g, int number) {
    return solid_accessor(g, g->solid_count) + gltf_moving_before(g, number);
}

static int turn_accessor(const gltf *g, int number) {
    return path_accessor(g, g->solid_count) + gltf_rotating_before(g, number);
}

typedef enum accessor_kind { POINTS, INDICES, NUMBERS, QUATERNIONS } accessor_kind;
static const char *const accessor_types[] = {"VEC3", "SCALAR", "SCALAR", "VEC4"};

/** Writes an accessor. `box` has its bounds (those of numbers in the first coordinate), or is
 *  NULL. */
static void put_accessor(FILE *json, accessor_kind kind, int view, uint64_t offset, long count,
                         const bounds *box) {
    fprintf(json, "{\"bufferView\":%d,\"byteOffset\":%llu,\"componentType\":%d,\"count\":%ld,",
            view, (unsigned long long)offset, kind == INDICES ? 5125 : 5126, count);
    for (int high = 0; box && high < 2; high++) {
        const float *at = high ? box->high : box->low;
        fprintf(json, "\"%s\":[%.9g", high ? "max" : "min", (double)at[0]);
        for (int a = 1; a < 3 && kind == POINTS; a++)
            fprintf(json, ",%.9g", (double)at[a]);
        fputs("],", json);
    }
    fprintf(json, "\"type\":\"%s\"}", accessor_types[kind]);
}

static void put_next_accessor(FILE *json, accessor_kind kind, int view, uint64_t offset, long count,
                              const bounds *box) {
    fputs(",\n", json);
    put_accessor(json, kind, view, offset, count, box);
}

static void put_cloth_accessors(const gltf *g, const uint64_t size[PARTS], FILE *json) {
    const int frames = g->frames->count, vertices = g->frames->vertex_count;
    const double *time = g->frames->time;
    put_accessor(json, POINTS, view_of(size, CLOTH), 0, vertices, &g->frame[0]);
    put_next_accessor(json, INDICES, view_of(size, CORNERS), 0, 3L * g->frames->triangle_count,
                      NULL);
    for (int k = 1; k < frames; k++)
        put_next_accessor(json, POINTS, view_of(size, TARGETS),
                          12 * (uint64_t)vertices * (uint64_t)(k - 1), vertices, &g->frame[k]);
    if (frames == 1)
        return;
    const bounds span = {{(float)time[0], 0, 0}, {(float)time[frames - 1], 0, 0}};
    put_next_accessor(json, NUMBERS, view_of(size, TIMES), 0, frames, &span);
    put_next_accessor(json, NUMBERS, view_of(size, WEIGHTS), 0, (long)frames * (frames - 1), NULL);
}

static void put_accessors(const gltf *g, const uint64_t size[PARTS], FILE *json) {
    uint64_t points = 0, corners = 0, path = 0, turn = 0;
    fputs("\"accessors\":[\n", json);
    put_cloth_accessors(g, size, json);
    for (int k = 0; k < g->solid_count; k++) {
        const mesh *m = &g->solids[k].surface;
        put_next_accessor(json, POINTS, view_of(size, SOLIDS), points, m->vertex_count,
                          &g->solids[k].box);
        put_next_accessor(json, INDICES, view_of(size, SOLID_CORNERS), corners,
                          3L * m->triangle_count, NULL);
        points += 12 * (uint64_t)m->vertex_count;
        corners += 12 * (uint64_t)m->triangle_count;
    }
    for (int k = 0; k < g->solid_count && size[PATHS] > 0; k++)
        if (gltf_is_moving(g->solids[k].of)) {
            put_next_accessor(json, POINTS, view_of(size, PATHS), path, g->frames->count, NULL);
            path += 12 * (uint64_t)g->frames->count;
        }
    for (int k = 0; k < g->solid_count && size[TURNS] > 0; k++)
        if (motion_rotates(g->solids[k].of)) {
            put_next_accessor(json, QUATERNIONS, view_of(size, TURNS), turn, g->frames->count,
                              NULL);
            turn += 16 * (uint64_t)g->frames->count;
        }
    fputs("\n],\n", json);
}

static void put_views(const uint64_t size[PARTS], FILE *json) {
    uint64_t offset = 0;
    const char *comma = "";
    fputs("\"bufferViews\":[", json);
    for (int part = 0; part < PARTS; part++) {
        const int is_mesh = part != TIMES && part != WEIGHTS && part < PATHS;
        const int is_corners = part == CORNERS || part == SOLID_CORNERS;
        if (size[part] == 0)
            continue;
        fprintf(json, "%s\n{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu", comma,
                (unsigned long long)offset, (unsigned long long)size[part]);
        /* The targets are ELEMENT_ARRAY_BUFFER and ARRAY_BUFFER. A view of vertices must have a
         * stride. */
        if (is_mesh)
            fputs(is_corners ? ",\"target\":34963" : ",\"byteStride\":12,\"target\":34962", json);
        fputc('}', json);
        offset += size[part];
        comma = ",";
    }
    fputs("\n],\n", json);
}

static void put_meshes(const gltf *g, FILE *json) {
    const int targets = g->frames->count - 1;
    fprintf(json,
            "\"meshes\":[\n{\"name\":\"cloth\",\"primitives\":[{\"attributes\":{\"POSITION\":%d},"
            "\"indices\":%d,\"material\":0",
            CLOTH_ACCESSOR, CORNERS_ACCESSOR);
    for (int k = 0; k < targets; k++)
        fprintf(json, "%s{\"POSITION\":%d}", k == 0 ? ",\"targets\":[" : ",", TARGET_ACCESSOR + k);
    fputs(targets > 0 ? "]}],\"weights\":[0" : "}]", json);
    for (int k = 1; k < targets; k++)
        fputs(",0", json);
    fputs(targets > 0 ? "]}" : "}", json);
    for (int k = 0; k < g->solid_count; k++)
        fprintf(json,
                ",\n{\"name\":\"%s\",\"primitives\":[{\"attributes\":{\"POSITION\":%d},"
                "\"indices\":%d,\"material\":%d}]}",
                collider_names[g->solids[k].of->kind], solid_accessor(g, k),
                solid_accessor(g, k) + 1, g->solids[k].of->kind == COLLIDER_PLANE ? 2 : 1);
    fputs("\n],\n", json);
}

static void put_nodes(const gltf *g, FILE *json) {
    fputs("\"asset\":{\"version\":\"2.0\",\"generator\":\"fabric " FABRIC_VERSION "\"},\n"
          "\"scene\":0,\n\"scenes\":[{\"nodes\":[0",
          json);
    for (int k = 1; k <= g->solid_count; k++)
        fprintf(json, ",%d", k);
    fputs("]}],\n\"nodes\":[\n{\"name\":\"cloth\",\"mesh\":0}", json);
    for (int k = 0; k < g->solid_count; k++) {
        double at[3];
        gltf_place(g->solids[k].of, g->frames->time[0], at);
        fprintf(json, ",\n{\"name\":\"%s\",\"mesh\":%d,\"translation\":[%.9g,%.9g,%.9g]",
                collider_names[g->solids[k].of->kind], k + 1, at[0], at[1], at[2]);
        if (motion_rotates(g->solids[k].of)) {
            double q[4];
            gltf_rotation(g->solids[k].of, g->frames->time[0], q);
            fprintf(json, ",\"rotation\":[%.9g,%.9g,%.9g,%.9g]", q[0], q[1], q[2], q[3]);
        }
        fputc('}', json);
    }
    fputs("\n],\n", json);
}

static void put_materials(FILE *json) {
    static const char *const colors[] = {"0.25,0.45,0.65", "0.75,0.45,0.22", "0.7,0.7,0.7"};
    static const char *const names[] = {"cloth", "collider", "plane"};
    fputs("\"materials\":[", json);
    for (int k = 0; k < 3; k++)
        fprintf(json,
                "%s\n{\"name\":\"%s\",\"doubleSided\":true,\"pbrMetallicRoughness\":"
                "{\"baseColorFactor\":[%s,1],\"metallicFactor\":0,\"roughnessFactor\":0.8}}",
                k > 0 ? "," : "", names[k], colors[k]);
    fputs("\n],\n", json);
}

static void put_animation(const gltf *g, FILE *json) {
    int sampler = 1;
    if (g->frames->count == 1)
        return;
    fprintf(json,
            "\"animations\":[{\"name\":\"run\",\n\"samplers\":[{\"input\":%d,\"output\":%d,"
            "\"interpolation\":\"LINEAR\"}",
            times_accessor(g), times_accessor(g) + 1);
    for (int k = 0; k < g->solid_count; k++)
        if (gltf_is_moving(g->solids[k].of))
            fprintf(json, ",\n{\"input\":%d,\"output\":%d,\"interpolation\":\"LINEAR\"}",
                    times_accessor(g), path_accessor(g, k));
    for (int k = 0; k < g->solid_count; k++)
        if (motion_rotates(g->solids[k].of))
            fprintf(json, ",\n{\"input\":%d,\"output\":%d,\"interpolation\":\"LINEAR\"}",
                    times_accessor(g), turn_accessor(g, k));
    fputs("],\n\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"weights\"}}", json);
    for (int k = 0; k < g->solid_count; k++)
        if (gltf_is_moving(g->solids[k].of))
            fprintf(json, ",\n{\"sampler\":%d,\"target\":{\"node\":%d,\"path\":\"translation\"}}",
                    sampler++, k + 1);
    for (int k = 0; k < g->solid_count; k++)
        if (motion_rotates(g->solids[k].of))
            fprintf(json, ",\n{\"sampler\":%d,\"target\":{\"node\":%d,\"path\":\"rotation\"}}",
                    sampler++, k + 1);
    fputs("]}],\n", json);
}

char *gltf_json(const gltf *g, size_t *length) {
    char *text = NULL;
    uint64_t size[PARTS];
    FILE *json = open_memstream(&text, length);
    if (!json)
        return NULL;
    gltf_measure(g, size);
    fputs("{", json);
    put_nodes(g, json);
    put_materials(json);
    put_meshes(g, json);
    put_animation(g, json);
    put_accessors(g, size, json);
    put_views(size, json);
    fprintf(json, "\"buffers\":[{\"byteLength\":%llu", (unsigned long long)g->bytes);
    const int failed = ferror(json);
    if (fclose(json) == 0 && !failed)
        return text;
    free(text);
    return NULL;
}
