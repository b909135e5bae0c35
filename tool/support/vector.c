/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/vector.h"

#include <assert.h>
#include <limits.h>

void *vector_grow(arena *a, const void *items, size_t item_size, unsigned *capacity) {
    unsigned old = *capacity;
    assert(item_size > 0 && (items || old == 0) && old <= UINT_MAX / 2);
    *capacity = old < 4 ? 8 : old * 2;
    void *grown = arena_allocate(a, item_size * *capacity);
    if (old > 0)
        memcpy(grown, items, item_size * old);
    return grown;
}
