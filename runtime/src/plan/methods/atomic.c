/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * atomic: the yardstick. Each thread executes an equal share of the iterations in the guarded form,
 * and holds a lock on a unit (a row) from before an update up to the next one (execute/hook.c): the
 * updates are indivisible for every operator and type, few of which have an instruction for that.
 */
#include "plan/methods/shares.h"

const struct method redcc_method_atomic = {.name = "atomic",
                                           .keeps = REDCC_ORDER_ANY,
                                           .locks = true,
                                           .owners = redcc_one_owner,
                                           .prepare = redcc_shares_prepare};
