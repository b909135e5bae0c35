/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The C sources around a source, and which of them define and call what, by their text alone. It
 * may be wrong of macros and of unusual text: what is found is where to look, never a fact.
 */
#ifndef DRIVER_PROJECT_H
#define DRIVER_PROJECT_H

#include <stdbool.h>

#include "driver/digest.h"
#include "support/arena.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct project_function {
    const char *name;
    bool is_static;
    bool has_loop; /* in which something is written through a subscript, or updated */
    VECTOR(const char *) calls;
} project_function;

typedef struct project_file {
    const char *path;
    digest contents;
    VECTOR(project_function) functions;
} project_file;

typedef struct project {
    arena *memory;
    const char *own; /* the source that was asked about */
    VECTOR(project_file) files;
    map *definers; /* the name of an external function -> project_definers */
    map *called;   /* the name of what functions with loops of other files lead to -> not NULL */
} project;

/** The sources of the project that `path` is a source of: all below the outermost of the folders
 *  around it that hold a build's description. Of a project that is too large the source's own
 *  folder; without any files where that is too large too. */
project *project_around(arena *a, const char *path);

/** A file other than the source itself that defines an external function of this name. Of several
 *  the one that is called as the header which declares the function (NULL: none does), else one in
 *  the source's own folder, else the first. NULL: there is none. */
const char *project_definer(const project *p, const char *name, const char *header);

/** Of what the answers to questions about the source's functions, and what is read for it, depend
 *  on: of the files that define what it calls, and what these call, all bytes. */
digest project_digest(const project *p);

/** Does a function with a loop, in another file than the source itself, lead to this function? */
bool project_calls_in_loop(const project *p, const char *name);

#endif
