/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * atomic: the baseline. Each thread executes an equal share of the iterations in the owner-checked
 * form. It holds a lock on a unit (a row) from before an update until the next one
 * (execute/hook.c), which makes updates atomic for every operator and type; few of these have an
 * atomic instruction.
 */
#include "plan/methods/shares.h"

const struct method redcc_method_atomic = {.name = "atomic",
                                           .keeps = REDCC_ORDER_ANY,
                                           .locks = true,
                                           .owners = redcc_one_owner,
                                           .prepare = redcc_shares_prepare};
