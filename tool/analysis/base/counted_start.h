/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables that a for loop's header sets before the first iteration: the counter, the bound,
 *  others. Used only by counted.c. */
#ifndef ANALYSIS_COUNTED_START_H
#define ANALYSIS_COUNTED_START_H

#include "analysis/base/facts.h"

/** `counted` already has its counter, bound and body. Fills in `lower` and the other fields that
 *  the initialisation determines. Returns false if the initialisation has other effects as well. */
bool counted_split_declaration(const ir_node *loop, const ir_node *declaration,
                               counted_loop *counted);
bool counted_split_initialisation(const ir_node *loop, const ir_node *node, counted_loop *counted);

#endif
