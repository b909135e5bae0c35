/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The OpenMP directives of a loop in a file that is compiled with OpenMP: may the loop be executed
 *  in sequential order, as by a team of one thread? */
#ifndef ANALYSIS_OPENMP_LOOP_H
#define ANALYSIS_OPENMP_LOOP_H

#include "analysis/base/openmp_directive.h"

/** A combined `parallel for`, without which the loop below it is executed. */
typedef struct openmp_loop {
    unsigned item_count;
    const openmp_item *items;
    bool has_locks;   /* `atomic` or `critical` in the loop: other threads may update as well */
    const char *kept; /* the reason to keep it, from its text; NULL: none so far */
} openmp_loop;

typedef struct blocked_scalar {
    const ir_variable *variable;
    const char *operator; /* of the clause */
} blocked_scalar;

/** What is known of the team of `omp for`: reduction/team_loop.h. */
typedef struct team_facts {
    bool shares_frame; /* a variable of the function's outermost block is one for all its threads */
    bool may_be_early; /* threads may come to the loop while others are in one before it */
} team_facts;

/** A loop whose directive reduces scalars, and stays: reduction/fixed_blocks.h. */
typedef struct fixed_blocks {
    ir_range header; /* `for ( ... )` */
    const ir_variable *counter;
    unsigned scalar_count;
    const blocked_scalar *scalars;
    openmp_directive directive;
    bool keeps_counter; /* a clause names the counter: it says what becomes of it */
    team_facts team;    /* of OPENMP_FOR */
    bool is_balanced;   /* iterations take the same time, according to `schedule` */
} fixed_blocks;

/** NULL: the loop has no OpenMP directives, above it or inside, or they are inactive. */
const openmp_loop *openmp_of_loop(arena *a, const ir_unit *unit, const ir_node *loop);

/** Does the file have code that devices execute as well? It cannot use the runtime. */
bool openmp_has_devices(const ir_unit *unit);

/** Is a `parallel for` above this loop, with these directives, omitted that makes the variable
 *  private to the threads, so that it keeps its value from before the loop? For the counter this
 *  needs no clause. */
bool openmp_keeps_value(const ir_unit *unit, const openmp_loop *above, const ir_node *loop,
                        const ir_variable *variable);

/** The variable called `name` in the loop's scope, or NULL. */
const ir_variable *openmp_variable(const ir_unit *unit, const ir_node *loop,
                                   const ir_function *function, const char *name);

#endif
