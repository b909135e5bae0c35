/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Analyses one loop by all checks in order, and gives its verdict. */
#ifndef ANALYSIS_VERDICT_H
#define ANALYSIS_VERDICT_H

#include "analysis/loop/loop_analysis.h"

loop_verdict verdict_of(const analyser *an, ir_function *function, ir_node *loop);

/** The verdict on a loop whose updates are all regular (conflict.h); `update` is one of them. */
loop_verdict verdict_regular(const analyser *an, ir_function *function, ir_node *loop,
                             const ir_node *update);

/** The verdict on a loop in which `update` is the atomic operation `name` (atomic_call.h), or a
 * call of a function that contains it. */
loop_verdict verdict_atomic(const analyser *an, ir_function *function, ir_node *loop,
                            const ir_node *update, const char *name);

/** The verdict on a loop that a pragma leaves sequential, together with its inner loops. */
loop_verdict verdict_ignored(const analyser *an, ir_function *function, ir_node *loop,
                             const user_pragma *pragma);

/** The verdict on a loop whose text is in a header. */
loop_verdict verdict_in_header(const analyser *an, ir_function *function, ir_node *loop,
                               const char *header);

#endif
