/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Identifies the programs whose answers are cached (the translator and the compiler), and the
 * folders in which they search for headers. */
#ifndef DRIVER_ANSWERERS_H
#define DRIVER_ANSWERERS_H

#include "driver/cache.h"
#include "driver/closure.h"
#include "driver/store.h"

/** Returns whether $REDCC_OPTS contains only options that affect nothing but the translation. */
bool answerers_options_are_plain(const word_list *options);

/** Identifies the programs, from the cache if possible; NULL if one is a script or cannot be
 * queried. */
struct cache *answerers_find(session *s, const store *kept);

/** The store of the cached results. */
const store *answerers_store(const session *s);

/** The identity of the program, a digest of its contents. */
const digest *answerers_identity(const session *s, cache_program program);

/** Adds to the digest the contents of the assembler that the compiler runs. Returns false if the
 * assembler is unknown. */
bool answerers_add_assembler(session *s, digester *d);

/** Adds to the request all folders that are searched for headers of the command's sources, and the
 * headers that the command includes (-include) although no source names them. Returns NULL, or the
 * reason why the folders or headers are unknown. */
const char *answerers_add_folders(session *s, closure_request *request);

#endif
