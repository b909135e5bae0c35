/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops whose OpenMP directive reduces scalars: `parallel for reduction(+ : sum)`. Their iterations
 * are divided into blocks, whose number follows from the trip count alone. The directive
 * distributes the blocks; each begins with the neutral element, and the results are combined in the
 * order of the blocks. OpenMP permits that: a team with a thread for each block may do so (OpenMP
 * 4.5, 2.7.1 and 2.15.3.6: which thread executes which iterations, and the order of combining, are
 * open). So the loop's body need only be shown not to depend on thread numbers that `schedule`
 * fixes.
 */
#ifndef ANALYSIS_FIXED_BLOCKS_H
#define ANALYSIS_FIXED_BLOCKS_H

#include "analysis/base/openmp_loop.h"
#include "analysis/loop/loop_analysis.h"

/** False: the last compiled OpenMP directive above the loop reduces no scalar. Otherwise *verdict
 * is VERDICT_BLOCKS, or VERDICT_REFUSE with the reason. */
bool blocks_of_loop(const analyser *an, ir_function *function, ir_node *loop,
                    loop_verdict *verdict);

/** Notes why updates under a lock are not made in sequential order: the refusal in `before`, the
 *  verdict of the loop's ordinary analysis. */
void blocks_note_refusal(const analyser *an, const loop_verdict *verdict,
                         const loop_verdict *before);

#endif
