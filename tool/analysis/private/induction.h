/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Handles secondary induction variables: integers and pointers that the loop only steps, so their
 *  values at the beginning of each iteration can be computed. */
#ifndef ANALYSIS_INDUCTION_H
#define ANALYSIS_INDUCTION_H

#include "analysis/loop/loop_analysis.h"

/** Does the loop only step the variable, by `v++`, `v += c` and the like? Either each step must be
 *  made exactly once in each iteration, in the body or the header, or one inner loop must make all
 *  steps (triangle.h). If so, adds the variable to the privates and returns true. Otherwise changes
 *  nothing and returns false. */
bool induction_take(loop_analysis *own, const ir_variable *variable);

/** Is the step, `v++` in `statement`, the last use of v in the iteration, so that the iteration may
 *  skip the statement? The step must be executed once in each iteration, and v must change only by
 *  name. v must not be used elsewhere in the statement, later in the iteration, or by the next
 *  one. */
bool induction_is_last_step(const loop_analysis *j, const ir_node *statement, const ir_node *step);

typedef struct step_result {
    reason why;
    private_list privates;
} step_result;

/** The privates, including variables other than the counter that the header steps:
 *  `for (...; i++, q += 3)`. */
step_result check_header_steps(const loop_analysis *j);

#endif
