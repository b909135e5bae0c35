/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A file with the state of a run between two steps, from which the run continues with the same
 * bits.
 *
 * It is a sealed file (sealed_file.h) of kind "FABRICCP", version 2, without parts. Payload:
 *
 *     0  uint64   FNV-1a of the cloth's mesh
 *     8  uint64   FNV-1a of the meshes of colliders
 *    16  uint64   bytes of the scene's text
 *    24  uint64   bytes of the simulation's state
 *    32  int64    number of states kept for pictures (--frames)
 *    40  int64    steps between checkpoints (--checkpoint-every); 0: none
 *    48  double   wall time of the steps so far, s
 *    56  uint64   0
 *    64  the scene in the format of scene files, with the run's total number of steps
 *        the simulation's state as simulation_save writes it
 */
#ifndef FABRIC_OUTPUT_CHECKPOINT_H
#define FABRIC_OUTPUT_CHECKPOINT_H

#include <stdint.h>

#include "step/simulation.h"

/** State of a run, except its simulation. */
typedef struct run_record {
    long step;      /* number of completed steps of the scene */
    long frames;    /* number of states kept for pictures */
    long every;     /* number of steps from one checkpoint to the next; 0: no checkpoints */
    double seconds; /* wall time of the steps */
} run_record;

typedef struct checkpoint {
    run_record record;
    scene of;
    uint64_t cloth_hash, collider_hash;
    int vertex_count, triangle_count;
    char *text; /* [text_size] the scene's text */
    size_t text_size;
    unsigned char *saved; /* [saved_size] bytes for simulation_restore */
    size_t saved_size;
    void *memory; /* allocated by checkpoint_read, freed by checkpoint_free */
} checkpoint;

/** Writes a temporary file and renames it. Returns 0, or -1 after a message; an older file is then
 *  unchanged. */
int checkpoint_write(const run_record *record, const scene *s, const mesh *cloth, simulation *sim,
                     const char *path);

/** Reads the file and checks all that can be checked without the mesh; checkpoint_free frees it.
 *  Returns 0, or -1 after a message about the defect. */
int checkpoint_read(checkpoint *c, const char *path);
void checkpoint_free(checkpoint *c);

/** Restores the run's state in a new simulation of this mesh and scene. Returns 0, or -1 after a
 *  message if the mesh or a collider differs or the bytes are invalid. */
int checkpoint_restore(checkpoint *c, const scene *s, const mesh *cloth, simulation *sim,
                       const char *path);

#endif
