/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Nested loops that one directive distributes: `collapse(n)`. One thread executes their iterations
 * in the order of the nest as written.
 */
#ifndef ANALYSIS_OPENMP_NEST_H
#define ANALYSIS_OPENMP_NEST_H

#include "analysis/base/openmp_directive.h"

/** Reads the directive above the loop. The counters of inner loops that `collapse` makes private
 *  become items, as if `private` named them. */
openmp_directive openmp_read_above(arena *a, const ir_unit *unit, const ir_directive *d,
                                   const ir_node *loop);

/** The number in the clause `collapse`; 1: there is none. */
unsigned openmp_depth(const openmp_directive *read);

/** The variable that the loop's header sets first; NULL: the header declares one, or sets none. */
const ir_variable *openmp_counter(const ir_node *loop);

/** The loop that is all of the loop's body; NULL: there is none. */
const ir_node *openmp_inner_loop(const ir_node *loop);

/** The text above a loop around this one that concerns both, and so may need this loop as written:
 *  a directive, or a macro that may make one; or NULL. */
const char *openmp_about_nest(arena *a, const ir_unit *unit, const ir_node *loop);

#endif
