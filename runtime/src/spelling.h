/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Suggests the closest known name. */
#ifndef REDCC_SPELLING_H
#define REDCC_SPELLING_H

#include <stddef.h>

/** Levenshtein distance (1966), the number of letters to insert, remove or change, of the words'
 * first 64 letters. */
size_t redcc_spelling_distance(const char *a, const char *b);

/** The index of the name nearest to `word` among `count` >= 1 names; of several the first. */
size_t redcc_spelling_nearest(const char *word, const char *const *names, size_t count);

#endif
