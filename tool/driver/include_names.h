/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The headers that a text may include or test for, for any values of its conditions. */
#ifndef DRIVER_INCLUDE_NAMES_H
#define DRIVER_INCLUDE_NAMES_H

#include <stdbool.h>

#include "driver/words.h"

typedef struct include_names {
    word_list quoted; /**< "x.h": searched in the folder of the text first */
    word_list angled; /**< <x.h> */
    word_list macros; /**< macros in place of a name; without a definition they include nothing */
    const char *text; /**< the text itself, with spliced lines joined */
} include_names;

/** Adds the names that `length` bytes of text include, each at least once, and perhaps some names
 * from comments. Returns NULL, or why the list is incomplete: a name comes from a macro that a
 * compiler may predefine, the text changes with time (__TIME__), or trigraphs may hide a
 * directive. */
const char *include_names_find(arena *a, const char *text, size_t length, include_names *names);

/** Returns whether the text, with spliced lines joined, may define the macro: its name occurs other
 * than after `defined`, `ifdef`, `ifndef`, `undef` and `include`. */
bool include_names_may_define(const char *text, const char *macro);

#endif
