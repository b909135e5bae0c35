/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises functions that search linearly: int k = from; while (... a[k] ...) k++; return k; */
#ifndef ANALYSIS_SEARCH_H
#define ANALYSIS_SEARCH_H

#include "ir/ir.h"

/** Checks whether `read`, an access a[k] in the text of `function`, reads exactly `a[from]`,
 *  `a[from + 1]`, ..., `a[result]` in each call. If so, returns the expression `from`, which the
 *  function converts to the type of the read's subscript. Otherwise returns NULL. */
const ir_node *search_start(const ir_function *function, const ir_node *read);

#endif
