/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Variables that a for loop's header sets before the first iteration: the counter, the bound,
 *  others. Used only by counted.c. */
#ifndef ANALYSIS_COUNTED_START_H
#define ANALYSIS_COUNTED_START_H

#include "analysis/base/facts.h"

/** Fills in lower, and the other fields of `counted` for the initialisation; its counter, bound and
 *  body are known. False: it has other effects as well. */
bool counted_split_declaration(const ir_node *loop, const ir_node *declaration,
                               counted_loop *counted);
bool counted_split_initialisation(const ir_node *loop, const ir_node *node, counted_loop *counted);

#endif
