/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads the OpenMP directives of a loop in a file that is compiled with OpenMP, to decide whether
 *  the loop may be executed without them, in sequential order. */
#ifndef ANALYSIS_OPENMP_LOOP_H
#define ANALYSIS_OPENMP_LOOP_H

#include "analysis/base/openmp_directive.h"

/** Why directives must be kept. */
typedef struct openmp_kept {
    const char *text;   /* NULL if no reason has been found */
    const char *advice; /* what to change; NULL for the advice that all such reasons share */
} openmp_kept;

/** The directives that a loop's execution omits: `parallel for` or `for` above it, `atomic` and
 *  `critical` inside. */
typedef struct openmp_loop {
    unsigned item_count;
    const openmp_item *items;
    bool has_locks;    /* `atomic` or `critical` occurs in the loop, so other threads may update
                        * the same memory */
    bool has_critical; /* `critical` occurs in the loop, which protects reads as well */
    bool is_of_team;   /* the directive is `for`: the threads of an enclosing region share the
                        * loop */
    openmp_kept kept;  /* as far as the directives' text shows it */
} openmp_loop;

typedef struct blocked_scalar {
    const ir_variable *variable;
    const char *operator; /* the operator of the reduction clause */
} blocked_scalar;

/** Facts about the team of threads that executes an `omp for` (reduction/team_loop.h). */
typedef struct team_facts {
    bool shares_frame; /* the threads share the variables of the function's outermost block */
    bool may_be_early; /* a thread may reach the loop while others still execute an earlier one */
    bool names_all;    /* the region has a `default` clause other than shared, so clauses must name
                        * its variables */
    const char *reduced; /* a variable in the loop that the region reduces. Each thread has its
                          * own copy, with another value than before the region. NULL if there is
                          * none */
} team_facts;

/** The inner loop of two loops under `collapse`. Its bounds do not depend on the outer counter. */
typedef struct nested_blocks {
    ir_range header; /* range of `for ( ... )` */
    counted_loop counted;
    bool has_short_iterations;
} nested_blocks;

/** A loop whose OpenMP directive stays and reduces scalars; see reduction/fixed_blocks.h. */
typedef struct fixed_blocks {
    ir_range header; /* range of `for ( ... )` */
    const ir_variable *counter;
    unsigned scalar_count;
    const blocked_scalar *scalars;
    openmp_directive directive;
    team_facts team;            /* for OPENMP_FOR */
    const nested_blocks *inner; /* an inner loop that is divided into blocks too if the outer one
                                 * is short; NULL if there is none */
    bool is_balanced;           /* the `schedule` clause, or its absence, suggests that all
                                 * iterations take the same time */
    const char *lock; /* "atomic" or "critical" if the loop contains one: updates protected by it
                       * happen in any order; NULL if there is none */
    const char *unordered; /* why the updates under `lock` are not made in sequential order; NULL
                            * if that is unknown */
} fixed_blocks;

/** The loop's OpenMP directives, above it and inside. NULL if it has none or OpenMP is disabled. */
const openmp_loop *openmp_of_loop(arena *a, const ir_unit *unit, const ir_node *loop);

/** The reason to keep all directives of a file that may contain code that devices also execute.
 *  Such code cannot use the runtime. */
openmp_kept openmp_kept_for_devices(const ir_unit *unit);

/** Does the variable have the same value after the loop as before it, because the directives
 *  `above` make it private to each thread? If so, a loop executed without them must restore the
 *  value. A loop's counter is private even without a clause. */
bool openmp_keeps_value(const ir_unit *unit, const openmp_loop *above, const ir_node *loop,
                        const ir_variable *variable);

/** Returns true if `schedule` determines which thread executes an iteration, and the node calls
 *  omp_get_thread_num. */
bool openmp_knows_thread(const openmp_directive *d, const ir_node *node);

/** The variable called `name` in the loop's scope; NULL if there is none. */
const ir_variable *openmp_variable(const ir_unit *unit, const ir_node *loop,
                                   const ir_function *function, const char *name);

#endif
