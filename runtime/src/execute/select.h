/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Execution by owners without an inspection that assigns iterations to threads. Each thread scans
 * all iterations, block by block. It first classifies the iterations of a block by whether they
 * touch an element that the thread owns (REDCC_SELECT). Those that do form the runs that the thread
 * executes. All threads stop at the first iteration that leaves a fence (ownership/fences.h). With
 * a survey (survey.h), a thread skips those blocks that another thread has found to touch only that
 * thread's elements.
 */
#ifndef REDCC_EXECUTE_SELECT_H
#define REDCC_EXECUTE_SELECT_H

#include "execute/survey.h"
#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** One thread's selection of iterations. */
struct selection {
    redcc_owner *window;  /* [array_count] the elements that the thread owns */
    redcc_int trip;       /* number of iterations of the loop */
    redcc_int idle_begin; /* the thread executes those iterations in [idle_begin, idle_end) that
                           * touch nothing */
    redcc_int idle_end;
    redcc_int executed; /* number of iterations handed out so far */
    redcc_int end;      /* the first iteration that leaves a fence; `trip` if none is found yet */
    struct survey *survey; /* NULL: none */
    redcc_int share_begin; /* the iterations that the thread classifies in the survey */
    redcc_int share_end;
    bool surveys;    /* the thread is classifying its share */
    bool asked;      /* the classes of iterations from worker->first on were requested and are not
                        evaluated yet */
    redcc_int taken; /* number of classified iterations that were already handed out or skipped */
    bool follows;    /* REDCC_OPERANDS_BY_LEADER for the runs that were handed out last */
    unsigned char class[REDCC_SELECTED];
    struct class_bits bits[REDCC_SELECTED_WORDS]; /* the classes, once they are evaluated */
};

/** Begins a selection; selection->window must be set. */
void redcc_selection_begin(struct selection *selection, redcc_worker *worker, redcc_int trip);

/** Assigns to the thread the iterations in [begin, end) that touch nothing. */
void redcc_selection_set_idle(struct selection *selection, redcc_int begin, redcc_int end);

/** Begins the survey with the share of thread number `thread`. Assigns to the thread those
 * iterations in its share that touch nothing, if `idle` is set. */
void redcc_selection_survey(struct selection *selection, redcc_worker *worker,
                            struct survey *survey, int thread, bool idle);

/** In a survey: keeps the requested classes, and requests those of the next iterations of the
 * share. At the end of the share, waits for the other threads, sets selection->end, and returns
 * false. */
bool redcc_selection_ask_survey(struct selection *selection, redcc_worker *worker, int thread);

/** Are there classified iterations that were not taken yet? */
static inline bool redcc_selection_has_classes(const struct selection *selection,
                                               const redcc_worker *worker) {
    return selection->asked || selection->taken < worker->last - worker->first;
}

/** Proceeds to the next iterations. Requests their classes (sets selection->asked), unless a survey
 * has found them. Returns false if none is left. */
bool redcc_selection_ask(struct selection *selection, redcc_worker *worker);

/** Writes runs of classified iterations into `to`[REDCC_SELECTED]; their `begin` is relative to
 * worker->first. All of them have the same class bit `follows`, which is stored in
 * selection->follows. If `hooked` is set, they are owner-checked. Returns the number of runs (0:
 * none is left) and sets *iterations to the number of their iterations. */
size_t redcc_selection_take(struct selection *selection, const redcc_worker *worker, bool hooked,
                            redcc_iterations *to, redcc_int *iterations);

#endif
