/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Records which files a search found and which it did not find. The record shows later, without
 * reading a file, whether the search would find the same files again. A file counts as unchanged if
 * its device, inode, size and both times are the same. A missing file counts as still missing while
 * its folder is unchanged. A file that changed shortly before the search began may change again
 * without a new time, so it makes the record invalid. Not thread-safe.
 */
#ifndef DRIVER_LOOKUPS_H
#define DRIVER_LOOKUPS_H

#include <stdbool.h>
#include <sys/stat.h>

#include "driver/store.h"

typedef struct lookups lookups;

/** Begins a search. */
lookups *lookups_new(arena *a);

/** Records that the search has tried `path`. `about` is the status (stat) of the file that it found
 * there, or NULL if it found none. */
void lookups_note(lookups *l, const char *path, const struct stat *about);

/** Records that the search depends on something that cannot be recorded: the record is invalid. */
void lookups_spoil(lookups *l);

/** Returns the record in *part, to be stored; false if it is invalid. */
bool lookups_write(lookups *l, store_part *part);

/** Returns whether a recorded search would find the same now; for each plain file that it found,
 * `found` is called. */
bool lookups_hold(arena *a, const store_part *part,
                  void (*found)(void *data, const struct stat *about), void *data);

#endif
