/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Attributes of functions that say nothing of what their text means. */
#ifndef SUPPORT_ATTRIBUTES_H
#define SUPPORT_ATTRIBUTES_H

#include <stdbool.h>
#include <stddef.h>

/** Does an attribute of this name leave alone what the function's text means, and how it rounds,
 *  also where a part of the text stands in another function? Such are noinline, cold and unused,
 *  not so target, optimize or anything that is unknown. With or without underscores around it. */
bool attribute_is_harmless(const char *name, size_t length);

/** Are all attributes in the text, from `at` to `end`, a function's head without its body, harmless
 *  ones, each written out as `__attribute__((...))`? True where there is none. What is not
 *  understood is not harmless. */
bool attributes_are_harmless(const char *at, const char *end);

#endif
