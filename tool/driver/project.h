/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The C sources around a source, with the functions that they define and call, found by their text
 * alone. Macros and unusual text may mislead it: a result says only which file to read, and is
 * never used as a fact.
 */
#ifndef DRIVER_PROJECT_H
#define DRIVER_PROJECT_H

#include <stdbool.h>

#include "driver/digest.h"
#include "driver/words.h"
#include "support/arena.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct project_function {
    const char *name;
    bool is_static;
    bool has_loop; /* it contains a loop, and an update or an assignment to an element */
    VECTOR(const char *) calls;
} project_function;

typedef struct project_file {
    const char *path;
    digest contents;
    VECTOR(project_function) functions;
} project_file;

typedef VECTOR(project_file) project_scan;

typedef struct project {
    arena *memory;
    const char *own; /* the source about which the queries below ask */
    project_scan files;
    map *definers; /* the name of an external function -> project_definers */
    map *called;   /* the names of functions called, directly or not, from functions with loops in
                    * other files -> not NULL */
} project;

/** Lists the sources of the project that contains `path`: all below the outermost enclosing folder
 * with a build description or a repository. If there are too many, lists those below the outermost
 * folder around the source that does not have too many; otherwise those in the source's own folder,
 * or none. */
word_list project_list(arena *a, const char *path);

/** Reads these files, except for those that cannot be read. */
project_scan project_scan_files(arena *a, const word_list *files);

/** The project of a source, from its files. */
project *project_from(arena *a, const char *path, const project_scan *files);

/** Calls project_list, project_scan_files and project_from, one after the other. The files get no
 *  digests, so project_digest must not be called. */
project *project_around(arena *a, const char *path);

/** A file other than the source that defines an external function of this name. Among several, the
 * one named like the header that declares the function (NULL: none does), else one in the source's
 * own folder, else the first. Returns NULL if there is none. */
const char *project_definer(const project *p, const char *name, const char *header);

/** A digest of all that queries about the source's functions depend on: the bytes of files that
 * define their direct and indirect callees, and which of the functions loops call. */
digest project_digest(const project *p);

/** Does a function with a loop, in another file than the source itself, call this function,
 *  directly or not? */
bool project_calls_in_loop(const project *p, const char *name);

#endif
