/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Suggests the known name that is closest to a misspelt one. */
#ifndef REDCC_SPELLING_H
#define REDCC_SPELLING_H

#include <stddef.h>

/** The number of letters to insert, remove or change to make one word of the other (Levenshtein
 * distance, 1966). Only the first 64 letters of each word count. */
size_t redcc_spelling_distance(const char *a, const char *b);

/** The index of the name nearest to `word` among `count` >= 1 names. If several are equally near,
 * returns the first. */
size_t redcc_spelling_nearest(const char *word, const char *const *names, size_t count);

#endif
