/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The state of a loop over all its executions, of one execution, and of one thread in an execution.
 *
 * One thread at a time holds the loop (`busy`). It fills the execution in redcc_enter. In the
 * parallel region each thread has its own state. Shared state is written by the last thread to
 * arrive at the end of a stage (pipeline.h) or, in bins, by the first thread, while the others
 * wait.
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
    struct within within; /* belongs to the thread that entered the loop */
    struct advice advice; /* auto's decision at entry */
    struct reuse reuse;
    struct inspection inspection;
    bool inspected;              /* an inspection began, and its memory must be freed */
    const struct method *method; /* the method that the inspection selected */
    struct run run;
    bool binned;        /* the execution used bins, at least for the first rounds */
    enum stage stage;   /* the next stage of all threads; set at a barrier */
    enum reason reason; /* why there is no plan, or why the last iterations of a binned loop were
                           executed sequentially */
    /* time in seconds at which the thread with the highest number arrived; 0: not yet */
    double woken;
    struct barrier barrier;
};

/** Does the loop keep the owners of this execution for the next one, instead of a plan? */
static inline bool redcc_keeps_owners(const struct execution *execution) {
    const struct call *call = &execution->call;
    return call->method ? call->method->selects && redcc_may_be_fenced(call->request.loop)
                        : redcc_goes_directly(&execution->advice);
}

/** One thread's part in an execution: one structure for each stage. */
struct thread_state {
    /* stage run; first, because redcc_next converts a pointer to it */
    alignas(64) struct runner runner;
    struct execution *execution;
    int thread;
    int threads;
    enum stage stage;
    bool telling; /* iterations were handed out in this stage, and their addresses are to be
                     recorded */
    int node;     /* the NUMA node (base/node.h) on which the thread ran last; -1: unknown */
    bool moved;   /* `node` differs from the node in the previous execution */
    struct inspector inspector; /* stages sample, sweep, log and partition */
    struct hasher hasher;       /* stages verify, sweep and plan */
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

/** Acquires a state for a call: the loop's own state or, if another thread holds that and `always`
 * is set, a temporary one. It does not wait for the other thread, which may be waiting for this
 * thread. If there is no state, returns NULL and sets *reason. */
struct loop_state *redcc_loop_acquire(struct loop_state *state, redcc_loop *loop, bool always,
                                      enum reason *reason);

/** Releases a state that redcc_loop_acquire returned. */
void redcc_loop_release(struct loop_state *state);

/** For tests: creates the loop's state, as a long execution would (unmade.h). */
void redcc_loop_make(redcc_loop *loop);

/** For tests: frees everything of a loop, including its state, as if it had never been executed. */
void redcc_loop_forget(redcc_loop *loop);

/** Ensures that there are states of at least `count` threads. False: out of memory. */
bool redcc_threads_ensure(struct loop_state *state, const redcc_loop *loop, int count);

/** Frees all threads' states. */
void redcc_threads_end(struct loop_state *state);

/** As redcc_enter. For a loop with REDCC_SECTIONED, sections[array_count] has the sections of the
 * attempt; otherwise it is NULL. */
int redcc_enter_sectioned(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                          const redcc_extent *known, const redcc_word *key,
                          const redcc_extent *sections, int threads, int nested);

/** Called at the end of an execution: adds it to the report, and informs auto of it. Returns
 * whether the loop is done; if not, the original loop must run. */
bool redcc_account(struct execution *execution);

/** Counts updates of rows that a slice did not name, which are validation failures. */
void redcc_note_misnamed(redcc_loop *loop, long count);

/** Informs auto of a call's result. `reason` says why the loop did not run in parallel, or is
 * REASON_NONE. */
void redcc_inform_auto(struct loop_state *state, const redcc_loop *loop,
                       const struct outcome *outcome, enum reason reason);

/** Called under validation before bytes of an array are written: saves these bytes. It is the
 * function `tell` of struct written_witness (bins/binning.h). */
void redcc_hold_written(void *execution, uint32_t array, struct range written);

/** Counts a call that ran sequentially because there was no memory for what redcc_run allocates
 * before redcc_enter. */
void redcc_note_no_memory(redcc_loop *loop);

/** Counts that a call falls back to the original loop. */
void redcc_count_fallback(struct loop_state *state, enum reason reason);

/** Stores the rule (row of auto's decision table) for the report; thread-safe. */
void redcc_note_rule(struct statistics *statistics, enum rule rule);

/** Counts a plan that a changed subscript has made invalid, if that has happened since the last
 * call of this function. */
void redcc_count_lost(struct execution *execution);

/** Records a timed execution of the original loop; one thread at a time. */
void redcc_note_sequential(struct statistics *statistics, redcc_int iterations, double seconds);

/** Records the time of the loop's first execution, in which all iterations were executed in order.
 * `known` is that of redcc_enter. */
void redcc_note_done(redcc_loop *loop, redcc_int trip, const redcc_extent *known, double seconds);

/** Records the time of the first `done` iterations of the loop's first execution, which were
 * executed in order; `rest` iterations are left. */
void redcc_note_begun(redcc_loop *loop, redcc_int rest, redcc_int done, double seconds);

/** Records that the last call was sequential. */
void redcc_note_serial(struct statistics *statistics);

#endif
