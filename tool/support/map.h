/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A hash table from bytes to pointers, in an arena. Entries are never removed. */
#ifndef SUPPORT_MAP_H
#define SUPPORT_MAP_H

#include <stddef.h>

#include "support/arena.h"

typedef struct map map;

map *map_new(arena *a);
/** A pointer to the value, which is NULL for a new key; valid until the next call. Keys are
 *  copied. */
void **map_at(map *m, const void *key, size_t length);
/** The value, or NULL. */
void *map_get(const map *m, const void *key, size_t length);

#endif
