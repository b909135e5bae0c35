/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "node.h"

#include "system.h"

int redcc_node(void) {
    return redcc_system_node();
}
