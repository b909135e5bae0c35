/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How far a run is. */
#ifndef FABRIC_OUTPUT_PROGRESS_H
#define FABRIC_OUTPUT_PROGRESS_H

typedef enum progress_style {
    PROGRESS_AUTO,  /* a bar on a terminal, else lines */
    PROGRESS_BAR,   /* one line on standard error that is written over */
    PROGRESS_LINES, /* ten lines or so on standard error */
    PROGRESS_JSON,  /* one JSON object a step on standard output, and nothing else there */
    PROGRESS_NONE
} progress_style;

/** The styles' names, in their order, NULL after the last. */
extern const char *const progress_styles[];

/** AUTO becomes what it stands for; the others stay. */
progress_style progress_resolve(progress_style style);

/** Tells that step `step` of `steps` is done. time: simulated, seconds: wall, both s. */
void progress_tell(progress_style style, long step, long steps, double time, long iterations,
                   double seconds);

#endif
