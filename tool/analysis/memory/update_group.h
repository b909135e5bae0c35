/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Updates in several statements: the element is loaded, the value is changed, and stored again. */
#ifndef ANALYSIS_UPDATE_GROUP_H
#define ANALYSIS_UPDATE_GROUP_H

#include "analysis/memory/variable_facts.h"

/** `double v = h[k]; if (v > m) v = m; h[k] = v;`: consecutive statements of one block that write
 *  only the variable, others that they declare, and the element. No other text uses the variable.
 */
typedef struct update_group {
    const ir_node *first;   /* the declaration, or assignment as a statement, that loads */
    const ir_node *last;    /* the statement that stores */
    const ir_node *element; /* as the first one spells it */
} update_group;

/** Is the assignment the last of such statements? Then *group describes them. */
bool update_group_of(variable_facts *facts, const ir_node *assignment, update_group *group);

/** The local variable that this read of an element sets, and from which a later statement of the
 *  block sets the element; NULL: none. */
const ir_variable *update_group_holder(const ir_node *read);

/** Is the node in one of the group's statements? */
bool update_group_has(const update_group *group, const ir_node *node);

#endif
