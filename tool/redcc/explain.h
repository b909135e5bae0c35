/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc --explain: the text of docs/reasons.md on a reason, which is built in. */
#ifndef EXPLAIN_H
#define EXPLAIN_H

#include "support/arena.h"

/** The section, with its heading, on the reason with this id ("R204") or slug
 * ("private-not-proved"), in the arena. Returns NULL if there is no such reason. */
const char *explain_section(arena *a, const char *reason);

/** The URI of the section on the reason with this id, in the arena: below the URI that redcc was
 * built with (REDCC_DOCUMENTS_URI), else in the installed file. Returns NULL if there is none. */
const char *explain_link(arena *a, const char *reason);

/** Suggests the closest known reason for `word`: "the nearest is R204 private-not-proved", or
 *  several reasons whose slugs contain the word. */
const char *explain_nearest(arena *a, const char *word);

/** All reasons, one per line: id and slug. */
const char *explain_list(arena *a);

/** The location of docs/refused.md, as explain_link, or NULL if there is none. */
const char *explain_page(arena *a);

#endif
