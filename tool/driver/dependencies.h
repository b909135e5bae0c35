/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What a source includes, from the files that -M and -MD write. The translated text is compiled
 * from another folder than the source; comparing the two lists proves that the compiler read the
 * same headers all the same.
 */
#ifndef DRIVER_DEPENDENCIES_H
#define DRIVER_DEPENDENCIES_H

#include <stdbool.h>

#include "driver/words.h"

/** Adds the prerequisites of the first rule in `path`, in their order, a leading "./" left out.
 *  Returns false where the file cannot be read or holds no rule. */
bool dependencies_read(arena *a, const char *path, word_list *list);

/** Whether both sources read the same files, but for the sources themselves (the first of each)
 *  and the runtime's header. */
bool dependencies_equal(arena *a, const word_list *original, const char *path,
                        const word_list *translated, const char *text);

/** Whether `word` stands, by itself, in any of the files, or one of them cannot be read. */
bool dependencies_mention(arena *a, const word_list *files, const char *word);

#endif
