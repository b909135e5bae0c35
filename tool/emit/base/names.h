/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Names and declarations in the generated text of a loop. */
#ifndef EMIT_BASE_NAMES_H
#define EMIT_BASE_NAMES_H

#include "emit/base/loop.h"

/** Sets loop->arrays and loop->counter_type. */
void set_names(loop_text *loop);

/** The name of a part that is written before the user's function: "redcc__slice_springs_15". */
const char *outlined_name(loop_text *loop, const char *part);
/** The name, without the prefix "redcc__", of the function for several iterations at once
 * (lanes). */
const char *loop_lanes_name(loop_text *loop);
/** The declaration of an object of this type in a function written before the user's. */
const char *declaration_text(loop_text *loop, const ir_type *type, const char *name);
/** Like declaration_text, for an object that is assigned after its declaration. */
const char *assignable_declaration_text(loop_text *loop, const ir_type *type, const char *name);
/** The text that replaces the node if it is a variable that slice or body get by
 *  address; or NULL. */
const char *pointed_name(const loop_text *loop, const ir_node *node);
/** The declaration of a private variable in the body or in the slice. */
const char *private_declaration(loop_text *loop, const private_variable *item);

#endif
