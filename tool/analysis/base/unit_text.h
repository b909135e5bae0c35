/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Facts about the text of the whole file or function, computed once: if each loop repeated the
 *  search, the cost would be quadratic in the file's size. */
#ifndef ANALYSIS_UNIT_TEXT_H
#define ANALYSIS_UNIT_TEXT_H

#include "ir/ir.h"

typedef struct unit_text unit_text;

/** Allocated in the arena; borrows the unit. */
unit_text *unit_text_new(arena *a, const ir_unit *unit);

/** A directive, of the file or of a header, that may switch FENV_ACCESS on, or NULL. */
const char *unit_text_fenv_access(const unit_text *text);

/** May parts of the file be compiled with other options than the macros at its beginning show? */
bool unit_text_has_own_options(const unit_text *text);

/** Does this range of the file contain __COUNTER__? */
bool unit_text_has_counter(const unit_text *text, ir_range range);

/** A node of the function that uses a name reserved for generated text (*is_setjmp: that calls
 *  setjmp), with the name; or NULL. */
const ir_node *unit_text_obstacle(unit_text *text, const ir_function *function, const char **name,
                                  bool *is_setjmp);

#endif
