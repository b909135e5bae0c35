/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether a loop is worth being analysed as one reduction loop, or only its inner
 *  loops. */
#ifndef ANALYSIS_CANDIDATE_H
#define ANALYSIS_CANDIDATE_H

#include "analysis/loop/loop_analysis.h"

/** Is this a loop of a few iterations only, by its constants? */
bool candidate_is_tiny(const ir_node *loop);

/** Is an iteration's work that of a few statements: only tiny loops, and only calls of the C
 *  library's mathematics, or of functions without loops? */
bool candidate_is_short(const ir_unit *unit, const ir_node *body);

/** Do the elements that an iteration updates depend on the loop's counter, by subscripts or by
 *  conditions? Otherwise (repetitions, time steps) all iterations update the same, and there is no
 *  parallelism between them. True if unknown. */
bool candidate_varies(const analyser *an, const ir_node *loop);

#endif
