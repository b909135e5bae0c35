/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The state of a loop over its executions, of one execution, and of one thread in it.
 *
 * The thread that holds the loop (busy) fills the execution in redcc_enter; in the region each
 * thread has its state, and what they share is written only by whoever arrives last at the end of a
 * stage (pipeline.h), while the others wait.
 */
#ifndef REDCC_LOOP_H
#define REDCC_LOOP_H

#include "base/within.h"
#include "bins/binning.h"
#include "choose/advice.h"
#include "execute/run.h"
#include "inspect/inspection.h"
#include "pipeline.h"
#include "report.h"
#include "reuse/kept.h"

#include <stddef.h>

/** One execution. */
struct execution {
    struct loop_state *state;
    struct call call;
    struct within within; /* of the thread that entered */
    struct advice advice; /* auto's, at entry */
    struct reuse reuse;
    struct inspection inspection;
    bool inspected;              /* memory for the inspection is to be given back */
    const struct method *method; /* that the inspection arrives at */
    struct run run;
    bool binned;        /* it was, all or the first rounds of it */
    enum stage stage;   /* that all threads go on with, after they met */
    enum reason reason; /* why there is no plan */
    double woken;       /* when the last thread of the region came, in seconds; 0: none did */
    struct barrier barrier;
};

/** One thread's part: a sub-structure for each stage. */
struct thread_state {
    alignas(64) struct runner runner; /* run; first: redcc_next finds it without a detour */
    struct execution *execution;
    int thread;
    int threads;
    enum stage stage;
    bool telling;               /* the program was handed iterations to tell, in this stage */
    int node;                   /* where it ran last (base/node.h); -1: not known */
    bool moved;                 /* from another one, where it ran at the execution before */
    struct inspector inspector; /* sample, sweep, log, partition */
    struct hasher hasher;       /* verify, sweep, plan */
    struct binner *binner;      /* of a loop that can be binned; or NULL */
};

_Static_assert(offsetof(struct thread_state, runner) == 0, "execute/executor.c goes by it");

struct loop_state {
    struct reported reported;
    atomic_int busy;
    bool temporary; /* of one execution, beside the loop's own; not in the report */
    struct chooser chooser;
    struct manners manners;
    struct plan_cache cache;
    struct execution execution;
    struct binning binning;
    struct thread_state **thread; /* [thread_count] */
    struct inspector **inspector; /* [thread_count] theirs */
    struct hasher **hasher;       /* [thread_count] theirs */
    int thread_count;
};

/** The loop's state; of several threads that come first, one makes it. NULL: no memory. */
struct loop_state *redcc_state_of(redcc_loop *loop);

/** The loop's state, where it has one; else NULL. */
struct loop_state *redcc_made_state_of(redcc_loop *loop);

/** The state for a call: the loop's, which it holds from now on, or, where another thread holds
 * that and must not be waited for (it may be waiting for this one), with `always` one of its own.
 * NULL, with *reason: none. */
struct loop_state *redcc_loop_acquire(struct loop_state *state, redcc_loop *loop, bool always,
                                      enum reason *reason);

/** Ends what redcc_loop_acquire began. */
void redcc_loop_release(struct loop_state *state);

/** Sees to it that the loop has a state, as a long loop gets one (unmade.h); for tests. */
void redcc_loop_make(redcc_loop *loop);

/** Ends all that a loop has, its state included, as if it had never been executed; for tests. */
void redcc_loop_forget(redcc_loop *loop);

/** Makes sure that there are at least `count` threads' states. False: no memory. */
bool redcc_threads_ensure(struct loop_state *state, const redcc_loop *loop, int count);

/** Gives back all of them. */
void redcc_threads_end(struct loop_state *state);

/** An execution is over: counts it for the report, and tells auto. Returns whether the loop is
 *  done. */
bool redcc_account(struct execution *execution);

/** Counts updates of rows that a slice did not name: validation has failed. */
void redcc_note_misnamed(redcc_loop *loop, long count);

/** Tells auto what came of a call; reason: why there was no plan, or NONE. */
void redcc_tell_auto(struct loop_state *state, const redcc_loop *loop,
                     const struct outcome *outcome, enum reason reason);

/** A written_witness (bins/binning.h) whose `whom` is the execution: with validation, what the
 * bytes hold is kept. */
void redcc_hold_written(void *execution, uint32_t array, struct range written);

/** Counts a call of a loop that ran sequentially, for want of memory before redcc_enter. */
void redcc_note_no_memory(redcc_loop *loop);

/** Counts that a call falls back to the original loop. */
void redcc_count_fallback(struct loop_state *state, enum reason reason);

/** Notes the row of auto's table for the report; thread-safe. */
void redcc_note_rule(struct statistics *statistics, enum rule rule);

/** Counts the plan that was lost since this was called last, where one was. */
void redcc_count_lost(struct execution *execution);

/** Notes how the last call was executed; thread-safe. */
void redcc_note_mode(struct statistics *statistics, enum mode mode);

/** Notes an execution of the original loop that was timed; one thread at a time. */
void redcc_note_sequential(struct statistics *statistics, redcc_int iterations, double seconds);

/** Notes that the last call was the sequential loop's. */
void redcc_note_serial(struct statistics *statistics);

#endif
