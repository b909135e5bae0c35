/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * All files that a preprocessor could read for a source, whichever branches it takes and in
 * whatever order it searches: every file that goes by a name which the source or such a file
 * includes, in every folder that may be searched. Where two closures are equal, all that a
 * preprocessor sees is: a header that appears, vanishes, moves or hides another one makes another
 * closure.
 */
#ifndef DRIVER_CLOSURE_H
#define DRIVER_CLOSURE_H

#include <stdbool.h>

#include "driver/digest.h"
#include "driver/words.h"
#include "support/map.h"

/** Where to begin and to look. */
typedef struct closure_request {
    const char *file;   /**< the source's bytes */
    const char *name;   /**< what it is called; headers are looked for in this name's folder */
    word_list included; /**< of -include and -imacros */
    word_list folders;  /**< that are searched, in any order */
    word_list words;    /**< of the command, which may define macros */
} closure_request;

typedef struct closure {
    const char *unknown; /**< why it cannot be said; NULL: it can */
    digest state;        /**< of names, contents and which of them are one file */
    map *files;          /**< their devices and inodes */
} closure;

closure closure_find(arena *a, const closure_request *request);

/** Whether `path` is one of its files. */
bool closure_has(const closure *c, const char *path);

#endif
