/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* getcpu */
#include "base/node.h"

#include <sched.h>

#if defined(__linux__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 29)
#define KNOWS_NODE 1
#endif
#endif

int redcc_node(void) {
#ifdef KNOWS_NODE
    unsigned processor, node;
    if (getcpu(&processor, &node) == 0)
        return (int)node;
#endif
    return -1;
}
