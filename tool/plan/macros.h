/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Macros and names of the program that would change generated text. */
#ifndef PLAN_MACROS_H
#define PLAN_MACROS_H

#include "ir/ir.h"

/** The name of a macro that the preprocessor would replace in the text, or NULL if there is
 * none. */
const char *macro_name_in(arena *a, const ir_unit *unit, const char *text, size_t length);
/** The name of a macro, defined before the program's file begins, that the head of the written file
 * uses (the runtime's header, pragmas), or NULL if there is none. */
const char *macro_name_in_head(const ir_unit *unit);
/** A name of the runtime's headers that the program declares, defines or mentions, or NULL if there
 * is none. */
const char *taken_name(const ir_unit *unit);
/** The name of a macro of the program that would change the macros of the runtime's header, or NULL
 * if there is none. */
const char *macro_of_header_words(arena *a, const ir_unit *unit);

#endif
