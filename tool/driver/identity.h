/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Detects a text that tests which compiler compiles it. redcc parses a source as clang does. If gcc
 * takes the other branch of an #if, redcc's analysis does not describe the program that gcc
 * compiles.
 */
#ifndef DRIVER_IDENTITY_H
#define DRIVER_IDENTITY_H

#include <stdbool.h>

#include "driver/words.h"

/** Returns the macro by which `text` tests a property on which libclang and the compiler may
 *  differ, or NULL. Conditions on the compiler's version and name are ignored if they have the same
 *  value for clang (which claims to be gcc 4.2) and for all versions of gcc from 5 on. `is_clang`:
 *  the compiler is clang, perhaps of another version than libclang. */
const char *identity_asked(arena *a, const char *text, bool is_clang);

/** Like identity_asked, for the user's files in a list: headers below /usr/include and /usr/lib are
 * assumed to mean the same to every compiler. Returns another text if a file cannot be read. */
const char *identity_asked_in(arena *a, const word_list *files, bool is_clang);

#endif
