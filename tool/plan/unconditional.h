/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the inspector does under fewer conditions than the loop. */
#ifndef PLAN_UNCONDITIONAL_H
#define PLAN_UNCONDITIONAL_H

#include "analysis/base/facts.h"
#include "analysis/overlap/row_address.h"

/** Does the inspector come to this statement where the program may not? */
bool is_unconditional(const loop_facts *facts, const ir_node *statement);
/** The same of where it logs an update's row, or a read: the address is to be a number then. */
bool update_is_unconditional(const loop_facts *facts, const reduction_update *update);
bool source_is_unconditional(const loop_facts *facts, const loop_source *read);
/** Does the address as a number begin with & of an object? An array needs none, nor a pointer in
 * its place. */
bool row_needs_address(const row_address *address);

#endif
