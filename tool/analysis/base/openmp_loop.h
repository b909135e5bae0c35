/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The OpenMP directives of a loop in a file that is compiled with OpenMP: may the loop be executed
 *  without them, in sequential order? */
#ifndef ANALYSIS_OPENMP_LOOP_H
#define ANALYSIS_OPENMP_LOOP_H

#include "analysis/base/openmp_directive.h"

/** The directives of a loop that is to be executed without them: `parallel for` above it, `atomic`
 *  and `critical` inside. */
typedef struct openmp_loop {
    unsigned item_count;
    const openmp_item *items;
    bool has_locks;   /* `atomic` or `critical` in the loop: other threads may update as well */
    bool is_of_team;  /* `for`, by the team of a region around it */
    const char *kept; /* the reason why they must be kept, from their text; NULL: none so far */
} openmp_loop;

typedef struct blocked_scalar {
    const ir_variable *variable;
    const char *operator; /* the clause's operator */
} blocked_scalar;

/** Facts about the team that executes `omp for` (reduction/team_loop.h). */
typedef struct team_facts {
    bool shares_frame; /* its threads share the variables of the function's outermost block */
    bool may_be_early; /* threads may reach the loop while others still execute an earlier one */
    bool names_all; /* the region has a `default` other than shared: clauses name its variables */
    const char *reduced; /* a variable in the loop that the region reduces: it has a copy for each
                          * thread, with another value than before the region */
} team_facts;

/** The inner loop of a nest below `collapse`, whose bounds do not depend on the outer counter. */
typedef struct nested_blocks {
    ir_range header; /* `for ( ... )` */
    counted_loop counted;
    bool has_short_iterations;
} nested_blocks;

/** A loop whose directive reduces scalars, and stays: reduction/fixed_blocks.h. */
typedef struct fixed_blocks {
    ir_range header; /* `for ( ... )` */
    const ir_variable *counter;
    unsigned scalar_count;
    const blocked_scalar *scalars;
    openmp_directive directive;
    team_facts team;            /* of OPENMP_FOR */
    const nested_blocks *inner; /* blocks divide this loop, too, if the outer one is short; NULL:
                                 * there is none */
    bool is_balanced;           /* `schedule` suggests that all iterations take the same time */
    const char *lock; /* "atomic" or "critical", in the loop: the updates under it are made in any
                       * order; NULL: none */
    const char *unordered; /* why these are not made in sequential order; NULL: not known */
} fixed_blocks;

/** NULL: the loop has no OpenMP directives, above it or inside, or they are inactive. */
const openmp_loop *openmp_of_loop(arena *a, const ir_unit *unit, const ir_node *loop);

/** May the file have code that devices execute as well, which cannot use the runtime? */
bool openmp_has_devices(const ir_unit *unit);

/** Does the variable have the same value after the loop as before, because a `parallel for` above
 *  it, with these directives, makes it private to the threads? The loop executed without the
 *  directive must then restore it. The counter is private without a clause. */
bool openmp_keeps_value(const ir_unit *unit, const openmp_loop *above, const ir_node *loop,
                        const ir_variable *variable);

/** Does `schedule` fix which thread executes an iteration, and the node ask for its number? */
bool openmp_knows_thread(const openmp_directive *d, const ir_node *node);

/** The variable called `name` in the loop's scope, or NULL. */
const ir_variable *openmp_variable(const ir_unit *unit, const ir_node *loop,
                                   const ir_function *function, const char *name);

#endif
