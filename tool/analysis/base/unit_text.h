/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Facts about the text of the whole file or of a function. They are computed once, because
 *  repeating the search for each loop would make the cost quadratic in the file's size. */
#ifndef ANALYSIS_UNIT_TEXT_H
#define ANALYSIS_UNIT_TEXT_H

#include "ir/ir.h"

typedef struct unit_text unit_text;

/** Creates the facts. They are allocated in the arena and refer to the unit. */
unit_text *unit_text_new(arena *a, const ir_unit *unit);

/** The text of a directive, in the file or a header, that may switch FENV_ACCESS on; just
 *  "FENV_ACCESS" if a macro may expand to such a pragma. NULL if there is neither. */
const char *unit_text_fenv_access(const unit_text *text);

/** May a pragma or attribute change options, such as the optimisation level, for parts of the file?
 *  If so, the compiler's macros at the file's beginning do not describe these parts. */
bool unit_text_has_own_options(const unit_text *text);

/** Does this range of the file contain __COUNTER__? */
bool unit_text_has_counter(const unit_text *text, ir_range range);

/** A node of the function that calls setjmp, or that names a variable reserved for generated text;
 *  NULL if there is none. *is_setjmp says which of the two it is, and *name is the name. */
const ir_node *unit_text_obstacle(unit_text *text, const ir_function *function, const char **name,
                                  bool *is_setjmp);

#endif
