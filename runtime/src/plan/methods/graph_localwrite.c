/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE with owners cut from the access graph: what an owner has need not lie together, so
 * that as few iterations have several owners where the subscripts are shuffled as where they are
 * sorted.
 */
#include "plan/methods/localwrite.h"

const struct method redcc_method_graph_localwrite = {.name = "graph-localwrite",
                                                     .keeps = REDCC_ORDER_SERIAL,
                                                     .by_graph = true,
                                                     .prepare = redcc_localwrite_prepare};
