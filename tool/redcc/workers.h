/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Work in separate processes: a crash affects one piece of work only, and several run at once. */
#ifndef WORKERS_H
#define WORKERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct workers {
    unsigned count;     /* pieces of work, numbered from 0 */
    unsigned at_once;   /* the number of processes; 0: the caller's own process does the work, and a
                         * crash ends it */
    size_t result_size; /* bytes of a result, without pointers */
    bool keeps_output; /* the output of a piece is kept, and is shown as a whole after the output of
                        * all pieces before it */
    /** Takes the standard output of a piece, which is then not shown. May be NULL; otherwise output
     * is kept. Called in the caller's process, in order, before `done`. `output` is at its
     * beginning, and is closed afterwards. Not called with at_once 0. */
    void (*take)(unsigned number, FILE *output, void *context);
    /** Called in a separate process: does the piece of work and fills in *result, which is zero
     *  before. */
    void (*work)(unsigned number, void *result, void *context);
    /** Called in the caller's process, in the order of the pieces. `ended_by`: 0 if the piece's
     * process succeeded; the signal that ended it; or -1 if it failed otherwise. */
    void (*done)(unsigned number, const void *result, int ended_by, void *context);
    /** Reports the number of finished pieces; may be NULL. Called in the caller's process, as
     * pieces end, in any order. */
    void (*progress)(unsigned finished, void *context);
    void *context;
} workers;

/** Does all pieces of work. Returns false if no process or memory is available; even then, waits
 *  for all processes that were started. */
bool workers_run(const workers *w);

/** Reports on standard error that the process of this file failed; `ended_by` as for done. */
void workers_explain(const char *path, int ended_by);

#endif
