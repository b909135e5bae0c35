/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How far two spellings are apart, to name the nearest valid word in a message. */
#ifndef NEAREST_H
#define NEAREST_H

#include <stddef.h>

/** Levenshtein's distance: how many letters must be inserted, dropped or changed. Of `to` the first
 *  64 letters count. */
size_t edit_distance(const char *from, const char *to);

#endif
