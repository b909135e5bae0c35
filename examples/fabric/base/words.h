/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Suggests a word for a misspelt one. */
#ifndef FABRIC_WORDS_H
#define FABRIC_WORDS_H

/**
 * Returns the nearest of the `count` words: the one with the fewest letters inserted, deleted,
 * replaced or swapped with a neighbour. Returns NULL if none is near enough. Thread-safe.
 */
const char *words_nearest(const char *word, const char *const *words, int count);

#endif
