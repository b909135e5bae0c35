/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lists the calls of functions that update or check something, in loops that stay sequential. */
#ifndef ANALYSIS_UPDATING_CALLS_H
#define ANALYSIS_UPDATING_CALLS_H

#include "analysis/nest.h"

/** Appends the updating calls of s->function to s->calls. The verdicts on its loops are s->verdicts
 *  from index `from` on. A loop's calls are listed if one of them updates an element that several
 *  iterations may update, or may be why the loop is refused: it contains a check (loop_exits.h),
 *  updates elements, or writes a local scalar. */
void list_updating_calls(loop_search *s, unsigned from);

#endif
