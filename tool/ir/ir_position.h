/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Computes the line and column of a byte as compilers report them, following `#line`
 *  directives. */
#ifndef IR_IR_POSITION_H
#define IR_IR_POSITION_H

#include "ir/ir.h"

typedef struct ir_position {
    const char *file;
    unsigned line;   /* counted from 1 */
    unsigned column; /* in bytes, counted from 1 */
} ir_position;

/** The result's file name belongs to the unit's arena or to its source. */
ir_position ir_position_of(const ir_unit *unit, uint32_t offset);

/** The loop's position if it is in one of the program's own headers; NULL if it is in the main
 *  file. */
const ir_position *ir_position_in_header(const ir_unit *unit, const ir_node *loop);

#endif
