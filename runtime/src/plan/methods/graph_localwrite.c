/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * LOCALWRITE with owners chosen by partitioning the access graph. An owner's elements need not be
 * adjacent. So shuffling the subscripts does not increase the number of iterations that touch
 * elements of several owners.
 */
#include "plan/methods/localwrite.h"

const struct method redcc_method_graph_localwrite = {.name = "graph-localwrite",
                                                     .keeps = REDCC_ORDER_SERIAL,
                                                     .by_graph = true,
                                                     .prepare = redcc_localwrite_prepare};
