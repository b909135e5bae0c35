/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A hash table from bytes to pointers, in an arena. Entries are never removed. */
#ifndef SUPPORT_MAP_H
#define SUPPORT_MAP_H

#include <stddef.h>

#include "support/arena.h"

typedef struct map map;

map *map_new(arena *a);
/** Returns a pointer to the key's value. A new key is copied and added with the value NULL. The
 *  pointer is valid until the next call of map_at. */
void **map_at(map *m, const void *key, size_t length);
/** The key's value; NULL if there is no such key. */
void *map_get(const map *m, const void *key, size_t length);

#endif
