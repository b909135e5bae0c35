/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/distributed.h"

#include <assert.h>

static void exchange(const ir_node *old, ir_node *new) {
    bool is_found = false;
    for (unsigned i = 0; i < old->parent->child_count; i++)
        if (old->parent->children[i] == old) {
            old->parent->children[i] = new;
            is_found = true;
        }
    assert(is_found);
    (void)is_found;
}

void distributed_take_out(const distribution *stores) {
    for (unsigned i = 0; stores && i < stores->count; i++)
        exchange(stores->stores[i].statement, stores->stores[i].rest);
}

void distributed_put_back(const distribution *stores) {
    for (unsigned i = 0; stores && i < stores->count; i++)
        exchange(stores->stores[i].rest, stores->stores[i].statement);
}
