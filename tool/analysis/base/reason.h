/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reasons with their messages filled in. */
#ifndef ANALYSIS_REASON_H
#define ANALYSIS_REASON_H

#include <string.h>

#include "analysis/base/facts.h"

/** The reason, its message made of reasons.def's and `name`. Lives in the arena. */
reason reason_make(arena *a, reason_id id, const char *name, ir_range range);

/** What can be done about the call of this function (REASON_IMPURE_CALL), whose body is here or is
 *  not. */
const char *reason_advice_on_call(arena *a, const char *name, bool has_body);

#endif
