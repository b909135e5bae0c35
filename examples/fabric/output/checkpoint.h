/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A run between two steps in a file, from which it continues with the same bits.
 *
 * The file is a sealed one (sealed_file.h) of kind "FABRICCP", version 1, without parts. Payload:
 *
 *   0  uint64   FNV-1a of the cloth's mesh
 *   8  uint64   FNV-1a of the meshes of colliders
 *  16  uint64   bytes of the scene's text
 *  24  uint64   bytes of the simulation
 *  32  int64    frames: as --frames
 *  40  int64    steps between checkpoints: as --checkpoint-every; 0: none
 *  48  double   s, wall, that the steps so far took
 *  56  uint64   0
 *  64  the scene as a scene file has it, with the count of steps that the run is to have
 *      the simulation as simulation_save has it
 */
#ifndef FABRIC_OUTPUT_CHECKPOINT_H
#define FABRIC_OUTPUT_CHECKPOINT_H

#include <stdint.h>

#include "step/simulation.h"

/** State of a run, except its simulation. */
typedef struct run_record {
    long step;      /* steps of the scene done */
    long frames;    /* how many states are kept for pictures */
    long every;     /* steps from one checkpoint to the next; 0: none */
    double seconds; /* wall, that the steps took */
} run_record;

typedef struct checkpoint {
    run_record record;
    scene of;
    uint64_t cloth_hash, collider_hash;
    int vertex_count, triangle_count;
    char *text; /* [text_size] the scene's */
    size_t text_size;
    unsigned char *saved; /* [saved_size] for simulation_restore */
    size_t saved_size;
    void *memory; /* what checkpoint_read allocated: checkpoint_free's */
} checkpoint;

/** Writes a temporary file and renames it. 0, or -1 after a message: an older file is unchanged. */
int checkpoint_write(const run_record *record, const scene *s, const mesh *cloth, simulation *sim,
                     const char *path);

/** Reads and checks all data that do not need the mesh; checkpoint_free frees it. 0, or -1 after
 *  a message about the defect. */
int checkpoint_read(checkpoint *c, const char *path);
void checkpoint_free(checkpoint *c);

/** Brings a simulation that has just been made, of this mesh and scene, to where the run was. 0, or
 *  -1 after a message: another mesh, another collider, or bytes that make no sense. */
int checkpoint_restore(checkpoint *c, const scene *s, const mesh *cloth, simulation *sim,
                       const char *path);

#endif
