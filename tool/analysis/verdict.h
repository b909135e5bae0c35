/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One loop: all checks in turn, and what is said of it. */
#ifndef ANALYSIS_VERDICT_H
#define ANALYSIS_VERDICT_H

#include "analysis/loop/loop_analysis.h"

/** All checks for one loop. */
loop_verdict verdict_of(const analyser *an, ir_function *function, ir_node *loop);

/** Of a loop with no other than regular updates (conflict.h), of which this is one. */
loop_verdict verdict_regular(const analyser *an, ir_function *function, ir_node *loop,
                             const ir_node *update);

/** Of a loop that the user wants left alone, and all in it, by this pragma. */
loop_verdict verdict_ignored(const analyser *an, ir_function *function, ir_node *loop,
                             const user_pragma *pragma);

#endif
