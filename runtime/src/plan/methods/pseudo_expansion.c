/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Pseudo-expansion: array expansion, in which a thread's copy covers only the range that its own
 * iterations touch, as found by the inspector.
 */
#include "plan/methods/shares.h"

const struct method redcc_method_pseudo_expansion = {.name = "pseudo-expansion",
                                                     .keeps = REDCC_ORDER_ANY,
                                                     .copies = COPY_TOUCHED,
                                                     .owners = redcc_one_owner,
                                                     .prepare = redcc_shares_prepare};
