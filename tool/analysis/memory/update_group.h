/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises updates that consist of several statements: the element is loaded, its value is
 *  changed and stored again. */
#ifndef ANALYSIS_UPDATE_GROUP_H
#define ANALYSIS_UPDATE_GROUP_H

#include "analysis/memory/variable_facts.h"

/** An update such as `double v = h[k]; if (v > m) v = m; h[k] = v;`. Its statements are consecutive
 *  in one block. They write only the variable, other variables that they declare, and the element.
 *  The variable occurs nowhere else. */
typedef struct update_group {
    const ir_node *first;   /* the declaration, or assignment statement, that loads the element */
    const ir_node *last;    /* the statement that stores */
    const ir_node *element; /* the element as the first statement spells it */
} update_group;

/** Is the assignment the last statement of such an update? If so, stores its description in
 *  *group. */
bool update_group_of(variable_facts *facts, const ir_node *assignment, update_group *group);

/** The local variable that is set to the value of this read of an element. A later statement of the
 *  same block must store a function of the variable to the element. NULL if there is none. */
const ir_variable *update_group_holder(const ir_node *read);

/** Is the node in one of the group's statements? */
bool update_group_has(const update_group *group, const ir_node *node);

#endif
