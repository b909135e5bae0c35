/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The position before a function of the main file at which declarations may be inserted. */
#ifndef PLAN_PLACE_H
#define PLAN_PLACE_H

#include "ir/ir.h"

/** Does a directive overlap bytes [begin, end)? Only pragmas count, if `pragmas_only`. */
bool has_directive(const ir_unit *unit, uint32_t begin, uint32_t end, bool pragmas_only);

/** Is it `#pragma WHOSE ...`? */
bool is_pragma_of(const ir_directive *d, const char *whose);

/** Do bytes [begin, end) of the text contain the word? */
bool holds_word(const source *file, uint32_t begin, uint32_t end, const char *word);

/** May declarations be inserted before the function, and an attribute for it? Not if the inserted
 *  text would become part of another construct, or a pragma or a macro may apply to the
 *  function. */
bool has_place_in_front(const ir_unit *unit, const ir_function *function);

/** That position: on the lines above the function (false), or in its line, if other text begins the
 *  line (true). */
bool place_in_front(const ir_unit *unit, const ir_function *function, uint32_t *place);

#endif
