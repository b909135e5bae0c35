/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The frames of a run, for writers of other programs' formats. */
#ifndef FABRIC_VIEW_RUN_FRAMES_H
#define FABRIC_VIEW_RUN_FRAMES_H

#include "view/cloth_frames.h"
#include "view/frames.h"

/** The frames in a run's folder. */
typedef struct run_frames {
    frames files;
    double *time;    /* [files.count] s */
    cloth_frames of; /* points to `files` and `time`, so a run_frames must not be copied */
} run_frames;

/** Opens the run in `folder` and reads all of its frames once, so that a damaged one is found
 *  before any output is written. Returns 0, or -1 after a message; call run_frames_finish in either
 *  case. */
int run_frames_open(run_frames *r, const char *folder);

/** Closes the run after an export to `to`, which is reported if `status` is 0. Returns `status`. */
int run_frames_finish(run_frames *r, int status, const char *to);

#endif
