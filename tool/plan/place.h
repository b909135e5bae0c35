/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The place in front of a function of the main file, where declarations may be put. */
#ifndef PLAN_PLACE_H
#define PLAN_PLACE_H

#include "ir/ir.h"

/** Does a directive touch bytes [begin, end)? Of pragmas, if `pragmas_only`. */
bool has_directive(const ir_unit *unit, uint32_t begin, uint32_t end, bool pragmas_only);

/** Is it `#pragma WHOSE ...`? */
bool is_pragma_of(const ir_directive *d, const char *whose);

/** Do bytes [begin, end) of the text hold the word? */
bool holds_word(const source *file, uint32_t begin, uint32_t end, const char *word);

/** May declarations stand in front of the function, and an attribute of its own? Not where what is
 *  put there would be part of something else, or a pragma or a macro may be about the function. */
bool has_place_in_front(const ir_unit *unit, const ir_function *function);

/** That place: on the lines above the function (false), or in its line, if something else begins
 *  that (true). */
bool place_in_front(const ir_unit *unit, const ir_function *function, uint32_t *place);

#endif
