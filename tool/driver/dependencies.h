/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A source's includes, from the files that -M and -MD write. The translated text is compiled from
 * another folder than the source. If the lists of both are equal, the compiler read the same
 * headers for both.
 */
#ifndef DRIVER_DEPENDENCIES_H
#define DRIVER_DEPENDENCIES_H

#include <stdbool.h>

#include "driver/words.h"

/** Adds the prerequisites of the first rule in `path`, in their order, without a leading "./".
 *  Returns false if the file cannot be read or holds no rule. */
bool dependencies_read(arena *a, const char *path, word_list *list);

/** Returns whether both sources read the same files, except for the sources themselves (the first
 * of each) and the runtime's headers. */
bool dependencies_equal(arena *a, const word_list *original, const char *path,
                        const word_list *translated, const char *text);

/** Returns whether any of the files contains `word` as a whole word, or cannot be read. */
bool dependencies_mention(arena *a, const word_list *files, const char *word);

/** The comment that follows a #line directive where a translated text contains a header's text in
 *  place of its #include directive. */
#define DEPENDENCY_IN_PLACE " /* redcc: in place of its #include */"

/** The list without the headers whose text the translated text contains in place. */
word_list dependencies_included(arena *a, const word_list *list, const char *text);

#endif
