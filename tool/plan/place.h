/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The position before a function of the main file at which declarations may be inserted. */
#ifndef PLAN_PLACE_H
#define PLAN_PLACE_H

#include "ir/ir.h"

/** Does a directive overlap bytes [begin, end)? Only pragmas count, if `pragmas_only`. */
bool has_directive(const ir_unit *unit, uint32_t begin, uint32_t end, bool pragmas_only);

/** Is the directive `#pragma WHOSE ...`? */
bool is_pragma_of(const ir_directive *d, const char *whose);

/** Do bytes [begin, end) of the text contain the word? */
bool holds_word(const source *file, uint32_t begin, uint32_t end, const char *word);

/** May declarations and an attribute be inserted before the function? Not if the inserted text
 * would become part of another construct, if a pragma or attribute may apply to the function, or if
 * the file includes itself. */
bool has_place_in_front(const ir_unit *unit, const ir_function *function);

/** Sets *place to the position before the function at which declarations may be inserted. Returns
 * true if that is in the middle of a line, because other text precedes the function there. */
bool place_in_front(const ir_unit *unit, const ir_function *function, uint32_t *place);

#endif
