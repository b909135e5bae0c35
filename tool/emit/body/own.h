/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Own elements: each iteration's value is kept, and stored after the loop. */
#ifndef EMIT_BODY_OWN_H
#define EMIT_BODY_OWN_H

#include "emit/base/loop.h"

/** kept_own_type returns the type of the value recorded for own element `number`, kept_own_name the
 * name of the recorded values, and kept_own_number the number by which the runtime identifies
 * them. */
const char *kept_own_type(const loop_text *loop, unsigned number);
const char *kept_own_name(loop_text *loop, unsigned number);
unsigned kept_own_number(const loop_text *loop, unsigned number);

/** Writes, at the end of an iteration, code that records the values. */
void keep_own(loop_text *loop, writer *out);
/** Writes, after the loop, code that stores the recorded values. */
void store_own(loop_text *loop, writer *out);

#endif
