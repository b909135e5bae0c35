/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The translator reads what it wrote before anyone else does. */
#ifndef SELF_CHECK_H
#define SELF_CHECK_H

#include "emit/emit.h"
#include "frontend/frontend.h"
#include "redcc/options.h"

/** Does redcc's own redcc/runtime.h lie where this program's companions lie (installation.h)? What
 *  names mean in the parallel form is known only with it. */
bool own_runtime_header_exists(arena *a);

/**
 * Parses the output as the sequential program and, with redcc's own header, which must be there, as
 * the parallel one. Sets found[i], for loop i of `written`, to what is wrong with its text: a
 * compiler error that the input (which has none) did not have, or a name that has got another
 * meaning; leaves it as it is where nothing is. An error that lies in no loop is each one's.
 * Returns whether nothing was found. What is found lives in the arena.
 */
bool self_check(arena *a, const ir_unit *input, const string_list *flags,
                const emit_result *written, reason *found);

/** Why the runtime's header could not be included from the output, in the arena: the flags lead to
 *  another one with the same name. NULL: they do not, or redcc's own cannot be found to compare. */
const char *other_runtime_header(arena *a, const string_list *flags);

#endif
