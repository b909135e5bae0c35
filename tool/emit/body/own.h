/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Own elements: what each iteration makes of them is kept, and stored after the loop. */
#ifndef EMIT_BODY_OWN_H
#define EMIT_BODY_OWN_H

#include "emit/base/loop.h"

/** Of own element `number`'s kept value: the type, the name, and the number by which the runtime
 *  keeps it. */
const char *kept_own_type(const loop_text *loop, unsigned number);
const char *kept_own_name(loop_text *loop, unsigned number);
unsigned kept_own_number(const loop_text *loop, unsigned number);

/** At the end of an iteration; */
void keep_own(loop_text *loop, writer *out);
/** and after the loop. */
void store_own(loop_text *loop, writer *out);

#endif
