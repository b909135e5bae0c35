/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loop fission: some stores are made by a second loop, after all iterations
 * (analysis/reduction/distribution.h). */
#ifndef EMIT_DISTRIBUTION_H
#define EMIT_DISTRIBUTION_H

#include "emit/base/loop.h"

/** Writes, after the loop, a loop that makes the deferred stores if the parallel form has run. */
void write_distributed_stores(loop_text *loop, writer *out);

#endif
