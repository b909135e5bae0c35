/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Execution by owners without an inspection that assigns iterations to threads. Each thread scans
 * all iterations, block by block. It first classifies the iterations of a block by whether they
 * touch an element that the thread owns (REDCC_SELECT). Those that do form the runs that the thread
 * executes. All threads stop at the first iteration that leaves a fence (ownership/fences.h).
 */
#ifndef REDCC_EXECUTE_SELECT_H
#define REDCC_EXECUTE_SELECT_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** The classes of 64 iterations, with one bit for each iteration. */
struct class_bits {
    uint64_t executed; /* this thread executes the iteration */
    uint64_t shared;   /* another thread also owns rows that the iteration touches */
    uint64_t follows;  /* another thread stores the operands that the iteration adds to series */
};

enum { REDCC_SELECTED_WORDS = REDCC_SELECTED / 64 };

/** One thread's selection of iterations. */
struct selection {
    redcc_owner *window;  /* [array_count] the elements that the thread owns */
    redcc_int trip;       /* number of iterations of the loop */
    redcc_int idle_begin; /* the thread executes those iterations in [idle_begin, idle_end) that
                           * touch nothing */
    redcc_int idle_end;
    redcc_int executed; /* number of iterations executed so far */
    redcc_int end;      /* the first iteration that leaves a fence; `trip` if none is found yet */
    bool asked;      /* the classes of iterations from worker->first on were requested and are not
                        evaluated yet */
    redcc_int taken; /* number of classified iterations that were already handed out or skipped */
    bool follows;    /* the value of redcc_variant.follows for the runs that were handed out last */
    unsigned char class[REDCC_SELECTED];
    struct class_bits bits[REDCC_SELECTED_WORDS]; /* the classes, once they are evaluated */
};

/** Begins a selection; selection->window must be set. */
void redcc_selection_begin(struct selection *selection, redcc_worker *worker, redcc_int trip);

/** Assigns to the thread the iterations in [begin, end) that touch nothing. */
void redcc_selection_set_idle(struct selection *selection, redcc_int begin, redcc_int end);

/** Requests the classes of the next iterations. False: none is left. */
bool redcc_selection_ask(struct selection *selection, redcc_worker *worker);

/** Writes runs of classified iterations into `to`[REDCC_SELECTED]; their `begin` is relative to
 * worker->first. All of them have the same class bit `follows`, which is stored in
 * selection->follows. If `hooked` is set, they are owner-checked. Returns the number of runs (0:
 * none is left) and sets *iterations to the number of their iterations. */
size_t redcc_selection_take(struct selection *selection, const redcc_worker *worker, bool hooked,
                            redcc_iterations *to, redcc_int *iterations);

#endif
