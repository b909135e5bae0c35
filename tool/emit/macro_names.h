/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks whether words of generated text are macros of the program. */
#ifndef EMIT_MACRO_NAMES_H
#define EMIT_MACRO_NAMES_H

#include "emit/base/loop.h"

/** Records an obstacle if a macro would change the written text. Bytes copied from the user's file
 * are not checked: they keep their meaning. */
void check_macro_names(loop_text *loop, const buffer *written);

#endif
