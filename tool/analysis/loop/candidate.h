/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether to analyse a loop as one reduction loop, or only its inner loops. */
#ifndef ANALYSIS_CANDIDATE_H
#define ANALYSIS_CANDIDATE_H

#include "analysis/loop/loop_analysis.h"

/** Do constant bounds limit the loop to a few iterations? */
bool candidate_is_tiny(const ir_node *loop);

/** Is an iteration's work that of a few statements? It may contain only tiny loops
 *  (candidate_is_tiny), and may call only C library functions that do nothing but compute a value
 *  (library.h) and functions without loops. */
bool candidate_is_short(const ir_unit *unit, const ir_node *body);

/** Do the elements that an iteration updates depend on the loop's counter, through subscripts or
 *  conditions? If not (repetitions, time steps), all iterations update the same elements, and there
 *  is no parallelism between them. True if unknown. */
bool candidate_varies(const analyser *an, const ir_node *loop);

#endif
