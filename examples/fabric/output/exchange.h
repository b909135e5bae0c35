/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Frames of a run in formats of other programs: a point cache, which holds the positions of all
 * frames of a mesh, and VTK's files of one frame each. All are written beside, then renamed.
 * Functions return 0, or -1 after a message on standard error.
 */
#ifndef FABRIC_OUTPUT_EXCHANGE_H
#define FABRIC_OUTPUT_EXCHANGE_H

#include "output/state.h"

/** What all frames share, and how to come by them. */
typedef struct cloth_frames {
    int count;          /* frames */
    const double *time; /* [count] s */
    int vertex_count;
    int triangle_count;
    const int *triangle; /* [3 * triangle_count] */
    /** Reads frame 0 <= number < count, to be freed with state_free. */
    int (*read)(void *context, int number, state *s);
    void *context;
} cloth_frames;

/** A PC2 point cache: "POINTCACHE2", version 1, vertices, first frame, rate, frames; then positions
 *  as float [frames][vertices][3], little-endian. */
int pc2_write(const cloth_frames *frames, const char *path);

/** A frame as an unstructured grid of VTK's XML, ASCII. */
int vtu_write(const cloth_frames *frames, const state *s, const char *path);

/** The collection of `frames`' .vtu files: file[k], a name beside `path`, at time[k]. */
int pvd_write(const cloth_frames *frames, char (*file)[32], const char *path);

#endif
