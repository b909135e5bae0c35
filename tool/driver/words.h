/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lists of words: command lines, response files, options in the environment. */
#ifndef DRIVER_WORDS_H
#define DRIVER_WORDS_H

#include <stdbool.h>

#include "support/arena.h"
#include "support/buffer.h"
#include "support/vector.h"

/** A list that grows in an arena; the words are borrowed or live there too. */
typedef VECTOR(const char *) word_list;

void words_add(arena *a, word_list *list, const char *word);
void words_add_all(arena *a, word_list *list, const word_list *more);

/** The list for execvp: its items, then NULL. */
char **words_argv(arena *a, const word_list *list);

/** Adds the words of `text`, separated by white space, quoted with ' or ", or by a backslash, much
 *  as in a shell. */
void words_split(arena *a, const char *text, word_list *list);

/** Adds `count` words, but replaces each word @FILE by the words in the file. As in gcc, a
 * backslash quotes the next character even in single quotes, and @FILE is added unchanged if the
 * file cannot be read. Returns whether any word was replaced. */
bool words_expand(arena *a, unsigned count, char *const *given, word_list *list);

/** Writes the words to `path` as a response file. Returns false on failure. */
bool words_write(const word_list *list, const char *path);

/** Appends one word in a form that a shell reads back. */
void word_for_shell(buffer *b, const char *word);

#endif
