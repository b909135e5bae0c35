/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides from a function's text whether it only reads what an argument points to. */
#ifndef PLAN_ONLY_READ_H
#define PLAN_ONLY_READ_H

#include "ir/ir.h"

/** Does the function, with all functions that it calls, only read through parameter `number`, a
 *  pointer, and through pointers read there? The function may pass the pointer on, and assign it to
 *  local variables. */
bool only_reads_through(const ir_function *function, unsigned number);

#endif
