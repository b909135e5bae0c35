/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Frames of a cloth, wherever they come from, for what writes them in a format of other programs.
 */
#ifndef FABRIC_VIEW_CLOTH_FRAMES_H
#define FABRIC_VIEW_CLOTH_FRAMES_H

#include "output/state.h"

/** What all frames share, and how to read each. */
typedef struct cloth_frames {
    int count;          /* frames */
    const double *time; /* [count] s */
    int vertex_count;
    int triangle_count;
    const int *triangle; /* [3 * triangle_count] */
    /** Reads frame 0 <= number < count, to be freed with state_free. 0, or -1 after a message. */
    int (*read)(void *context, int number, state *s);
    void *context;
} cloth_frames;

#endif
