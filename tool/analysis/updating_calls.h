/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Calls of helpers that update elements, in loops that stay sequential. */
#ifndef ANALYSIS_UPDATING_CALLS_H
#define ANALYSIS_UPDATING_CALLS_H

#include "analysis/nest.h"

/** Appends those of the function that is being searched. Its loops' verdicts are those from number
 *  `from` on. If a call in a loop updates an element that iterations share, then all calls in this
 *  loop that update single elements are listed. */
void list_updating_calls(loop_search *s, unsigned from);

#endif
