/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/node.h"

#include "base/system.h"

#include <stdatomic.h>
#include <string.h>

/* Does the machine have several NUMA nodes? Most have one. This is checked first, because querying
 * the thread's node takes a hundredth of a short loop's time. */
static bool has_several(void) {
    char text[8] = "";
#if defined(__linux__)
    redcc_system_read_text("/sys/devices/system/node/possible", text, sizeof text);
#endif
    return strcmp(text, "0\n") != 0;
}

int redcc_node(void) {
    enum { UNKNOWN, ONE, SEVERAL };
    static atomic_int known;
    if (atomic_load_explicit(&known, memory_order_relaxed) == UNKNOWN)
        atomic_store_explicit(&known, has_several() ? SEVERAL : ONE, memory_order_relaxed);
    return atomic_load_explicit(&known, memory_order_relaxed) == ONE ? 0 : redcc_system_node();
}
