/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Handles nested loops that one directive with `collapse(n)` distributes over threads. Without the
 *  directive, one thread executes them in the order in which they are written. */
#ifndef ANALYSIS_OPENMP_NEST_H
#define ANALYSIS_OPENMP_NEST_H

#include "analysis/base/openmp_directive.h"

/** Reads the directive above the loop. The counters of inner loops, which `collapse` makes private,
 *  are added as if `private` named them. */
openmp_directive openmp_read_above(arena *a, const ir_unit *unit, const ir_directive *d,
                                   const ir_node *loop);

/** The number in the clause `collapse`; 1 if there is none. */
unsigned openmp_depth(const openmp_directive *read);

/** The variable that the loop's header sets first; NULL if the header declares it, or sets none. */
const ir_variable *openmp_counter(const ir_node *loop);

/** The `for` loop that forms the whole body of the loop; NULL if there is none. */
const ir_node *openmp_inner_loop(const ir_node *loop);

/** The text above an enclosing loop that may apply to this loop as well, so that this loop must
 *  stay as it is. The text is a directive, or a macro that may expand to one. NULL if there is
 *  none. */
const char *openmp_about_nest(arena *a, const ir_unit *unit, const ir_node *loop);

#endif
