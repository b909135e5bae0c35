/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Attributes of functions that do not affect the meaning of their text. */
#ifndef SUPPORT_ATTRIBUTES_H
#define SUPPORT_ATTRIBUTES_H

#include <stdbool.h>
#include <stddef.h>

/** Is the attribute harmless: does it change neither the meaning nor the rounding of the function's
 * text, even if a part of the text is moved to another function? noinline, cold and unused are
 * harmless; target, optimize and unknown attributes are not. The name may have underscores around
 * it. */
bool attribute_is_harmless(const char *name, size_t length);

/** Is each attribute in the text of a function's head (from `at` to `end`, without its body) a
 *  harmless `__attribute__((...))`? True if the text has none; attributes that a macro spells are
 *  not seen. False for [[...]] and for anything unparsable. */
bool attributes_are_harmless(const char *at, const char *end);

#endif
