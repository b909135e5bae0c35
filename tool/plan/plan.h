/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The form in which a loop is written, decided before anything is written.
 *
 * A verdict says that a loop may run in parallel; the plan says how. It contains each decision,
 * with the reason if a form is declined. The header of each decision explains why it is sound.
 */
#ifndef PLAN_PLAN_H
#define PLAN_PLAN_H

#include <stdbool.h>

#include "analysis/base/facts.h"
#include "plan/lane_reason.h"
#include "plan/options.h"

/** A read that the runtime must know: one or more of facts->sources that have the same base or
 * range (plan_sources). */
typedef struct logged_source {
    const loop_source *fact;                                   /* the first of these sources */
    bool is_subscript, is_scalar, meets_scalars, meets_arrays; /* each is true if it holds for at
                                                                * least one of the sources */
} logged_source;

enum { SOURCE_NOT_LOGGED = -1 };

/** Does one thread log all iterations in order before they are inspected (precheck.h)? */
typedef enum dependence_precheck {
    PRECHECK_NONE,
    PRECHECK_OF_UPDATES, /* updates are checked: the ranges read are known before the loop */
    PRECHECK_OF_ALL      /* reads are logged and checked as well */
} dependence_precheck;

/** The section of an array that an OpenMP clause names: its lower bound and its length, counted in
 *  elements of the array or in targets of the pointer. Both are texts of expressions of variables
 *  and numbers. */
typedef struct array_section {
    const char *lower, *length;
} array_section;

/** What the runtime may do with the loop (execution.h). */
typedef struct execution_plan {
    bool keeps_plan;            /* the runtime may keep one plan per key */
    unsigned key_count;         /* words of the key, including the trip count */
    bool needs_order;           /* updates keep the order of the loop, whatever the user permits */
    bool needs_every_iteration; /* an iteration may not be skipped, even if it updates nothing */
    bool needs_whole; /* the guard must compare all accesses before any update: an update may
                       * change a value that the executor reads before the loop or stores only
                       * after it */
    bool may_begin;   /* the first iterations may be executed in order before the inspection, and
                       * the remaining ones as a separate loop */
    bool may_end_in_order; /* the first iterations may be executed by owners, and the remaining ones
                              in order (REDCC_FENCED, REDCC_FENCED_SERIES) */
    bool may_continue;     /* the original loop can continue at an iteration that leaves it, after
                              the preceding ones were executed (continuation.h) */
    bool is_over_blocks;   /* inspection is short, even if iterations are long */
    int64_t work;          /* operations of an iteration (work.h) */
    const array_section *sections; /* by array (sections.h), or NULL if the loop has none */
    bool is_unordered;    /* updates may be made in a fixed order, on private copies (sections.h) */
    const char *in_order; /* if `atomic` or `critical` protect the updates, but they keep the order
                           * of the loop: the reason. Else NULL */
    result_order order;   /* the order that the results keep */
} execution_plan;

/** An indexed load base[subscript]; both are variables of the loop's function. */
typedef struct gather {
    const ir_variable *base, *subscript;
} gather;

/** What the loop's executor prefetches (prefetch.h). */
typedef struct prefetch_plan {
    const char *declined; /* the reason why it prefetches nothing, or NULL */
    unsigned ahead;       /* the distance in iterations; 0: it prefetches nothing */
    bool is_light;        /* light iterations: prefetches only if their accesses are irregular */
    unsigned gather_count;
    const gather *gathers; /* rows that are prefetched although the inspector does not log them */
} prefetch_plan;

typedef struct loop_plan {
    arena *arena;         /* owns the plan */
    const ir_unit *whole; /* all code of the file */
    const ir_unit *unit;  /* the file without branches that this compilation never takes */
    const loop_facts *facts;
    const plan_options *options;
    reason obstacle; /* why the loop cannot be written in any form; the message is NULL if it can.
                      * With an obstacle, is_shadowed and the fields after `precheck` may be unset.
                      * The id is REASON_INDEX_EXPENSIVE if only in-order binning could execute the
                      * loop, otherwise REASON_NONE */

    unsigned source_count;
    const logged_source *sources;
    const int *source_number;   /* per facts->sources[i]: index in sources, or SOURCE_NOT_LOGGED */
    const bool *has_ready_base; /* per facts->sources[i]: may its base be read before the loop? */
    const bool *is_shadowed;    /* for each array: does a pointer of the same name replace it in the
                                 * body? */
    dependence_precheck precheck;
    execution_plan execution;
    prefetch_plan prefetch;
    const struct bins_plan *bins; /* the form for in-order binning (bins.h), or NULL */
    const char *no_bins;          /* the reason why there are no bins */
    lane_reason no_lanes;         /* as far as known before the body is written (lanes.h) */
    unsigned skip_count;
    const struct inner_skip *skips; /* for each inner loop (inner_iterations.h) */
    const struct tile_plan *tiles;  /* decisions about tiles of a loop over pairs (tiles.h) */
} loop_plan;

/** Decides the form of a loop that a verdict allows to run in parallel. Allocated in the arena;
 *  borrows units, facts and options. */
const loop_plan *plan_loop(arena *a, const ir_unit *whole, const ir_unit *unit,
                           const loop_facts *facts, const plan_options *options);

/** Records the reason why the loop cannot be written, unless there is one already. */
void plan_obstacle(loop_plan *plan, ir_range range, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
