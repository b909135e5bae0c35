/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Line and column of a byte as compilers report them: `#line` directives are followed. */
#ifndef IR_IR_POSITION_H
#define IR_IR_POSITION_H

#include "ir/ir.h"

typedef struct ir_position {
    const char *file;
    unsigned line;   /* from 1 */
    unsigned column; /* from 1, in bytes */
} ir_position;

/** The file's name is in the unit's arena, or the source's. */
ir_position ir_position_of(const ir_unit *unit, uint32_t offset);

/** The loop's position in one of the program's own headers; NULL: it is in the file itself. */
const ir_position *ir_position_in_header(const ir_unit *unit, const ir_node *loop);

#endif
