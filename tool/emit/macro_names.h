/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks generated text for words that are macros of the program. */
#ifndef EMIT_MACRO_NAMES_H
#define EMIT_MACRO_NAMES_H

#include "emit/base/loop.h"

/** Records an obstacle if a macro would change the written text, except for bytes copied from the
 *  user's file, which mean the same as there. */
void check_macro_names(loop_text *loop, const buffer *written);

#endif
