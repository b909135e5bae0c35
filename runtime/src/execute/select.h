/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Executes by owners, without an inspection that records which thread executes what. Each thread
 * scans all iterations, block by block. Iterations of a block are first classified by whether they
 * touch an element that it owns (REDCC_SELECT); the matching ones form the runs that it executes.
 */
#ifndef REDCC_EXECUTE_SELECT_H
#define REDCC_EXECUTE_SELECT_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>

/** One thread's selection. */
struct selection {
    redcc_owner *window;  /* [arrays] the range that the thread owns */
    redcc_int trip;       /* iterations of the loop */
    redcc_int idle_begin; /* of the iterations that touch nothing, the thread executes [idle_begin,
                           * idle_end) */
    redcc_int idle_end;   /* end of these */
    redcc_int executed;   /* iterations so far */
    bool asked;           /* classes for worker->first, ... were requested, and are not evaluated
                           * yet */
    redcc_int taken;      /* number of classified iterations already handed out */
    bool follows;         /* the last runs handed out had this flag (redcc_variant) */
    unsigned char class[REDCC_SELECTED];
};

/** Begins: selection->window is the range that the thread owns. */
void redcc_selection_begin(struct selection *selection, redcc_worker *worker, redcc_int trip);

/** Assigns these of the iterations that touch nothing to the thread. */
void redcc_selection_set_idle(struct selection *selection, redcc_int begin, redcc_int end);

/** Requests the classes of the next iterations. False: none is left. */
bool redcc_selection_ask(struct selection *selection, redcc_worker *worker);

/** Writes runs of the classified iterations, relative to worker->first, into `to` [REDCC_SELECTED]:
 *  of all that are left, or of those in which the thread leads, or follows (selection->follows).
 *  hooked: all are owner-checked. Returns their number, 0: none is left; *iterations: the
 *  iterations in them. */
size_t redcc_selection_take(struct selection *selection, const redcc_worker *worker, bool hooked,
                            redcc_iterations *to, redcc_int *iterations);

#endif
