/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Edit distance of two spellings, to suggest the nearest valid word in a message. */
#ifndef NEAREST_H
#define NEAREST_H

#include <stddef.h>

/** Levenshtein distance: the number of letters to insert, drop or change. Counts the first 64
 *  letters of `to`. */
size_t edit_distance(const char *from, const char *to);

#endif
