/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Array expansion with N shares of the iterations, for any number of threads, like expansion-fixed.
 * It is for loops in which the program declares the sections of the arrays that are updated. Unlike
 * in expansion-fixed, the first share writes to the arrays, and there is no inspection
 * (choose/sections.h builds the plan).
 */
#include "plan/methods/shares.h"

const struct method redcc_method_sections = {.name = "sections",
                                             .parameter = "N",
                                             .keeps = REDCC_ORDER_FIXED,
                                             .copies = COPY_LATER,
                                             .owners = redcc_one_owner,
                                             .prepare = redcc_fixed_shares_prepare};

const struct method redcc_method_shares = {
    .name = "sections", .parameter = "N", .keeps = REDCC_ORDER_FIXED, .in_bins = true};
