/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The OpenMP directives of a loop, where the file is compiled with OpenMP: may it be executed in
 *  the order of the sequential loop, as a team of one thread does? */
#ifndef ANALYSIS_OPENMP_LOOP_H
#define ANALYSIS_OPENMP_LOOP_H

#include "analysis/base/openmp_directive.h"

/** What stands above a loop that is executed without it: a combined `parallel for`. */
typedef struct openmp_loop {
    unsigned item_count;
    const openmp_item *items;
    bool has_locks;   /* `atomic` or `critical` in the loop: other threads may update as well */
    const char *kept; /* why it stays as it is, by text alone; NULL: nothing is known yet */
} openmp_loop;

/** NULL: no directive of OpenMP stands above the loop or in it, or they are asleep. */
const openmp_loop *openmp_of_loop(arena *a, const ir_unit *unit, const ir_node *loop);

/** Is a `parallel for` above this loop left out, by which the variable is private to the threads,
 *  and keeps the value that it has before the loop? Of its counter it is said without a clause. */
bool openmp_keeps_value(arena *a, const ir_unit *unit, const ir_node *loop,
                        const ir_variable *variable);

/** The variable that `name` means where the loop stands; NULL: it is none. */
const ir_variable *openmp_variable(const ir_unit *unit, const ir_node *loop,
                                   const ir_function *function, const char *name);

#endif
