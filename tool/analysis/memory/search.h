/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Look-up functions: int k = from; while (... a[k] ...) k++; return k; */
#ifndef ANALYSIS_SEARCH_H
#define ANALYSIS_SEARCH_H

#include "ir/ir.h"

/**
 * `read` is an access a[k] in the text of `function`. If each call reads all of a[from], a[from +
 * 1], ..., a[result] by it, returns the expression `from`, which the function converts to the type
 * of the read's subscript; else NULL.
 */
const ir_node *search_start(const ir_function *function, const ir_node *read);

#endif
