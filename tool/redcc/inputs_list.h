/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc --inputs-file: what a translation was made of, for who keeps translations. */
#ifndef INPUTS_LIST_H
#define INPUTS_LIST_H

#include "frontend/frontend.h"

/** Writes a list to `path`: one letter and a path an entry, each with a 0 behind it. `l`: a shared
 *  library that this program was loaded with; `d`: a folder where the parser looks for headers
 *  whatever the flags; `f`: a file that was read. Returns NULL, or in the arena why it could not be
 *  written. */
const char *inputs_list_write(arena *a, const char *path, const frontend_result *parsed);

#endif
