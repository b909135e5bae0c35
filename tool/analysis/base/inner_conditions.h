/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Gives inner loops whose end an element tells one form, in which a statement of the body reads
 * the element:
 *
 *      while ((k = *p++) != END) b[k]++;
 *      while (1) { if (!((k = *p++) != END)) break; b[k]++; }
 *
 *  The inspector records what statements read, so that it can be compared with what the analysed
 *  loop updates. Reads in the condition itself it cannot record. */
#ifndef ANALYSIS_INNER_CONDITIONS_H
#define ANALYSIS_INNER_CONDITIONS_H

#include "ir/ir.h"
#include "support/source.h"

typedef struct inner_conditions inner_conditions;

/** Moves the conditions that read memory into the bodies of their loops, which get the flag
 *  IR_OPENED. Counted loops and loops of macros stay as they are. NULL if nothing was moved. */
inner_conditions *inner_conditions_move(arena *a, const source *text, ir_function *function,
                                        ir_node *loop);

void inner_conditions_put_back(const inner_conditions *moved);

#endif
