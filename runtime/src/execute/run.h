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

/** The variants from which an execution chooses, and their results so far. */
struct variant_choice {
    const struct variants *known;
    bool is_open;  /* trials decide between prefetches and none */
    bool is_asked; /* prefetches are requested */
    int lanes;     /* iterations at once; 0: one by one */
    enum lanes_reason why;
};

/** State shared by all threads. */
struct run {
    const struct call *call;
    struct plan *plan; /* NULL: none (yet) */
    struct variant_choice variant;
    struct barrier *barrier;
    struct validated *validated; /* NULL: no validation */
    struct validation validation;
    struct fences fences; /* with a method that classifies iterations */
    atomic_ullong error;  /* the loop's errno: executor.c */
    atomic_int last_claimed;
    atomic_uint
        blocks_claimed; /* number of stealable blocks, or bands of tiles, taken by threads */
    /* Seconds. */
    double ready;    /* when the plan was ready */
    double executed; /* with validation: when the loop was done; 0: the loop is not validated */
};

/** The state of a thread's execution. */
enum step {
    STEP_BEGIN,
    STEP_EXECUTE, /* executes chunk by chunk */
    STEP_REST,    /* a binned loop's remaining iterations, in order */
    STEP_CHECK,   /* validation: repeats iterations in order */
    STEP_END
};

/** One thread's part. */
struct runner {
    struct run *run;
    const struct plan *plan; /* the plan that is executed */
    int thread;
    int threads;
    struct float_control float_control; /* the thread's own state, while it uses the caller's */
    enum step step;
    uint32_t schedule; /* the plan's schedule being executed */
    uint32_t stage;    /* the current stage of execution */
    struct hooks hooks;
    struct run_reader runs;             /* the current chunk's remaining runs */
    redcc_iterations piece[REDCC_RUNS]; /* the runs handed out, if they had to be unpacked, marked
                                         * for owner checks, or cut */
    struct parts parts;                 /* timing slices of a trial */
    redcc_iterations whole;             /* iterations handed out in order, without a plan */
    redcc_int in_order_end;             /* one past the last iteration to hand out in order */
    struct selection selection;
    struct tile_walk tiles;
    void **base;        /* [array_count] bases to which it writes */
    redcc_owner *owner; /* [array_count] the elements that it owns */
};

/** Initialises the run before the threads begin. */
void redcc_run_begin(struct run *run);

/** Chooses the variants of this execution, from run->call. `known` must outlive the run. */
void redcc_run_choose_variant(struct run *run, const struct variants *known);

/** Number of timing slices of an execution with the plan; 0 if variants are not compared. */
unsigned redcc_run_parts(const struct run *run, const struct plan *plan);

/** The variant of a slice, by its number; without a trial, slice 0 is the whole execution. */
redcc_variant redcc_run_variant(const struct run *run, const struct plan *plan, unsigned part);

/** After the execution: records seconds and iterations of each slice, summed over the threads. */
void redcc_run_note_variant(const struct run *run, struct variants *known, const double *seconds,
                            const double *iterations);

/** Makes the thread's redcc_next hand out the iterations from `from` on, in order and in place;
 * from == trip: none. */
void redcc_run_rest(redcc_worker *worker, redcc_int from);

/** The same for iterations begin to before end. */
void redcc_run_stretch(redcc_worker *worker, redcc_int begin, redcc_int end);

/** Validation: makes the first thread's redcc_next hand out the iterations before `end` again, with
 * the arrays' saved contents restored. Then the two results are compared, and the rest of the loop
 *  follows. All threads must have finished these iterations. */
void redcc_run_check(redcc_worker *worker, redcc_int end);

/** After the loop: prepares the thread to execute all iterations again, in order, owning nothing.
 */
void redcc_run_own_nothing(redcc_worker *worker);

/** Hands out some of these iterations; false: none is left. */
bool redcc_run_again(redcc_worker *worker);

/** Called if errno is not 0 after iterations that end before `end`: records it for redcc_error_of,
 * and clears it. */
void redcc_note_error(struct run *run, redcc_int end);

/** The value to which the loop's mathematical functions have set errno; 0: none. */
int redcc_error_of(struct run *run);

#endif
