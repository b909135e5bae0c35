/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The code of a thread that executes a part of the loop. */
#ifndef EMIT_REGION_H
#define EMIT_REGION_H

#include "emit/base/loop.h"

/** It inspects its iterations, then executes those that it is handed. */
void write_region(loop_text *loop, writer *out);
/** Its statements after that. */
void write_thread_end(loop_text *loop, writer *out);

#endif
