/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Frames of a cloth from any source, for writers of other programs' formats. */
#ifndef FABRIC_VIEW_CLOTH_FRAMES_H
#define FABRIC_VIEW_CLOTH_FRAMES_H

#include "output/state.h"

/** Data common to all frames, and a function that reads one. */
typedef struct cloth_frames {
    int count;          /* number of frames */
    const double *time; /* [count] s */
    int vertex_count;
    int triangle_count;
    const int *triangle; /* [3 * triangle_count] */
    /** Reads frame `number` (0 <= number < count), which the caller frees by state_free. Returns 0,
     *  or -1 after a message. */
    int (*read)(void *context, int number, state *s);
    void *context;
} cloth_frames;

#endif
