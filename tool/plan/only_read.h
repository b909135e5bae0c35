/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Whether a function only reads what its argument points to, according to its text. */
#ifndef PLAN_ONLY_READ_H
#define PLAN_ONLY_READ_H

#include "ir/ir.h"

/** Does the function, and whatever it calls, only read through parameter `number`, a pointer, and
 *  through pointers read there? It may be passed on, and local variables may be set to it. */
bool only_reads_through(const ir_function *function, unsigned number);

#endif
