/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A file with a cloth's state: final.state has all bits; frames have the data for pictures.
 *
 * It is a sealed file (sealed_file.h) of kind "FABRICST", version 1; its parts are the bits of
 * state_part.
 *
 * The payload has these arrays in this order, each one only if its bit is set (positions always):
 * positions [vertices][3] (m; float with STATE_SINGLE, else double), velocities [vertices][3]
 * (double, m/s), triangles [triangles][3] (int32, vertices), original numbers [vertices] (int32:
 * each vertex's number in the mesh as generated, to compare states of one cloth in two orders).
 */
#ifndef FABRIC_OUTPUT_STATE_H
#define FABRIC_OUTPUT_STATE_H

typedef enum state_part {
    STATE_VELOCITIES = 1,
    STATE_TRIANGLES = 2,
    STATE_ORIGINAL = 4,
    STATE_SINGLE = 8 /* positions are float in the file, double in memory; not with velocities */
} state_part;

typedef struct state {
    int vertex_count;
    int triangle_count;
    double time; /* s */
    long step;
    unsigned parts;         /* bits of state_part */
    const double *position; /* [3 * vertex_count] m */
    const double *velocity; /* [3 * vertex_count] m/s; NULL without STATE_VELOCITIES */
    const int *triangle;    /* [3 * triangle_count]; NULL without STATE_TRIANGLES */
    const int *original;    /* [vertex_count]; NULL without STATE_ORIGINAL */
    void *memory;           /* allocated by state_read, freed by state_free */
} state;

/** Writes a temporary file and renames it, so that a file of that name is always complete. Returns
 *  0, or -1 after a message on standard error. */
int state_write(const state *s, const char *path);

/** Reads and checks the file; state_free frees it. Returns 0, or -1 after a message on standard
 *  error if the file is no state, incomplete, damaged or of another version. */
int state_read(state *s, const char *path);

void state_free(state *s);

#endif
