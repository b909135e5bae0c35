/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Owners without an inspection of who executes what: each thread goes through all iterations,
 * block by block. Of a block it is told first which iterations touch what it owns (REDCC_SELECT);
 * these are the runs that it executes then.
 */
#ifndef REDCC_EXECUTE_SELECT_H
#define REDCC_EXECUTE_SELECT_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>

/** One thread's. */
struct selection {
    redcc_owner *window;  /* [arrays] what the thread owns */
    redcc_int trip;       /* iterations of the loop */
    redcc_int idle_begin; /* of iterations that touch nothing, the thread executes those */
    redcc_int idle_end;   /* from one to before the other */
    redcc_int executed;   /* iterations so far */
    bool asked;           /* for classes of worker->first, ...: they are not looked at yet */
    redcc_int taken;      /* of them, so many are handed out, */
    bool follows;         /* the last ones so (redcc_manner) */
    unsigned char class[REDCC_SELECTED];
};

/** Begins: the thread owns what selection->window says. */
void redcc_selection_begin(struct selection *selection, redcc_worker *worker, redcc_int trip);

/** Of iterations that touch nothing, these are the thread's. */
void redcc_selection_set_idle(struct selection *selection, redcc_int begin, redcc_int end);

/** Asks for the classes of the next iterations. False: there are none left. */
bool redcc_selection_ask(struct selection *selection, redcc_worker *worker);

/** Runs of the iterations that were asked for, relative to worker->first, into `to`
 *  [REDCC_SELECTED]: of all that are left, or of those that the thread leads in, or follows in
 *  (selection->follows). hooked: all guarded. Returns how many, 0: nothing is left; *iterations: in
 *  them. */
size_t redcc_selection_take(struct selection *selection, const redcc_worker *worker, bool hooked,
                            redcc_iterations *to, redcc_int *iterations);

#endif
