/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The parallel region. */
#ifndef EMIT_REGION_H
#define EMIT_REGION_H

#include "emit/base/loop.h"

/** region.c: `#pragma omp parallel` and what stands in it. */
void write_region(loop_text *loop, writer *out);

/** Copies of thread-local scalars: before the region, or in it, under their own names. */
void write_thread_local_copies(loop_text *loop, writer *out, bool in_region);

#endif
