/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which headers a text may include, or ask for, whatever its conditions come to. */
#ifndef DRIVER_INCLUDE_NAMES_H
#define DRIVER_INCLUDE_NAMES_H

#include <stdbool.h>

#include "driver/words.h"

typedef struct include_names {
    word_list quoted; /**< "x.h": looked for in the folder of the text first */
    word_list angled; /**< <x.h> */
    word_list macros; /**< NAME: includes nothing as long as no such macro is defined */
    const char *text; /**< the text itself, spliced lines joined */
} include_names;

/** Adds the names in `length` bytes of text, each at least once, and perhaps some that stand in
 *  comments. Returns NULL; or why the text does not say it all: the name is made by a macro that a
 *  compiler may define by itself, the text is not the same at every time (__TIME__), it has
 * trigraphs that may hide a directive. */
const char *include_names_find(arena *a, const char *text, size_t length, include_names *names);

/** Whether the text, spliced lines joined, may define the macro: its name stands elsewhere than
 * behind `defined`, `ifdef`, `ifndef`, `undef` and `include`. */
bool include_names_may_define(const char *text, const char *macro);

#endif
