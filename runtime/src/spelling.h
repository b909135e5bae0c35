/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What somebody may have meant who wrote a name that is not known. */
#ifndef REDCC_SPELLING_H
#define REDCC_SPELLING_H

#include <stddef.h>

/** How many letters to insert, remove or change to make one word of the other (Levenshtein 1966);
 *  of each the first 64 letters count. */
size_t redcc_spelling_distance(const char *a, const char *b);

/** Of `count` names (at least one) the nearest to `word`, the first of several. */
size_t redcc_spelling_nearest(const char *word, const char *const *names, size_t count);

#endif
