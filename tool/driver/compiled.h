/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiles a translated source, or takes the object from the cache (cache.h), so that a repeated
 * build does not compile the longer text again. */
#ifndef DRIVER_COMPILED_H
#define DRIVER_COMPILED_H

#include "driver/translate.h"

/** Compiles the translated text by the command `words` to `object` (NULL: the command's own
 * output). Returns the exit status. Sets *same to true if the compiler read the same headers as
 * for the source (translation_read_same), and to false if it did not or the compilation failed. */
int compiled_text(session *s, const translation *t, const word_list *words, const char *object,
                  process_streams streams, bool *same);

/** Has the compiler write the dependency file that the command asks for, for the source itself.
 *  Returns the exit status. */
int compiled_dependencies(session *s, const translation *t, const word_list *words);

#endif
