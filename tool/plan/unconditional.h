/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Code that the inspector executes under fewer conditions than the loop. */
#ifndef PLAN_UNCONDITIONAL_H
#define PLAN_UNCONDITIONAL_H

#include "analysis/base/facts.h"
#include "analysis/overlap/row_address.h"

/** May the inspector execute this statement when the program does not? */
bool is_unconditional(const loop_facts *facts, const ir_node *statement);
/** update_is_unconditional: may the inspector log the update's row even if the program does not
 *  execute the update? source_is_unconditional: may it log the read even if the program does not
 *  execute the read? In both cases the address must then be computed as a number. */
bool update_is_unconditional(const loop_facts *facts, const reduction_update *update);
bool source_is_unconditional(const loop_facts *facts, const loop_source *read);
/** Does computing the address as a number need the operator & on an object? It does not for an
 * array, nor for a pointer in an array's place. */
bool row_needs_address(const row_address *address);

#endif
