/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Suggests the known name that is closest to a misspelt one. */
#ifndef REDCC_SPELLING_H
#define REDCC_SPELLING_H

#include <stddef.h>

/** The number of letters to insert, remove or change that turn one word into the other (Levenshtein
 * distance, 1966). Considers only the first 64 letters of each word. */
size_t redcc_spelling_distance(const char *a, const char *b);

/** The index, among `count` >= 1 names, of the name nearest to `word`. If several are equally near,
 * it is the first of them. */
size_t redcc_spelling_nearest(const char *word, const char *const *names, size_t count);

#endif
