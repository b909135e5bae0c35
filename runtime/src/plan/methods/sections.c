/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Array expansion with N shares of the iterations for any number of threads, as expansion-fixed,
 * for loops whose program declares the sections of the arrays that are updated. The first share
 * writes in place, and there is no inspection (choose/sections.h makes the plan).
 */
#include "plan/methods/shares.h"

const struct method redcc_method_sections = {.name = "sections",
                                             .parameter = "N",
                                             .keeps = REDCC_ORDER_FIXED,
                                             .copies = COPY_LATER,
                                             .owners = redcc_one_owner,
                                             .prepare = redcc_fixed_shares_prepare};
