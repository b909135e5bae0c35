/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a thread does that executes a part of the loop. */
#ifndef EMIT_REGION_H
#define EMIT_REGION_H

#include "emit/base/loop.h"

/** It inspects its iterations, then executes what it is handed. */
void write_region(loop_text *loop, writer *out);
/** What it does after that. */
void write_thread_end(loop_text *loop, writer *out);

#endif
