/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A folder of entries that processes share. Each entry is a file named after its key, written under
 * a temporary name and renamed, so that readers see a whole entry or none, without locks. A corrupt
 * entry counts as missing.
 */
#ifndef DRIVER_STORE_H
#define DRIVER_STORE_H

#include <stdbool.h>

#include "driver/digest.h"
#include "support/arena.h"

typedef struct store {
    const char *folder; /**< NULL: there is none */
    uint64_t limit;     /**< approximate limit of the entries' total size in bytes */
} store;

typedef struct store_part {
    const char *bytes;
    size_t length;
} store_part;

/** Opens the folder that $REDCC_CACHE names, else redcc below $XDG_CACHE_HOME or ~/.cache; creates
 * it if missing. There is no folder if REDCC_CACHE is off or a relative path, or if the folder
 * cannot be created, belongs to another user, or can be written by all users. The limit is
 * $REDCC_CACHE_SIZE (bytes, with K, M or G), else 1 GiB. A message about an invalid variable is
 * left in *wrong, in the arena. */
store store_open(arena *a, const char **wrong);

/** Reads an entry of `count` parts into the arena; false if there is none. */
bool store_get(arena *a, const store *s, const digest *key, unsigned count, store_part *parts);

/** Stores an entry; if the limit is exceeded, the least recently used ones are removed. Does
 *  nothing if the disk is full, or the folder cannot be written. */
void store_put(arena *a, const store *s, const digest *key, unsigned count,
               const store_part *parts);

#endif
