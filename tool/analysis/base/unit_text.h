/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the analysis of a loop's text asks about the whole file or function, found once: asked
 *  anew for each loop, the cost would grow with the square of the file's size. */
#ifndef ANALYSIS_UNIT_TEXT_H
#define ANALYSIS_UNIT_TEXT_H

#include "ir/ir.h"

typedef struct unit_text unit_text;

/** Lives in the arena, and borrows the unit. */
unit_text *unit_text_new(arena *a, const ir_unit *unit);

/** A directive, of the file or of a header, that switches FENV_ACCESS on, or NULL. */
const char *unit_text_fenv_access(const unit_text *text);

/** May pieces of the file be compiled otherwise than the macros of its beginning say? */
bool unit_text_has_own_options(const unit_text *text);

/** Is __COUNTER__ written in this range of the file? */
bool unit_text_has_counter(const unit_text *text, ir_range range);

/** A node of the function that names what is reserved for generated text (*is_setjmp: that calls
 *  setjmp), with the name; or NULL. */
const ir_node *unit_text_obstacle(unit_text *text, const ir_function *function, const char **name,
                                  bool *is_setjmp);

#endif
