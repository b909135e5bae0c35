/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Progress of a run: the steps done, the remaining time, and signs of life during long steps. */
#ifndef FABRIC_OUTPUT_PROGRESS_H
#define FABRIC_OUTPUT_PROGRESS_H

typedef enum progress_style {
    PROGRESS_AUTO,  /* a bar on a terminal, else lines */
    PROGRESS_BAR,   /* one line on standard error, overwritten at each step */
    PROGRESS_LINES, /* about ten lines on standard error, more if steps are long */
    PROGRESS_JSON,  /* one JSON object per step on standard output, and nothing else there */
    PROGRESS_NONE
} progress_style;

/** The styles' names, in their order, NULL after the last. */
extern const char *const progress_styles[];

/** Replaces PROGRESS_AUTO by the style for standard error. Returns other styles unchanged. */
progress_style progress_resolve(progress_style style);

/** State of the reports. Only one may be active in a process, because signs of life use the
 *  process's alarm signal. */
typedef struct progress {
    progress_style style;
    long first, steps; /* the run begins after step `first` and ends with `steps` */
    double pace;       /* s per step, moving average */
    double last;       /* s, time at which the last step ended */
} progress;

/** Begins to report. With a bar or lines, a step that takes long shows signs of life (SIGALRM): a
 *  bar counts its seconds, lines say every minute which step is under way. */
void progress_begin(progress *p, progress_style style, long first, long steps);

/** Reports that a step is done. `time` is simulated time, `seconds` wall time since progress_begin,
 *  both in s. */
void progress_report(progress *p, long step, double time, long iterations, double seconds);

/** Ends the signs of life and a bar's line. */
void progress_end(progress *p);

#endif
