/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc --inputs-file: the files on which a translation depends, for caches of translations. */
#ifndef INPUTS_LIST_H
#define INPUTS_LIST_H

#include "frontend/frontend.h"

/** Writes a list to `path`: for each entry one letter and a path, followed by a 0. `l`: a shared
 *  library loaded with this program; `d`: a folder that the parser searches for headers with any
 *  flags; `f`: a file that was read. Returns NULL, or a message in the arena. */
const char *inputs_list_write(arena *a, const char *path, const frontend_result *parsed);

#endif
