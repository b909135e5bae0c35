/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A digest (hash) of a function. Parses of the same program in different files agree on it. */
#ifndef IR_IR_DIGEST_H
#define IR_IR_DIGEST_H

#include "ir/ir.h"

/** Hashes everything that the analysis of the function uses: its body, the static functions that it
 *  names directly or through these, their types and objects, and the dialect. Of other functions
 *  only the declarations are hashed. The hash does not depend on offsets, macros, strings, names of
 *  local variables, or arguments of functions that do not return. */
uint64_t ir_digest(const ir_unit *unit, const ir_function *function);

#endif
