/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds file-scope names that may have another meaning inside a function. */
#ifndef ANALYSIS_HIDDEN_NAMES_H
#define ANALYSIS_HIDDEN_NAMES_H

#include "ir/ir.h"

typedef struct hidden_names hidden_names;

hidden_names *hidden_names_new(arena *a, const ir_unit *unit);

/** May a function declare a variable, enumerator or type that hides this global variable? */
bool hidden_names_has(const hidden_names *names, const ir_variable *global);

#endif
