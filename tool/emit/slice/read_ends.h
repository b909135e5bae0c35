/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inner loops over consecutive elements that are only read. If the slice records only reads, as
 * while updates are pushed to bins or made on private copies, such a loop needs only its first and
 * last iterations, because a range of addresses is recorded. */
#ifndef EMIT_READ_ENDS_H
#define EMIT_READ_ENDS_H

#include "emit/slice/access_log.h"

/** The loop's step that visits only these iterations; NULL if it must keep the program's own. */
const char *read_ends_step(inspector *self, const ir_node *loop);

#endif
