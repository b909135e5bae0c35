/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Memory for the operands of scalars that a loop accumulates in addition to its arrays. */
#ifndef REDCC_OPERANDS_H
#define REDCC_OPERANDS_H

#include "redcc/entry.h"

#include <stdbool.h>
#include <stddef.h>

/** The limit for operands in bytes. Without REDCC_MEMORY_LIMIT it is a quarter of the machine's
 * memory, since the loop's arrays and plans need memory, too. */
size_t redcc_operands_most_bytes(void);

/** Sets attempt->operands and attempt->series. False: trip is not positive, or memory is lacking
 * (which is reported); none is allocated. */
bool redcc_operands_alloc_all(redcc_loop *loop, const redcc_attempt *attempt);

/** Frees both. */
void redcc_operands_free_all(const redcc_attempt *attempt);

#endif
