/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Do the names in the text that was written mean what they mean where they come from, and do
 *  expressions in the place of the program's have their types? */
#ifndef BINDINGS_H
#define BINDINGS_H

#include "emit/emit.h"

/**
 * Compares, for each name in the loops' new text, the declaration that the compiler finds with the
 * one that is meant: of a copy of the user's bytes the one found there in `before`, of a name that
 * the translator wrote the one of the variable, function or type that it stands for. `after` is the
 * written text, parsed. Sets wrong[i], for loop i of `written`, to the first name that would mean
 * something else, or leaves it as it is. Thread-safe; the names are one of the units'.
 */
void bindings_check(const ir_unit *before, const ir_unit *after, const emit_result *written,
                    const char **wrong);

/** The same for the types of expressions that stand in the place of others: sets wrong[i] to the
 *  spelling of the first type that one should have and has not. */
void types_check(const ir_unit *after, const emit_result *written, const char **wrong);

/** The loop of `written` in whose text this place of the result lies, or -1. */
int written_loop_at(const emit_result *written, uint32_t offset);

#endif
