/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One execution of a loop, and one thread's part in it. */
#ifndef REDCC_RUN_H
#define REDCC_RUN_H

#include "base/call.h"
#include "execute/hook.h"
#include "execute/lanes.h"
#include "execute/parts.h"
#include "execute/prefetch.h"
#include "execute/select.h"
#include "execute/tiles.h"
#include "execute/validate.h"
#include "execute/variant.h"
#include "ownership/fences.h"
#include "plan/plan.h"

enum { REDCC_RUNS = 128 };

/** The variants between which an execution chooses, and the results of earlier executions. */
struct variant_choice {
    const struct variants *known;
    bool is_open;  /* trials decide whether to use prefetches */
    bool is_asked; /* REDCC_PREFETCH requests prefetches */
    int lanes;     /* number of iterations executed at once; 0: one by one */
    enum lanes_reason why;
};

/** State of an execution that all threads share. */
struct run {
    const struct call *call;
    struct plan *plan; /* NULL: there is no plan (yet) */
    struct variant_choice variant;
    struct barrier *barrier;
    struct validated *validated; /* NULL: the loop is not validated */
    struct validation validation;
    /* with a method that classifies iterations: */
    struct fences fences;
    struct survey survey;
    atomic_ullong error; /* the loop's errno: executor.c */
    atomic_int last_claimed;
    atomic_uint
        blocks_claimed; /* number of stealable blocks, or bands of tiles, that threads have taken */
    /* Times in seconds: */
    double ready;    /* when the plan was ready */
    double executed; /* with validation: when the execution had ended; otherwise 0 */
};

/** What a thread's redcc_next hands out. */
enum step {
    STEP_BEGIN,
    STEP_EXECUTE, /* the chunks of the plan */
    STEP_REST,    /* the remaining iterations of a binned loop, in order */
    STEP_CHECK,   /* validation: iterations that are repeated in order */
    STEP_END
};

/** One thread's part in an execution. */
struct runner {
    struct run *run;
    const struct plan *plan; /* the plan that is executed */
    int thread;
    int threads;
    struct float_control float_control; /* the thread's own state, stored while the thread uses that
                                           of the thread that entered the loop */
    enum step step;
    uint32_t schedule; /* index of the schedule that is being executed */
    uint32_t stage;    /* the current stage of the plan */
    struct hooks hooks;
    struct run_reader runs;             /* the remaining runs of the current chunk */
    redcc_iterations piece[REDCC_RUNS]; /* the runs that were handed out, if they were packed, had
                                           to be marked for owner checks, or had to be split */
    struct parts parts;                 /* the timing slices of a trial */
    redcc_iterations whole; /* the iterations that were handed out in order, without a plan */
    redcc_int in_order_end; /* one past the last iteration to hand out in order */
    struct selection selection;
    struct tile_walk tiles;
    void **base;        /* [array_count] the bases to which the thread writes */
    redcc_owner *owner; /* [array_count] the elements that the thread owns */
};

/** Initialises the run before the threads begin. */
void redcc_run_begin(struct run *run);

/** Chooses the variants of this execution, from run->call. `known` must outlive the run. */
void redcc_run_choose_variant(struct run *run, const struct variants *known);

/** The number of timing slices of an execution by this plan; 0 if variants are not compared. */
unsigned redcc_run_parts(const struct run *run, const struct plan *plan);

/** The variant that is used in timing slice number `part`. Without a trial, slice 0 is the whole
 * execution. */
redcc_variant redcc_run_variant(const struct run *run, const struct plan *plan, unsigned part);

/** Called after the execution: records the seconds and the iterations of each slice, each summed
 * over the threads. */
void redcc_run_note_variant(const struct run *run, struct variants *known, const double *seconds,
                            const double *iterations);

/** Makes the thread's redcc_next hand out the iterations from `from` on, in order, with the arrays'
 * own bases. If `from` is the trip count, it hands out none. */
void redcc_run_rest(redcc_worker *worker, redcc_int from);

/** As redcc_run_rest, for the iterations from `begin` to before `end`. */
void redcc_run_stretch(redcc_worker *worker, redcc_int begin, redcc_int end);

/** For validation: makes the first thread's redcc_next hand out the iterations before `end` again.
 * All threads must have finished them, and the arrays' saved contents must have been restored.
 * After that the results are compared, and redcc_next hands out the rest of the loop. */
void redcc_run_check(redcc_worker *worker, redcc_int end);

/** Has an iteration left a fence, so that it and the later iterations are not executed yet? */
bool redcc_run_has_rest(const redcc_worker *worker);

/** Called after the loop: prepares the thread to execute all iterations again, in order, without
 * owning any element. If some are not executed yet, excludes these. */
void redcc_run_own_nothing(redcc_worker *worker);

/** Hands out some of the iterations that redcc_run_own_nothing prepared, and then those that were
 * not executed yet, which make their updates. Returns false if none is left. */
bool redcc_run_again(redcc_worker *worker);

/** Called if errno is not 0 after iterations of which the last has number `end` - 1. Records errno
 * for redcc_error_of, and clears it. */
void redcc_note_error(struct run *run, redcc_int end);

/** The value that the loop's mathematical functions have given errno; 0: none. */
int redcc_error_of(struct run *run);

#endif
