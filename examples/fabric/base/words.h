/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Suggests a word for a misspelt one. */
#ifndef FABRIC_WORDS_H
#define FABRIC_WORDS_H

/**
 * The nearest of the `count` words: fewest letters inserted, left out, exchanged for another or
 * swapped with their neighbour. NULL if none is near enough. Thread-safe.
 */
const char *words_nearest(const char *word, const char *const *words, int count);

#endif
