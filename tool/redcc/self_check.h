/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The translator checks its own output by parsing it. */
#ifndef SELF_CHECK_H
#define SELF_CHECK_H

#include "emit/emit.h"
#include "frontend/frontend.h"
#include "redcc/options.h"

/** Is redcc's own redcc/runtime.h installed with this program (installation.h)? Without it the
 *  meaning of names in the parallel form is unknown. */
bool own_runtime_header_exists(arena *a);

/**
 * Parses the output as the sequential program and, with redcc's own header, which must exist, as
 * the parallel one. Sets found[i], for loop i of `written`, to the fault in its text: a compiler
 * error that the input (which has none) did not have, or a name whose meaning has changed;
 * otherwise leaves it unchanged. An error outside of all loops is attributed to each. Returns
 * whether no fault was found. Texts live in the arena.
 */
bool self_check(arena *a, const ir_unit *input, const string_list *flags,
                const emit_result *written, reason *found);

/** The reason why the runtime's header could not be included from the output, in the arena: the
 *  flags lead to another one with the same name. NULL: they do not, or redcc's own cannot be found
 *  to compare. */
const char *other_runtime_header(arena *a, const string_list *flags);

#endif
