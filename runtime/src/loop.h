/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The state of a loop over its executions, of one execution, and of one thread in it.
 *
 * The thread that holds the loop (busy) fills the execution in redcc_enter; in the region each
 * thread has its member, and what they share is written only by whoever arrives last at the
 * barrier (redcc_meet), while the others wait.
 */
#ifndef REDCC_LOOP_H
#define REDCC_LOOP_H

#include "choose.h"
#include "float_control.h"
#include "graph/divide.h"
#include "graph/levels.h"
#include "hook.h"
#include "plan.h"
#include "report.h"
#include "sample.h"
#include "sweep.h"
#include "validate.h"

enum { REDCC_PLANS = 4, REDCC_ENTRIES = 1024, REDCC_RUNS = 128 };

/** Where a thread stands, and what the last to arrive at the barrier sends all threads to. */
enum phase {
    PHASE_RECOUNT,  /* fewer threads came than asked for: look for a plan again */
    PHASE_BEGIN,    /* is there a plan that fits? */
    PHASE_SAMPLE,   /* tell some iterations' addresses */
    PHASE_SAMPLED,  /* ... done */
    PHASE_SWEEP,    /* tell all iterations' addresses */
    PHASE_SWEEPING, /* ... a block of them is told */
    PHASE_GATHER,   /* tell them once more, to be kept: for ownership by the access graph */
    PHASE_GATHERING,
    PHASE_DIVIDE,  /* the units among the owners */
    PHASE_JOIN,    /* ... without spare ones after all */
    PHASE_PREPARE, /* make a plan of it */
    PHASE_RUN,     /* begin to execute */
    PHASE_RUNNING,
    PHASE_CHECKING, /* executed once more, sequentially, to be compared */
    PHASE_OVER      /* done, or not to be done in parallel */
};

/** A fingerprint of a thread's share of a source, as far as it is taken. */
struct taking {
    struct reading reading; /* of which it is; empty: of none yet */
    size_t taken;           /* bytes */
    struct fingerprint so_far;
};

/** One thread's part. What only it writes; others look after the barrier. */
struct member {
    alignas(64) struct execution *execution;
    int thread;
    int threads;
    enum phase phase;
    struct float_control
        float_control;       /* the thread's own, while it has that of the loop's caller */
    const struct plan *plan; /* to execute */
    int node;                /* where it ran last (node.h); -1: not known */
    bool moved;              /* from another one, where it ran at the execution before */
    bool failed;             /* no memory */
    bool told_all;           /* the inspector told as many iterations as asked for */
    redcc_int next;          /* iterations handed out for inspection up to here */
    redcc_int handed;        /* in the block being inspected */
    redcc_int block;         /* that many at most */
    uint32_t schedule;       /* the plan's that it executes */
    double began, ended;     /* seconds; paced */
    uint32_t stage;          /* of execution */
    redcc_run solo_run;      /* COURSE_SOLO, and the comparison with the sequential loop */
    struct hooks hooks;
    struct run_reader runs;    /* of the chunk at hand, still to be handed out */
    redcc_run run[REDCC_RUNS]; /* handed out, of runs that are packed or to be guarded */
    redcc_entry *entries;      /* [REDCC_ENTRIES] */
    struct range *seen;        /* [array_count] */
    redcc_int *executed;       /* [owners] iterations of the own share, by owner */
    struct sample sample;
    struct sweep sweep;
    redcc_extent *sources;           /* [source_count] told by redcc_read */
    void **base;                     /* [array_count] */
    redcc_owner *owner;              /* [array_count] */
    struct fingerprint *fingerprint; /* [source_count] of the own share */
    struct taking *taking;           /* [source_count] while all iterations are told */
};

/** One execution. */
struct execution {
    struct loop_state *state;
    struct request request;
    const struct method *method; /* asked for; NULL: auto */
    int parameter;
    redcc_order order;
    enum course course;
    enum pace pace;
    long rested; /* how many calls auto left to the sequential loop before it tried again */
    struct float_control float_control; /* of the thread that entered */
    uint64_t signals;                   /* what it blocked before; where they are held */
    bool holds_signals;
    bool is_within; /* the thread that entered was within another execution */
    bool insists;   /* one thread executes by the plan as well */
    int asked;      /* threads */
    int threads;    /* that came */
    struct barrier barrier;
    enum phase next; /* where the last to arrive sends all */
    bool verified;   /* so far the candidate's subscripts are unchanged */
    struct plan *candidate;
    struct plan *plan;     /* NULL: not (yet) to be executed in parallel */
    bool plan_is_kept;     /* by the state */
    bool inspected;        /* memory for inspection is to be given back */
    enum reason reason;    /* why there is no plan */
    uint32_t clash_source; /* REASON_OVERLAP: which overlap */
    uint32_t clash_array;
    struct partition partition;
    const struct method *chosen; /* of this inspection */
    struct divide divide;
    struct levels levels;
    bool divided;    /* it is done, and the plan's owners are to be those */
    bool by_graph;   /* auto: by a plan of that kind */
    bool only_timed; /* planless: by it auto learns what the loop takes by one thread */
    bool for_copies; /* auto: by the sample it will be copies; the partition is in one piece */
    bool no_copies;  /* ... but by all iterations they cannot be had */
    double touches;  /* of an iteration, about */
    bool planless;   /* COURSE_SOLO, and there is no plan */
    struct range *touched; /* [array_count] by all threads */
    struct range *sources; /* [source_count] where they lie */
    const struct sample **samples;
    const struct summary **summaries;
    const struct range **seen;
    int error_before;    /* errno of the thread that entered */
    atomic_ullong error; /* what the loop leaves in errno: execute.c */
    atomic_int last_claimed;
    atomic_uint spares_claimed;
    struct validation validation;
    double entered;
    double ready;    /* seconds at which the plan was there */
    double executed; /* with validation: at which the loop was done */
    double solo_seconds;
    double part_seconds; /* paced: of the first thread's first spare part */
};

/** execute.c: what mathematical functions called in the loop left in errno; 0: nothing. */
int redcc_error_of(struct execution *execution);

/** Is the execution, by this plan, one that begins as its pace says? */
static inline bool redcc_is_paced(const struct execution *execution, const struct plan *plan) {
    return execution->pace != PACE_UNTIMED && plan && plan->method->spares;
}

struct loop_state {
    struct reported reported;
    atomic_int busy;
    bool passing; /* of one execution, beside the loop's own; not in the report */
    struct chooser chooser;
    struct plan *plans[REDCC_PLANS];
    uint64_t plan_clock;
    unsigned setbacks; /* how often in turn subscripts were watched in vain (vouch.c) */
    struct execution execution;
    struct member **member; /* [member_count] */
    int member_count;
};

/** Ends all that a loop has, its state included, as if it had never been executed; for tests. */
void redcc_loop_forget(redcc_loop *loop);

/** Makes sure that there are at least `count` members. False: no memory. */
bool redcc_members_ensure(struct loop_state *state, const redcc_loop *loop, int count);

/** Gives back all of them. */
void redcc_members_end(struct loop_state *state);

/** Gives back what the members and the execution hold for inspection. */
void redcc_inspection_end(struct execution *execution);

/** Every thread calls it: when all have come, the last does `alone`, which sets execution->next,
 * and all go on at that phase. */
void redcc_meet(struct member *member, void (*alone)(struct execution *));

/** Looks for a plan that may fit the request with that many threads, and which of its subscripts
 * the system vouches for. */
void redcc_find_candidate(struct execution *execution, int threads);

/** Are the candidate's subscripts what they were? Every thread calls it and gets the same answer.
 */
bool redcc_verify(struct member *member);

/** Counts a call of a loop that ran sequentially, for want of memory before redcc_enter. */
void redcc_note_no_memory(redcc_loop *loop);

/** Is a source so small that every thread reads it, rather than its share? That is dearer by less
 *  than the barrier that is saved. */
bool redcc_is_small(struct reading reading);

/** Of the thread's share of what is read. */
struct fingerprint redcc_share_fingerprint(const struct member *member, struct reading reading);

/** To be called before the member's iterations are told. Returns the bytes of its share that will
 * be taken meanwhile, of sources whose place is known (execution->sources). */
size_t redcc_begin_taking(struct member *member);

/** So much of its iterations, 0 to 1, the member has told: takes as much of these fingerprints. */
void redcc_take_some(struct member *member, double part);

/** Takes what is left of the fingerprints of the own share of all subscripts, into
 *  member->fingerprint; of all that are not of what is read now. */
void redcc_take_fingerprints(struct member *member);

/** Joins them into the records of the execution's plan. */
void redcc_record_fingerprints(const struct execution *execution);

/** Gives back the candidate, where there is one: its subscripts have changed. */
void redcc_drop_candidate(struct execution *execution);

/** Keeps the execution's plan for later calls, in the place of the one used longest ago. */
void redcc_keep_plan(struct execution *execution);

/** Gives back all plans that are kept, so that there is memory for another. */
void redcc_drop_plans(struct loop_state *state);

/** Gives back those that are not made from the access graph. */
void redcc_drop_plain_plans(struct loop_state *state);

#endif
