/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The translator checks its own output by parsing it. */
#ifndef SELF_CHECK_H
#define SELF_CHECK_H

#include "emit/emit.h"
#include "frontend/frontend.h"
#include "redcc/options.h"

/** Is redcc's own redcc/runtime.h installed with this program (installation.h)? Without it the
 *  meaning of names in the parallel form is unknown, and self_check must not be called. */
bool own_runtime_header_exists(arena *a);

/**
 * Parses the output as the sequential program and, with redcc's own header, which must exist, as
 * the parallel one. The caller has initialised found[i] to no reason. Sets it to the fault in the
 * text of loop i of `written`: a compiler error that the input does not have, or a name whose
 * meaning has changed. An error outside of all loops is attributed to each loop. Returns whether no
 * fault was found. Texts live in the arena.
 */
bool self_check(arena *a, const ir_unit *input, const string_list *flags,
                const emit_result *written, reason *found);

/** Returns a sentence, in the arena, if the flags make the compiler find another <redcc/runtime.h>
 * before redcc's own. Returns NULL if they do not, or if redcc's own header is not installed. */
const char *other_runtime_header(arena *a, const string_list *flags);

#endif
