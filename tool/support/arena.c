/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/arena.h"

#include <assert.h>
#include <stdalign.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK_SIZE = 1 << 16, ALIGNMENT = alignof(max_align_t) };

/* An object gets a block to itself if it does not fit into the one being filled and is larger
 * than a quarter of BLOCK_SIZE. */
typedef struct block {
    struct block *next;
    size_t size;
    size_t used;
    alignas(max_align_t) unsigned char bytes[];
} block;

struct arena {
    block *blocks; /* the first is the one being filled */
    size_t used;
};

static void *allocate_or_die(size_t size) {
    void *memory = calloc(1, size);
    if (memory == NULL) {
        fprintf(stderr, "redcc: out of memory (%zu bytes more are needed)\n", size);
        exit(EXIT_FAILURE);
    }
    return memory;
}

static block *add_block(arena *a, size_t size) {
    if (size > SIZE_MAX - sizeof(block))
        size = SIZE_MAX - sizeof(block); /* calloc fails, which ends the program with a message */
    block *b = allocate_or_die(sizeof(block) + size);
    b->size = size;
    b->next = a->blocks;
    a->blocks = b;
    return b;
}

/* Returns a block with room for `size` bytes. A large object gets a block of its own. This block is
 * linked after the one being filled, so that the remaining room in that one stays in use. */
static block *block_with_room(arena *a, size_t size) {
    block *filling = a->blocks;
    if (filling != NULL && size <= filling->size - filling->used)
        return filling;
    if (filling == NULL || size <= BLOCK_SIZE / 4)
        return add_block(a, size > BLOCK_SIZE ? size : BLOCK_SIZE);
    block *own = add_block(a, size);
    a->blocks = filling;
    own->next = filling->next;
    filling->next = own;
    return own;
}

arena *arena_new(void) {
    return allocate_or_die(sizeof(arena));
}

void *arena_allocate(arena *a, size_t size) {
    size_t padded =
        size <= SIZE_MAX - ALIGNMENT ? (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT : size;
    a->used += padded;
    block *b = block_with_room(a, padded);
    assert(padded >= size && padded <= b->size - b->used);
    void *memory = b->bytes + b->used;
    assert((uintptr_t)memory % ALIGNMENT == 0);
    b->used += padded;
    return memory;
}

void arena_free(arena *a) {
    if (a == NULL)
        return;
    for (block *b = a->blocks, *next; b != NULL; b = next) {
        next = b->next;
        free(b);
    }
    free(a);
}

void arena_clear(arena *a) {
    block *kept = NULL;
    for (block *b = a->blocks, *next; b != NULL; b = next) {
        next = b->next;
        if (kept == NULL && b->size == BLOCK_SIZE)
            kept = b;
        else
            free(b);
    }
    a->blocks = kept;
    a->used = 0;
    if (kept == NULL)
        return;
    kept->next = NULL;
    memset(kept->bytes, 0, kept->used);
    kept->used = 0;
}

size_t arena_used(const arena *a) {
    return a->used;
}

char *arena_copy(arena *a, const char *text, size_t length) {
    assert(text || length == 0);
    char *copy = arena_allocate(a, length + 1);
    if (length > 0)
        memcpy(copy, text, length);
    return copy;
}

char *arena_string(arena *a, const char *text) {
    return arena_copy(a, text, strlen(text));
}

char *arena_format(arena *a, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    assert(length >= 0);
    char *text = arena_allocate(a, length < 0 ? 1 : (size_t)length + 1);
    if (length > 0)
        vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    return text;
}
