/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The code of a thread that executes a part of the loop. */
#ifndef EMIT_REGION_H
#define EMIT_REGION_H

#include "emit/base/loop.h"

/** Writes the code by which a thread inspects its iterations, and then executes those that it is
 *  assigned. */
void write_region(loop_text *loop, writer *out);
/** Writes the thread's last statements. */
void write_thread_end(loop_text *loop, writer *out);

#endif
