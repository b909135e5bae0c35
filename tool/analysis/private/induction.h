/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Secondary induction variables: integers and pointers that the loop only steps, so that their
 * values at the beginning of each iteration can be computed. */
#ifndef ANALYSIS_INDUCTION_H
#define ANALYSIS_INDUCTION_H

#include "analysis/loop/loop_analysis.h"

/** Does the loop only step the variable, by `v++`, `v += c` and the like: each step exactly once
 * in an iteration, in the body or in the header, or all in one inner loop (triangle.h)? Then it is
 * added to the privates, with its value at the beginning of an iteration. False: nothing is
 * changed. */
bool induction_take(loop_analysis *own, const ir_variable *variable);

/** Is the step, `v++` within `statement`, executed once in each iteration, and is v, which changes
 *  only by name, not used otherwise in the statement, later in the iteration, or by the next one?
 *  Then the iteration may omit the statement. */
bool induction_is_last_step(const loop_analysis *j, const ir_node *statement, const ir_node *step);

typedef struct step_result {
    reason why;
    private_list privates;
} step_result;

/** The privates, with variables other than the counter that the header steps: for (...; i++, q +=
 *  3). */
step_result check_header_steps(const loop_analysis *j);

#endif
