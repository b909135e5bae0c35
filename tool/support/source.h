/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One source file's bytes and the offsets of its lines. */
#ifndef SUPPORT_SOURCE_H
#define SUPPORT_SOURCE_H

#include <stdbool.h>
#include <stdint.h>

#include "support/arena.h"
#include "support/map.h"

typedef struct source {
    const char *path; /* as the user gave it */
    const char *text; /* the file's bytes (with BOM, CRLF) and a 0 */
    uint32_t length;
    uint32_t line_count;
    const uint32_t *line_begin; /* [line_count] offsets */
} source;

typedef struct position {
    unsigned line;   /* from 1 */
    unsigned column; /* from 1, in bytes */
} position;

/** Reads a file ("-": standard input). Returns NULL, and a message in *message, if the file cannot
 * be read, is a directory, or has 4 GiB or more. */
source *source_read(arena *a, const char *path, const char **message);
source *source_from_text(arena *a, const char *path, const char *text, size_t length);
position source_position(const source *s, uint32_t offset);
/** Returns the offset after the string or character constant that begins at `from`. If the constant
 *  is not terminated, returns the end of its line or `to`. */
uint32_t source_skip_quoted(const source *s, uint32_t from, uint32_t to);

/** The first offset in [from, to) of something other than blanks, comments and spliced line ends;
 *  `to` if there is none. */
uint32_t source_skip_blanks(const source *s, uint32_t from, uint32_t to);
/** Is the byte part of a name in all compilers: a letter, a digit or `_`? */
bool source_is_word_byte(char c);
/** May the byte be part of a name: letters, digits, `_`, and by compiler extension `$` and the
 *  bytes of UTF-8? */
bool source_is_name_byte(char c);
/** Returns the first name in [text, end) that is a key of `names`, and stores its length in
 * *length. Returns NULL if there is none. Comments and strings are text like any other. */
const char *source_find_name(const char *text, const char *end, const map *names, size_t *length);
/** Does the name occur in text[0 .. length), not merely as a part of a longer name? */
bool source_has_name(const char *text, size_t length, const char *name);
/** Like source_has_name, for a search that must not miss the word. A `$` or a byte of UTF-8 next to
 * it may belong to no name (-fno-dollars-in-identifiers), so the word counts as found there,
 * too. */
bool source_has_word(const char *text, size_t length, const char *word);
/** Are the texts equal, or both NULL? */
bool source_same_text(const char *a, const char *b);
bool source_starts_with(const char *text, const char *prefix);
bool source_ends_with(const char *text, const char *suffix);

#endif
