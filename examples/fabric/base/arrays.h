/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Arrays that share an owner: allocated one by one, freed together. */
#ifndef FABRIC_ARRAYS_H
#define FABRIC_ARRAYS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct arrays {
    struct array_link *last;
    bool failed; /* an allocation has failed */
} arrays;

/** Allocates `count` items of `size` bytes, all 0. Returns NULL and sets `failed` if out of
 *  memory. */
void *arrays_add(arrays *of, size_t count, size_t size);

/** Frees all arrays of the owner. */
void arrays_free(arrays *of);

/** Grows a single array to at least `count` items of `size` bytes. `address` is the address of its
 *  pointer, and *room is its capacity in items. Returns 0, or -1 if out of memory or if `count`
 *  exceeds INT_MAX; the array is then unchanged. */
int array_grow(void *address, int *room, long count, size_t size);

#endif
