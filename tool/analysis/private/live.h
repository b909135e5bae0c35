/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Is a variable's value needed after a loop? */
#ifndef ANALYSIS_LIVE_H
#define ANALYSIS_LIVE_H

#include "analysis/memory/variable_facts.h"

/** May the value that a local variable has when `loop` ends be read later? True where not known. */
bool variable_is_live_after(variable_facts *facts, const ir_node *loop,
                            const ir_variable *variable);

#endif
