/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * atomic: a method to compare others with. Each thread executes an equal share of the iterations in
 * the owner-checked form, and locks a unit (a row) during each update (execute/hook.c). It uses
 * locks because only a few operators and types have atomic instructions.
 */
#include "plan/methods/shares.h"

const struct method redcc_method_atomic = {.name = "atomic",
                                           .keeps = REDCC_ORDER_ANY,
                                           .locks = true,
                                           .owners = redcc_one_owner,
                                           .prepare = redcc_shares_prepare};
