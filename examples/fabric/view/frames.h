/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The states that `fabric run` wrote to DIR/frames; the first contains the triangles. */
#ifndef FABRIC_VIEW_FRAMES_H
#define FABRIC_VIEW_FRAMES_H

#include "base/files.h"
#include "output/state.h"

typedef struct frames {
    char folder[FILE_PATH_SIZE]; /* DIR/frames */
    long *steps;                 /* [count] the steps of the frames, ascending */
    int count;
    state first;
} frames;

/** Finds the frames of the run in `folder` and reads the first. Returns 0, or -1 after a message;
 *  call frames_close in either case. */
int frames_open(frames *f, const char *folder);
void frames_close(frames *f);

/** Reads frame `number` (0 <= number < count); state_free frees it. Returns 0, or -1 after a
 *  message. */
int frames_read(const frames *f, int number, state *s);

#endif
