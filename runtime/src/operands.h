/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Memory for the operands of scalars that a loop accumulates besides its arrays. */
#ifndef REDCC_OPERANDS_H
#define REDCC_OPERANDS_H

#include "redcc/entry.h"

#include <stdbool.h>

/** Sets attempt->operands; false: memory is lacking (which is reported), and none is allocated. */
bool redcc_operands_take_all(redcc_loop *loop, const redcc_attempt *attempt);

/** Frees attempt->operands. */
void redcc_operands_give_all(const redcc_attempt *attempt);

#endif
