/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lists the calls of functions that update or check something, in loops that stay sequential. */
#ifndef ANALYSIS_UPDATING_CALLS_H
#define ANALYSIS_UPDATING_CALLS_H

#include "analysis/nest.h"

/** Appends the updating calls of s->function to s->calls. The verdicts of its loops are those from
 *  number `from` on. If a call in a loop updates an element that several iterations may update, or
 *  a call with a check is the reason why the loop is refused, all calls in this loop that update
 *  single elements or have a check (loop_exits.h) are listed. */
void list_updating_calls(loop_search *s, unsigned from);

#endif
