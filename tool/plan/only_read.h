/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Whether a function only reads what its argument points to, according to its text. */
#ifndef PLAN_ONLY_READ_H
#define PLAN_ONLY_READ_H

#include "ir/ir.h"

/** Does the function, with all functions that it calls, only read through parameter `number`, a
 *  pointer, and through pointers read there? The function may pass the pointer on, and assign it to
 *  local variables. */
bool only_reads_through(const ir_function *function, unsigned number);

#endif
