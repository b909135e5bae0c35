/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Who answers the questions of a call, the translator and the compiler: which programs they are,
 *  and where they look for headers. */
#ifndef DRIVER_ANSWERERS_H
#define DRIVER_ANSWERERS_H

#include "driver/cache.h"
#include "driver/closure.h"
#include "driver/store.h"

/** Whether $REDCC_OPTS holds nothing but options whose only effect is on the translation itself. */
bool answerers_options_are_plain(const word_list *options);

/** Finds out, or remembers, who they are; NULL where one is a script or cannot be asked.
 */
struct cache *answerers_find(session *s, const store *kept);

/** Where the answers are kept. */
const store *answerers_store(const session *s);

/** The program that answers, by contents. */
const digest *answerers_identity(const session *s, cache_program program);

/** Adds all folders in which headers of the command's sources may be looked for, and the headers
 *  that are included without being named in a source. Returns why they cannot be known, or NULL. */
const char *answerers_add_folders(session *s, closure_request *request);

#endif
