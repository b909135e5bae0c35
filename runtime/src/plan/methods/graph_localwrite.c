/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE with owners chosen by partitioning the access graph. An owner's elements need not be
 * adjacent, so that with shuffled subscripts no more iterations touch elements of several owners
 * than with sorted ones.
 */
#include "plan/methods/localwrite.h"

const struct method redcc_method_graph_localwrite = {.name = "graph-localwrite",
                                                     .keeps = REDCC_ORDER_SERIAL,
                                                     .by_graph = true,
                                                     .prepare = redcc_localwrite_prepare};
