/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The translator reads what it wrote before anyone else does. */
#ifndef SELF_CHECK_H
#define SELF_CHECK_H

#include "frontend/frontend.h"
#include "options.h"

/**
 * Parses the output as the sequential program, and where the runtime's header is found also as the
 * parallel one. Returns NULL, or in the arena the first compiler error that the input (which has
 * none) did not have.
 */
const char *self_check(arena *a, const source *input, const string_list *flags, const char *text,
                       size_t length);

/** Why the runtime's header could not be included from the output, in the arena: the flags lead to
 *  another one of its name. NULL: they do not, as far as is known. */
const char *other_runtime_header(arena *a, const string_list *flags);

#endif
