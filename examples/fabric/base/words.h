/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The word that a misspelt one was probably meant to be. */
#ifndef FABRIC_WORDS_H
#define FABRIC_WORDS_H

/**
 * The nearest of the `count` words: fewest letters inserted, left out, exchanged for another or
 * swapped with their neighbour. NULL when none is near enough to be meant. Thread-safe.
 */
const char *words_nearest(const char *word, const char *const *words, int count);

#endif
