/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "arrays.h"

#include <assert.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/** Header in front of each array. Its alignment makes the array suitable for any type. */
typedef struct array_link {
    _Alignas(max_align_t) struct array_link *before;
} array_link;

void *arrays_add(arrays *of, size_t count, size_t size) {
    assert(size > 0);
    const size_t most = (SIZE_MAX - sizeof(array_link)) / size;
    array_link *added = count <= most ? calloc(1, sizeof *added + count * size) : NULL;
    if (!added) {
        of->failed = true;
        return NULL;
    }
    added->before = of->last;
    of->last = added;
    return added + 1;
}

void arrays_free(arrays *of) {
    while (of->last) {
        array_link *before = of->last->before;
        free(of->last);
        of->last = before;
    }
}

int array_grow(void *address, int *room, long count, size_t size) {
    assert(count >= 0 && *room >= 0 && size > 0);
    const long more = count + count / 8 + 16, wanted = more < INT_MAX ? more : INT_MAX;
    void *array;
    memcpy(&array, address, sizeof array);
    if (array && count <= *room)
        return 0;
    void *grown = count <= INT_MAX ? realloc(array, (size_t)wanted * size) : NULL;
    if (!grown)
        return -1;
    memcpy(address, &grown, sizeof grown);
    *room = (int)wanted;
    return 0;
}
