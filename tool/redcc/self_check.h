/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The translator reads what it wrote before anyone else does. */
#ifndef SELF_CHECK_H
#define SELF_CHECK_H

#include "emit/emit.h"
#include "frontend/frontend.h"
#include "redcc/options.h"

/**
 * Parses the output as the sequential program, and where the runtime's header is found also as the
 * parallel one. Sets found[i], for loop i of `written`, to what is wrong with its text: a compiler
 * error that the input (which has none) did not have, or a name that has got another meaning;
 * leaves it as it is where nothing is. An error that lies in no loop is each one's. Returns whether
 * nothing was found. What is found lives in the arena.
 */
bool self_check(arena *a, const ir_unit *input, const string_list *flags,
                const emit_result *written, reason *found);

/** Why the runtime's header could not be included from the output, in the arena: the flags lead to
 *  another one of its name. NULL: they do not, as far as is known. */
const char *other_runtime_header(arena *a, const string_list *flags);

#endif
