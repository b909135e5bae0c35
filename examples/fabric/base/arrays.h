/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Arrays of one owner: allocated one by one, freed together. */
#ifndef FABRIC_ARRAYS_H
#define FABRIC_ARRAYS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct arrays {
    struct array_link *last;
    bool failed; /* an allocation has failed */
} arrays;

/** `count` items of `size` bytes, all 0. NULL without memory: then `failed` is set. */
void *arrays_add(arrays *of, size_t count, size_t size);

/** Frees all. */
void arrays_free(arrays *of);

/** Grows a single array, given by the address of its pointer, to at least `count` items of `size`
 *  bytes; *room is its capacity. 0, or -1: out of memory, and the array is unchanged. */
int array_grow(void *address, int *room, long count, size_t size);

#endif
