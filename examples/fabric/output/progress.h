/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Progress of a run: the steps done, the remaining time, and signs of life. */
#ifndef FABRIC_OUTPUT_PROGRESS_H
#define FABRIC_OUTPUT_PROGRESS_H

typedef enum progress_style {
    PROGRESS_AUTO,  /* a bar on a terminal, else lines */
    PROGRESS_BAR,   /* one line on standard error that is written over */
    PROGRESS_LINES, /* ten lines or so on standard error, more where steps are long */
    PROGRESS_JSON,  /* one JSON object a step on standard output, and nothing else there */
    PROGRESS_NONE
} progress_style;

/** The styles' names, in their order, NULL after the last. */
extern const char *const progress_styles[];

/** Resolves AUTO; the others stay. */
progress_style progress_resolve(progress_style style);

/** One at a time in a program: the sign of life is the process' alarm signal. */
typedef struct progress {
    progress_style style;
    long first, steps; /* the run begins after step `first` and ends with `steps` */
    double pace;       /* s a step takes, by the last ones */
    double last;       /* s, when the last step ended */
} progress;

/** Begins to report. With a bar or lines, a step that takes long shows signs of life (SIGALRM): a
 *  bar counts its seconds, lines say every minute which step is under way. */
void progress_begin(progress *p, progress_style style, long first, long steps);

/** Reports that a step is done. time: simulated, seconds: wall, since progress_begin, both s. */
void progress_tell(progress *p, long step, double time, long iterations, double seconds);

/** No more signs of life; a bar's line is ended. */
void progress_end(progress *p);

#endif
