/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One execution of a loop, and one thread's part in it. */
#ifndef REDCC_RUN_H
#define REDCC_RUN_H

#include "base/call.h"
#include "execute/hook.h"
#include "execute/lanes.h"
#include "execute/manner.h"
#include "execute/parts.h"
#include "execute/prefetch.h"
#include "execute/select.h"
#include "execute/validate.h"
#include "plan/plan.h"

enum { REDCC_RUNS = 128 };

/** What manners an execution may have, and what is known of them. */
struct manner_choice {
    const struct manners *known;
    bool is_open;  /* whether to prefetch is to be found out */
    bool is_asked; /* prefetches are asked for */
    int lanes;     /* iterations at once; 0: one by one, */
    enum lanes_reason why;
};

/** What all threads share. */
struct run {
    const struct call *call;
    struct plan *plan; /* NULL: none (yet) */
    struct manner_choice manner;
    struct barrier *barrier;
    struct validated *validated; /* NULL: nothing is to be validated */
    struct validation validation;
    atomic_ullong error; /* what the loop leaves in errno: executor.c */
    atomic_int last_claimed;
    atomic_uint blocks_claimed; /* stealable ones */
    /* Seconds. */
    double ready;    /* when the plan was there */
    double executed; /* with validation: when the loop was done; 0: it is not checked */
};

/** Where a thread stands. */
enum step {
    STEP_BEGIN,
    STEP_EXECUTE, /* chunk by chunk */
    STEP_REST,    /* of a binned loop: what is left, in order */
    STEP_CHECK,   /* validation: once more, in order */
    STEP_END
};

/** One thread's part. */
struct runner {
    struct run *run;
    const struct plan *plan; /* to execute */
    int thread;
    int threads;
    struct float_control float_control; /* the thread's own, while it has the caller's */
    enum step step;
    uint32_t schedule; /* the plan's that it executes */
    uint32_t stage;    /* of execution */
    struct hooks hooks;
    struct run_reader runs; /* of the chunk at hand, still to be handed out */
    redcc_iterations
        piece[REDCC_RUNS];  /* handed out, of runs that are packed, to be guarded or cut */
    struct parts parts;     /* of a trial of manners */
    redcc_iterations whole; /* handed out, in order, without a plan, */
    redcc_int in_order_end; /* up to here */
    struct selection selection;
    void **base;        /* [array_count] where it writes */
    redcc_owner *owner; /* [array_count] what it owns */
};

/** Before the threads begin. */
void redcc_run_begin(struct run *run);

/** What manners the execution that begins may have, by run->call. `known` must last as long. */
void redcc_run_choose_manner(struct run *run, const struct manners *known);

/** Into how many parts an execution with the plan is cut; 0: it is no trial of manners. */
unsigned redcc_run_parts(const struct run *run, const struct plan *plan);

/** The manner of such a part, by its number; without a trial of number 0, which is all of it. */
redcc_manner redcc_run_manner(const struct run *run, const struct plan *plan, unsigned part);

/** The execution is over: what its threads took for each part, the seconds and the iterations of
 * all added up. */
void redcc_run_note_manner(const struct run *run, struct manners *known, const double *seconds,
                           const double *iterations);

/** Has the thread's redcc_next hand out what is left of the loop from iteration `from` on, in order
 *  and in place; from == trip: nothing. */
void redcc_run_rest(redcc_worker *worker, redcc_int from);

/** The same of iterations begin to before end. */
void redcc_run_stretch(redcc_worker *worker, redcc_int begin, redcc_int end);

/** Validation: has the first thread's redcc_next hand out the iterations before `end` once more,
 * from what the arrays held before; then the two are compared, and what is left of the loop
 * follows. All threads are done with these iterations. */
void redcc_run_check(redcc_worker *worker, redcc_int end);

/** The loop is done: the thread goes through all iterations once more, in order, owning nothing. */
void redcc_run_own_nothing(redcc_worker *worker);

/** Hands out some of them; false: there are none left. */
bool redcc_run_again(redcc_worker *worker);

/** errno is not 0 after iterations that end before `end`: notes it for redcc_error_of, and clears
 *  it. */
void redcc_note_error(struct run *run, redcc_int end);

/** What mathematical functions called in the loop left in errno; 0: nothing. */
int redcc_error_of(struct run *run);

#endif
