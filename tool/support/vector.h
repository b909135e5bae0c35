/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A growing array in an arena: VECTOR(ir_node *) children = {0}; VECTOR_PUSH(a, &children, node);
 * Growth copies; the old storage stays with the arena. VECTOR_PUSH evaluates its arguments several
 * times. Two uses of VECTOR(T) are different types.
 */
#ifndef SUPPORT_VECTOR_H
#define SUPPORT_VECTOR_H

#include <string.h>

#include "support/arena.h"

#define VECTOR(type)                                                                               \
    struct {                                                                                       \
        type *items;                                                                               \
        unsigned count;                                                                            \
        unsigned capacity;                                                                         \
    }

#define VECTOR_PUSH(a, vector, item)                                                               \
    do {                                                                                           \
        if ((vector)->count == (vector)->capacity)                                                 \
            (vector)->items =                                                                      \
                vector_grow((a), (vector)->items, sizeof *(vector)->items, &(vector)->capacity);   \
        (vector)->items[(vector)->count++] = (item);                                               \
    } while (0)

/** Doubles the storage (at least 8 items) and copies the old items. */
void *vector_grow(arena *a, const void *items, size_t item_size, unsigned *capacity);

#endif
