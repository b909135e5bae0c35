/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks that names in the written text mean what they mean in the original, and that copied
 *  expressions keep their types. */
#ifndef BINDINGS_H
#define BINDINGS_H

#include "emit/emit.h"

/**
 * Compares, for each name in the loops' new text, the declaration that the compiler finds with the
 * intended one. For a name in a copy of the user's bytes, the intended declaration is the one found
 * in `before`. For a name written by the translator, it is the variable, function or type to which
 * the name refers. `after` is the written text, parsed. Sets wrong[i], for `written->loops[i]`, to
 * the first name with another meaning, or leaves it unchanged. Thread-safe; the names belong to the
 * units.
 */
void bindings_check(const ir_unit *before, const ir_unit *after, const emit_result *written,
                    const char **wrong);

/** Checks the types of expressions that replace others: sets wrong[i] to the spelling of the first
 * type that an expression should have but does not have, or leaves it unchanged. */
void types_check(const ir_unit *after, const emit_result *written, const char **wrong);

/** The number of the piece in `written->loops` that contains this offset of the result, or -1. */
int written_loop_at(const emit_result *written, uint32_t offset);

#endif
