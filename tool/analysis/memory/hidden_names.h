/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Names of a file that may have another meaning inside of a function. */
#ifndef ANALYSIS_HIDDEN_NAMES_H
#define ANALYSIS_HIDDEN_NAMES_H

#include "ir/ir.h"

typedef struct hidden_names hidden_names;

hidden_names *hidden_names_new(arena *a, const ir_unit *unit);

/** Could a variable, enumerator or type of a function hide the global one? */
bool hidden_names_has(const hidden_names *names, const ir_variable *global);

#endif
