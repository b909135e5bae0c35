/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/checkpoint.h"

#include <stdlib.h>
#include <string.h>

#include "mesh/surface.h"
#include "output/sealed_file.h"

/** The beginning of the payload. */
typedef struct prologue {
    uint64_t cloth_hash, collider_hash;
    uint64_t text_size, saved_size;
    int64_t frames, every;
    double seconds;
    uint64_t zero;
} prologue;
_Static_assert(sizeof(prologue) == 64, "the payload's beginning has no padding");

static int check_header(const sealed_header *header) {
    return header->payload_size < sizeof(prologue) ? -1 : 0;
}

static const sealed_kind CHECKPOINT_KIND = {"FABRICCP", 2, "a checkpoint", 1, check_header};

static uint64_t hash_mesh(uint64_t hash, const mesh *m) {
    const size_t vertices = (size_t)m->vertex_count, triangles = (size_t)m->triangle_count;
    hash = fnv_1a(hash, m->position, sizeof *m->position * vertices);
    hash = fnv_1a(hash, m->material, sizeof *m->material * vertices);
    return fnv_1a(hash, m->triangle, sizeof *m->triangle * triangles);
}

/* The hash includes the hinges, because a checkpoint stores their angles in this order. */
static uint64_t hash_cloth(const mesh *m) {
    const uint64_t hash = hash_mesh(FNV_1A_BEGIN, m);
    return fnv_1a(hash, m->hinge, sizeof *m->hinge * (size_t)m->hinge_count);
}

static uint64_t hash_colliders(const scene *s) {
    uint64_t hash = FNV_1A_BEGIN;
    for (int n = 0; n < s->collider_count; n++)
        if (s->colliders[n].surface)
            hash = hash_mesh(hash, surface_mesh(s->colliders[n].surface));
    return hash;
}

int checkpoint_write(const run_record *record, const scene *s, const mesh *cloth, simulation *sim,
                     const char *path) {
    prologue first = {.cloth_hash = hash_cloth(cloth),
                      .collider_hash = hash_colliders(s),
                      .saved_size = simulation_saved_size(sim),
                      .frames = record->frames,
                      .every = record->every,
                      .seconds = record->seconds};
    size_t text_size;
    char *text = scene_text(s, &text_size);
    first.text_size = text ? text_size : 0;
    sealed_header header = {.vertex_count = cloth->vertex_count,
                            .triangle_count = cloth->triangle_count,
                            .time = simulation_time(sim),
                            .step = record->step,
                            .payload_size = sizeof first + first.text_size + first.saved_size};
    unsigned char *payload = text ? malloc(header.payload_size) : NULL;
    int status = -1;
    if (!payload) {
        sealed_file_complain(path, "out of memory");
    } else {
        memcpy(payload, &first, sizeof first);
        memcpy(payload + sizeof first, text, text_size);
        simulation_save(sim, payload + sizeof first + text_size, first.saved_size);
        status = sealed_file_write(&CHECKPOINT_KIND, &header, payload, path);
    }
    free(payload);
    free(text);
    return status;
}

static int check_prologue(const sealed_header *header, const prologue *first) {
    const uint64_t rest = header->payload_size - sizeof *first;
    return header->parts == 0 && header->vertex_count > 0 && header->step >= 0 &&
                   first->text_size <= rest && first->saved_size == rest - first->text_size &&
                   first->frames >= 0 && first->every >= 0 && first->zero == 0
               ? 0
               : -1;
}

/** Sets c's pointers into the payload, which is in c->memory. Returns 0, or -1 after a message. */
static int unpack(checkpoint *c, const sealed_header *header, const char *path) {
    unsigned char *payload = c->memory;
    prologue first;
    memcpy(&first, payload, sizeof first);
    if (check_prologue(header, &first) != 0)
        return sealed_file_complain(path, "damaged: its header contradicts itself");
    c->record = (run_record){.step = (long)header->step,
                             .frames = (long)first.frames,
                             .every = (long)first.every,
                             .seconds = first.seconds};
    c->cloth_hash = first.cloth_hash;
    c->collider_hash = first.collider_hash;
    c->vertex_count = header->vertex_count;
    c->triangle_count = header->triangle_count;
    c->text = (char *)payload + sizeof first;
    c->text_size = first.text_size;
    c->saved = payload + sizeof first + first.text_size;
    c->saved_size = first.saved_size;
    return scene_read_text(&c->of, c->text, c->text_size, path);
}

int checkpoint_read(checkpoint *c, const char *path) {
    sealed_header header;
    *c = (checkpoint){.memory = sealed_file_read(&CHECKPOINT_KIND, &header, path)};
    if (c->memory && unpack(c, &header, path) == 0)
        return 0;
    checkpoint_free(c);
    return -1;
}

void checkpoint_free(checkpoint *c) {
    scene_free(&c->of);
    free(c->memory);
    *c = (checkpoint){.memory = NULL};
}

int checkpoint_restore(checkpoint *c, const scene *s, const mesh *cloth, simulation *sim,
                       const char *path) {
    if (c->vertex_count != cloth->vertex_count || c->triangle_count != cloth->triangle_count ||
        c->cloth_hash != hash_cloth(cloth))
        return sealed_file_complain(path, "of another mesh than its scene now gives: is this "
                                          "another version of the program, or of a library?");
    if (c->collider_hash != hash_colliders(s))
        return sealed_file_complain(path, "a collider's file has changed since the run began");
    if (simulation_restore(sim, c->saved, c->saved_size) != 0)
        return sealed_file_complain(path, "damaged: what it holds is no state of its scene");
    return 0;
}
