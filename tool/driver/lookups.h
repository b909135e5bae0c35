/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which files a search has found, and which it has not: to know later, without reading a file, that
 * it would find the same again. A file that is there counts as the same if its device, inode, size
 * and both times are; one that is not there counts as missing while its folder has not changed.
 * What changed shortly before the search began may change again without a new time: such files
 * spoil the record. Not thread-safe.
 */
#ifndef DRIVER_LOOKUPS_H
#define DRIVER_LOOKUPS_H

#include <stdbool.h>
#include <sys/stat.h>

#include "driver/store.h"

typedef struct lookups lookups;

/** Begins a search. */
lookups *lookups_new(arena *a);

/** `path` was looked for: `about` of what was found; NULL: nothing. */
void lookups_note(lookups *l, const char *path, const struct stat *about);

/** The search depends on something that is not recorded. */
void lookups_spoil(lookups *l);

/** The record, to be stored; false if it is spoilt. */
bool lookups_write(lookups *l, store_part *part);

/** Whether a recorded search would find the same now; for each plain file that it found, `found` is
 *  called. */
bool lookups_hold(arena *a, const store_part *part,
                  void (*found)(void *data, const struct stat *about), void *data);

#endif
