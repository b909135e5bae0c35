/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Whether a text asks which compiler it is compiled by. redcc reads a source as clang does; where
 * gcc takes the other branch of an #if, what was proved would be proved of another program.
 */
#ifndef DRIVER_IDENTITY_H
#define DRIVER_IDENTITY_H

#include <stdbool.h>

#include "driver/words.h"

/** The macro by which `text` asks for something that libclang and the compiler may answer
 *  differently, NULL where there is none. Conditions on version and name that come out the same
 * for clang (which says it is gcc 4.2) and for gcc from 5 on are none. `is_clang`: the compiler is
 * a clang, perhaps of another version than libclang. */
const char *identity_asked(arena *a, const char *text, bool is_clang);

/** The same for the files of a list that are the user's: headers below /usr/include and /usr/lib
 * are taken to mean the same to every compiler. Some text, too, where a file cannot be read. */
const char *identity_asked_in(arena *a, const word_list *files, bool is_clang);

#endif
