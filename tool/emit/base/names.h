/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Names in the text of a loop. */
#ifndef EMIT_BASE_NAMES_H
#define EMIT_BASE_NAMES_H

#include "emit/base/loop.h"

/** Sets arrays and counter_type. */
void name_things(loop_text *loop);

/** The name of a function before the user's: "redcc__slice_springs_15". */
const char *outlined_name(loop_text *loop, const char *part);
/** The suffix of the name of the function for lanes. */
const char *loop_lanes_name(loop_text *loop);
/** The declaration of an object of this type in a function before the user's. */
const char *declaration_text(loop_text *loop, const ir_type *type, const char *name);
/** The same for an object that is assigned to. */
const char *assignable_declaration_text(loop_text *loop, const ir_type *type, const char *name);
/** The text that replaces the node, a variable whose address slice or body get; or NULL. */
const char *pointed_name(const loop_text *loop, const ir_node *node);
/** The declaration of a private variable, of an iteration or of its slice. */
const char *private_declaration(loop_text *loop, const private_variable *item);

#endif
