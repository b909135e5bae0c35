/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Whether all iterations are told once in order before they are inspected. */
#ifndef EMIT_DRY_RUN_H
#define EMIT_DRY_RUN_H

#include "emit/loop.h"

/** dry_run.c: sets loop->dry_run, or records an obstacle where that would not do. */
void check_stale_slice(loop_text *loop);

#endif
