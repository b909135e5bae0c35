/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * All files that a preprocessor could read for a source, whatever branches it takes and in whatever
 * order it searches. A file in a search folder belongs to the closure if the source, or another
 * file of the closure, includes its name. If two closures are equal, so is the preprocessor's
 * input: the closure changes if a header appears, vanishes, moves or hides another header.
 */
#ifndef DRIVER_CLOSURE_H
#define DRIVER_CLOSURE_H

#include <stdbool.h>

#include "driver/digest.h"
#include "driver/lookups.h"
#include "driver/store.h"
#include "driver/words.h"
#include "support/map.h"

/** The starting points and the search path of a closure. */
typedef struct closure_request {
    const char *file;   /**< the source's bytes */
    const char *name;   /**< the source's name; its folder is searched for headers */
    word_list included; /**< the headers of -include and -imacros */
    word_list folders;  /**< the folders that are searched, in any order */
    word_list words;    /**< the command, which may define macros */
} closure_request;

typedef struct closure {
    const char *unknown; /**< the reason why the closure is unknown, or NULL if it is known */
    digest state;        /**< digest of names, contents, and of which names lead to the same file */
    map *files;          /**< devices and inodes of the files */
} closure;

/** Finds the closure. If no file has changed since it was last found, no file is read. */
closure closure_find(arena *a, const store *kept, const closure_request *request);

/** Returns whether `path` is one of the closure's files. */
bool closure_has(const closure *c, const char *path);

#endif
