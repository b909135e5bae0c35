/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Liveness of a variable after a loop: may its value still be used? */
#ifndef ANALYSIS_LIVE_H
#define ANALYSIS_LIVE_H

#include "analysis/base/openmp_loop.h"
#include "analysis/memory/variable_facts.h"

/** May the value that a local variable has at the end of `loop` be read later? True if unknown.
 *  False if the loop's directives `openmp` make the variable private. */
bool variable_is_live_after(variable_facts *facts, const openmp_loop *openmp, const ir_node *loop,
                            const ir_variable *variable);

#endif
