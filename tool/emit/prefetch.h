/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What an executor prefetches. */
#ifndef EMIT_PREFETCH_H
#define EMIT_PREFETCH_H

#include "emit/loop.h"

/** prefetch.c: can the executor prefetch what iterations to come touch, once the loop is outlined?
 *  loop->prefetch says it then. */
prefetch_text prefetch_of(const loop_text *loop);
/** At the end of the slice: rows that an iteration reads and the inspector is not told. Only
 *  variables that the slice mentions are used; sets is_mentioned of the rows' bases. */
void write_gathers(loop_text *loop, writer *out, bool *is_mentioned);

#endif
