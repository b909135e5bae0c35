/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a function does with what it is handed by address, as its text shows. */
#ifndef PLAN_ONLY_READ_H
#define PLAN_ONLY_READ_H

#include "ir/ir.h"

/** Does the function, and whatever it calls, only read through parameter `number`, a pointer, and
 *  through pointers read there? It may be passed on, and local variables may be set to it. */
bool only_reads_through(const ir_function *function, unsigned number);

#endif
