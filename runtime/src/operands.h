/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Memory for the operands of scalars to which a loop adds, besides its arrays. */
#ifndef REDCC_OPERANDS_H
#define REDCC_OPERANDS_H

#include "redcc/entry.h"

#include <stdbool.h>
#include <stddef.h>

/** The limit in bytes for operands. Without REDCC_MEMORY_LIMIT it is a quarter of the machine's
 * memory, because the loop's arrays and plans also need memory. */
size_t redcc_operands_most_bytes(void);

/** Allocates and sets attempt->operands and attempt->series. Returns false and allocates nothing if
 * the trip count is not positive or memory runs out, which is reported. */
bool redcc_operands_alloc_all(redcc_loop *loop, const redcc_attempt *attempt);

/** Frees attempt->operands and attempt->series. */
void redcc_operands_free_all(const redcc_attempt *attempt);

#endif
