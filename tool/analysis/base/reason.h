/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reasons with their messages filled in. */
#ifndef ANALYSIS_REASON_H
#define ANALYSIS_REASON_H

#include <string.h>

#include "analysis/base/facts.h"

/** The reason, with the message of reasons.def and `name`. Allocated in the arena. */
reason reason_make(arena *a, reason_id id, const char *name, ir_range range);

/** Advice on a call of this function (REASON_IMPURE_CALL), with or without a body in this file. */
const char *reason_advice_on_call(arena *a, const char *name, bool has_body);

#endif
