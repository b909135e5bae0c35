/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Creates reasons with complete messages. */
#ifndef ANALYSIS_REASON_H
#define ANALYSIS_REASON_H

#include <string.h>

#include "analysis/base/facts.h"

/** The reason with this id; `name` is inserted into its message from reasons.def. Allocated in the
 *  arena. */
reason reason_make(arena *a, reason_id id, const char *name, ir_range range);

/** Advice for a call of this function (REASON_IMPURE_CALL). It depends on whether the function has
 *  a body in this file. */
const char *reason_advice_on_call(arena *a, const char *name, bool has_body);

#endif
