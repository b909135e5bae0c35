/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Handles loops whose OpenMP directive reduces scalars: `parallel for reduction(+ : sum)`. The
 *  iterations are divided into blocks, whose number does not depend on the number of threads. The
 *  directive distributes the blocks over threads. Each block begins with the operator's identity
 *  element, and the results are combined in the order of the blocks.
 *
 *  OpenMP permits this, because a team with one thread per block may do the same. OpenMP 4.5
 *  (2.7.1, 2.15.3.6) leaves open which thread executes which iterations, and in which order results
 *  are combined. It is therefore enough to show that the loop's body does not depend on the thread
 *  that executes an iteration, if `schedule` determines this thread. */
#ifndef ANALYSIS_FIXED_BLOCKS_H
#define ANALYSIS_FIXED_BLOCKS_H

#include "analysis/base/openmp_loop.h"
#include "analysis/loop/loop_analysis.h"

/** Returns false if the last compiled OpenMP directive above the loop reduces no scalar. Otherwise
 *  *verdict is VERDICT_BLOCKS, or VERDICT_REFUSE with the reason. */
bool blocks_of_loop(const analyser *an, ir_function *function, ir_node *loop,
                    loop_verdict *verdict);

/** Records why updates under a lock are not made in sequential order: because of the refusal in
 *  `before`, the verdict of the loop's ordinary analysis. Does nothing if `before` is no
 *  refusal. */
void blocks_note_refusal(const analyser *an, const loop_verdict *verdict,
                         const loop_verdict *before);

#endif
