/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE with owners cut from the access graph: an owner's elements need not be adjacent, so
 * that shuffled subscripts have no more iterations of several owners than sorted ones.
 */
#include "plan/methods/localwrite.h"

const struct method redcc_method_graph_localwrite = {.name = "graph-localwrite",
                                                     .keeps = REDCC_ORDER_SERIAL,
                                                     .by_graph = true,
                                                     .prepare = redcc_localwrite_prepare};
