/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A folder of entries that processes share: each a file named after its key, written beside and
 * renamed, so that readers see a whole entry or none, without locks. What is not as it was written
 * is no entry.
 */
#ifndef DRIVER_STORE_H
#define DRIVER_STORE_H

#include <stdbool.h>

#include "driver/digest.h"
#include "support/arena.h"

typedef struct store {
    const char *folder; /**< NULL: there is none */
    uint64_t limit;     /**< bytes that entries may take, about */
} store;

typedef struct store_part {
    const char *bytes;
    size_t length;
} store_part;

/** The folder that $REDCC_CACHE names, else redcc below $XDG_CACHE_HOME or ~/.cache; created where
 *  it is missing. No folder where REDCC_CACHE says off, where it cannot be created or is another
 *  user's. The limit is $REDCC_CACHE_SIZE (bytes, with K, M or G), else 1 GiB. What is wrong with
 *  either variable is left in *wrong, in the arena. */
store store_open(arena *a, const char **wrong);

/** Fetches an entry of `count` parts into the arena; false where there is none. */
bool store_get(arena *a, const store *s, const digest *key, unsigned count, store_part *parts);

/** Keeps an entry; where the limit is exceeded, those that were not used for longest go. Does
 *  nothing where there is no room, or the folder cannot be written. */
void store_put(arena *a, const store *s, const digest *key, unsigned count,
               const store_part *parts);

#endif
