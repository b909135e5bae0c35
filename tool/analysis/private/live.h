/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Liveness of a variable after a loop. */
#ifndef ANALYSIS_LIVE_H
#define ANALYSIS_LIVE_H

#include "analysis/base/openmp_loop.h"
#include "analysis/memory/variable_facts.h"

/** May the value of a local variable at the end of `loop` be read later? True if unknown. `openmp`:
 *  the loop's directives; false if they make the variable private. */
bool variable_is_live_after(variable_facts *facts, const openmp_loop *openmp, const ir_node *loop,
                            const ir_variable *variable);

#endif
