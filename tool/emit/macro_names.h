/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Macros and names of the program that would change generated text. */
#ifndef EMIT_MACRO_NAMES_H
#define EMIT_MACRO_NAMES_H

#include "emit/base/loop.h"

/** Records an obstacle if a macro would change the written text, except for bytes copied from the
 *  user's file, which mean the same as there. */
void check_macro_names(loop_text *loop, const buffer *written);

#endif
