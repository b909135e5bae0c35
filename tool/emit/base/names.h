/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What things are called in the text of a loop. */
#ifndef EMIT_BASE_NAMES_H
#define EMIT_BASE_NAMES_H

#include "emit/base/loop.h"

/** Sets arrays and counter_type. */
void name_things(loop_text *loop);

/** The name of something in front of the function: "redcc__slice_springs_15". */
const char *outlined_name(loop_text *loop, const char *part);
/** What the name of the function for lanes ends with. */
const char *loop_lanes_name(loop_text *loop);
/** The declaration of something of this type in a function in front of the user's. */
const char *declaration_text(loop_text *loop, const ir_type *type, const char *name);
/** The same of something that is assigned to. */
const char *assignable_declaration_text(loop_text *loop, const ir_type *type, const char *name);
/** What is written for the node, a variable of which slice or body have the address; or NULL. */
const char *pointed_name(const loop_text *loop, const ir_node *node);
/** The declaration of a private variable, of an iteration or of its slice. */
const char *private_declaration(loop_text *loop, const private_variable *item);

#endif
