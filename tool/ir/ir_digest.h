/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A function's digest: two parses of one program agree on it. */
#ifndef IR_IR_DIGEST_H
#define IR_IR_DIGEST_H

#include "ir/ir.h"

/**
 * A digest of the function's body, of the static functions that it calls, directly or indirectly,
 * of all types and objects in them, and of the dialect: of everything that the analysis uses.
 * Other functions enter with their declarations only. Offsets, macros, strings, names of local
 * variables, and arguments of functions that do not return do not count.
 */
uint64_t ir_digest(const ir_unit *unit, const ir_function *function);

#endif
