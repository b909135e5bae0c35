/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions that look a place up: int k = from; while (... a[k] ...) k++; return k; */
#ifndef ANALYSIS_SEARCH_H
#define ANALYSIS_SEARCH_H

#include "ir/ir.h"

/**
 * `read` is an access a[k] in the text of `function`. Where each call reads a[from], a[from + 1],
 * ..., a[result] by it, every one of them, returns the expression `from`, which is converted to the
 * type of the read's subscript; else NULL.
 */
const ir_node *search_start(const ir_function *function, const ir_node *read);

#endif
