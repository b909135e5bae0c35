/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The form in which a loop is written, decided before anything of it is written.
 *
 * A verdict says that a loop may run in parallel; the plan says how: each decision with what it was
 * declined for. Why a decision is sound is said where it is made, in the header of that name.
 */
#ifndef PLAN_PLAN_H
#define PLAN_PLAN_H

#include <stdbool.h>

#include "analysis/base/facts.h"
#include "plan/lane_reason.h"
#include "plan/options.h"

/** What the runtime must know of a read: one or more of the facts' sources that move together. */
typedef struct logged_source {
    const loop_source *fact;                                   /* the first of them */
    bool is_subscript, is_scalar, meets_scalars, meets_arrays; /* any of them */
} logged_source;

enum { SOURCE_NOT_LOGGED = -1 };

/** Whether one thread logs all iterations in order before they are inspected (precheck.h). */
typedef enum dependence_precheck {
    PRECHECK_NONE,
    PRECHECK_OF_UPDATES, /* what must not be updated meanwhile is known before */
    PRECHECK_OF_ALL      /* or it is logged as the iterations read it */
} dependence_precheck;

/** What the runtime may do with the loop (execution.h). */
typedef struct execution_plan {
    bool keeps_plan;    /* its plan may be kept, by these: */
    unsigned key_count; /* words, the trip count among them */
    bool needs_order;   /* updates stay in the order of the loop, whatever the user allows */
    bool needs_every_iteration; /* also those that update nothing of a thread's */
    int64_t work;               /* operations of an iteration (work.h) */
} execution_plan;

/** base[subscript], two variables of the loop's function. */
typedef struct gather {
    const ir_variable *base, *subscript;
} gather;

/** What its executor prefetches (prefetch.h). */
typedef struct prefetch_plan {
    const char *declined; /* why it prefetches nothing, or NULL */
    unsigned ahead;       /* iterations; 0: nothing */
    bool is_light;        /* an iteration; then only where they come in no order */
    unsigned gather_count;
    const gather *gathers; /* rows to be prefetched that the inspector does not log */
} prefetch_plan;

typedef struct loop_plan {
    arena *arena;         /* that the plan lives in */
    const ir_unit *whole; /* with all that the file holds; */
    const ir_unit *unit;  /* without what its loops leave out in this compilation */
    const loop_facts *facts;
    const plan_options *options;
    reason obstacle; /* why the loop cannot be written in any form; message NULL: it can. What
                        follows `precheck` is not decided where it cannot */

    unsigned source_count;
    const logged_source *sources;
    const int *source_number;   /* of each of the facts' sources: index into sources */
    const bool *has_ready_base; /* of each of them: may its base be read before the loop? */
    const bool *is_shadowed;    /* of each array: a pointer of its name stands for it in the body */
    dependence_precheck precheck;
    execution_plan execution;
    prefetch_plan prefetch;
    const struct bins_plan *bins; /* the form for in-order binning (bins.h); NULL: there is none, */
    const char *no_bins;          /* because of this */
    lane_reason no_lanes;         /* as far as it is known before the body is written (lanes.h) */
    unsigned skip_count;
    const struct inner_skip *skips; /* of each inner loop (inner_iterations.h) */
} loop_plan;

/** Decides the form of a loop that a verdict allows to run in parallel. Lives in the arena, and
 * borrows units, facts and options. */
const loop_plan *plan_loop(arena *a, const ir_unit *whole, const ir_unit *unit,
                           const loop_facts *facts, const plan_options *options);

/** Records why the loop cannot be written, unless there is a reason already. */
void plan_obstacle(loop_plan *plan, ir_range range, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
