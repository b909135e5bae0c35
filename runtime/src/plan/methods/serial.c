/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** serial: executes the sequential loop itself. */
#include "plan/method.h"

const struct method redcc_method_serial = {.name = "serial", .keeps = REDCC_ORDER_SERIAL};
