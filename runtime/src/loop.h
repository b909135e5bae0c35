/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The state of a loop over its executions, of one execution, and of one thread in it.
 *
 * The thread that holds the loop (busy) fills the execution in redcc_enter. In the region each
 * thread has its state. Shared state is written by the last thread to arrive at the end of a stage
 * (pipeline.h) or, in bins, by the first thread, while the others wait.
 */
#ifndef REDCC_LOOP_H
#define REDCC_LOOP_H

#include "base/within.h"
#include "bins/binning.h"
#include "choose/advice.h"
#include "choose/sections.h"
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
    struct advice advice; /* auto's decision at entry */
    struct reuse reuse;
    struct inspection inspection;
    bool inspected;              /* an inspection began, and its memory must be freed */
    const struct method *method; /* the method that the inspection selected */
    struct run run;
    bool binned;        /* the execution was binned, entirely or in its first rounds */
    enum stage stage;   /* the next stage of all threads, after a barrier */
    enum reason reason; /* why there is no plan, or why a binned loop's rest is sequential */
    double woken;       /* s, arrival of the thread with the highest number; 0: not yet */
    struct barrier barrier;
};

/** Are the execution's owners kept for the next one, and not a plan? */
static inline bool redcc_keeps_owners(const struct execution *execution) {
    const struct call *call = &execution->call;
    return call->method ? call->method->selects && call->request.loop->flags & REDCC_FENCED
                        : redcc_goes_directly(&execution->advice);
}

/** One thread's part: a sub-structure for each stage. */
struct thread_state {
    alignas(64) struct runner runner; /* run; first: redcc_next finds it directly */
    struct execution *execution;
    int thread;
    int threads;
    enum stage stage;
    bool telling;               /* iterations to record were handed out in this stage */
    int node;                   /* the thread's last NUMA node (base/node.h); -1: unknown */
    bool moved;                 /* this node differs from that in the previous execution */
    struct inspector inspector; /* sample, sweep, log, partition */
    struct hasher hasher;       /* verify, sweep, plan */
    struct binner *binner;      /* NULL unless the loop can be binned */
};

_Static_assert(offsetof(struct thread_state, runner) == 0, "execute/executor.c goes by it");

struct loop_state {
    struct reported reported;
    atomic_int busy;
    bool temporary; /* used for one execution while another thread holds the loop's own state; not
                       in the report */
    struct chooser chooser;
    struct variants variants;
    struct plan_cache cache;
    struct sections sections;
    struct execution execution;
    struct binning binning;
    struct thread_state **thread; /* [thread_count] */
    struct inspector **inspector; /* [thread_count] pointers to the threads' inspectors */
    struct hasher **hasher;       /* [thread_count] pointers to the threads' hashers */
    int thread_count;
};

/** The loop's state; the first call creates it. Thread-safe. NULL: out of memory. */
struct loop_state *redcc_state_of(redcc_loop *loop);

/** The loop's state, or NULL if it has none. */
struct loop_state *redcc_made_state_of(redcc_loop *loop);

/** Acquires a state for a call: the loop's own or, if another thread holds that and `always` is
 * set, a temporary one. Does not wait for the other thread, which may be waiting for this one.
 * NULL, with *reason: no state. */
struct loop_state *redcc_loop_acquire(struct loop_state *state, redcc_loop *loop, bool always,
                                      enum reason *reason);

/** Releases what redcc_loop_acquire returned. */
void redcc_loop_release(struct loop_state *state);

/** For tests: creates the loop's state, as after a long execution (unmade.h). */
void redcc_loop_make(redcc_loop *loop);

/** For tests: frees everything of a loop, including its state, as if it had never been executed. */
void redcc_loop_forget(redcc_loop *loop);

/** Ensures that there are at least `count` threads' states. False: no memory. */
bool redcc_threads_ensure(struct loop_state *state, const redcc_loop *loop, int count);

/** Frees all threads' states. */
void redcc_threads_end(struct loop_state *state);

/** As redcc_enter. sections [array_count]: the attempt's, for a loop with REDCC_SECTIONED;
 * otherwise NULL. */
int redcc_enter_sectioned(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                          const redcc_extent *known, const redcc_word *key,
                          const redcc_extent *sections, int threads, int nested);

/** Called at the end of an execution: adds it to the report, and informs auto. Returns whether the
 * loop is done. */
bool redcc_account(struct execution *execution);

/** Counts updates of rows that a slice did not name, which are validation failures. */
void redcc_note_misnamed(redcc_loop *loop, long count);

/** Informs auto of a call's result; reason: why there was no plan, or NONE. */
void redcc_inform_auto(struct loop_state *state, const redcc_loop *loop,
                       const struct outcome *outcome, enum reason reason);

/** A written_witness (bins/binning.h) whose `whom` is the execution: with validation, saves bytes
 *  before they are written. */
void redcc_hold_written(void *execution, uint32_t array, struct range written);

/** Counts a call of a loop that ran sequentially because memory was lacking before redcc_enter. */
void redcc_note_no_memory(redcc_loop *loop);

/** Counts that a call falls back to the original loop. */
void redcc_count_fallback(struct loop_state *state, enum reason reason);

/** Stores the row of auto's table for the report; thread-safe. */
void redcc_note_rule(struct statistics *statistics, enum rule rule);

/** Counts the plan that a changed subscript has invalidated since the last call of this function,
 * if any. */
void redcc_count_lost(struct execution *execution);

/** Records a timed execution of the original loop; one thread at a time. */
void redcc_note_sequential(struct statistics *statistics, redcc_int iterations, double seconds);

/** Records the time of the loop's first execution, if that was completely in order. known: as in
 *  redcc_enter. */
void redcc_note_done(redcc_loop *loop, redcc_int trip, const redcc_extent *known, double seconds);

/** Records the time of the first `done` iterations of the loop's first execution, in order; `rest`
 *  iterations are left. */
void redcc_note_begun(redcc_loop *loop, redcc_int rest, redcc_int done, double seconds);

/** Records that the last call was sequential. */
void redcc_note_serial(struct statistics *statistics);

#endif
