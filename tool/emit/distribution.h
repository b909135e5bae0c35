/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loop fission: stores that are made after all iterations (analysis/reduction/distribution.h). */
#ifndef EMIT_DISTRIBUTION_H
#define EMIT_DISTRIBUTION_H

#include "emit/base/loop.h"

/** After the loop, if it has run in parallel: makes the deferred stores. */
void write_distributed_stores(loop_text *loop, writer *out);

#endif
