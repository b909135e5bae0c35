/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* memmem */
#include "frontend/lexing.h"

#include <stdbool.h>
#include <string.h>

#include "frontend/directives.h"
#include "support/source.h"

static const char raw_string[] = "R\"", pragma_operator[] = "_Pragma";

/* The word that ends at `end`. */
static const char *word_before(const char *text, const char *end) {
    while (end > text && source_is_name_byte(end[-1]))
        end--;
    return end;
}

static bool is_one_of(const char *word, size_t length, const char *const *words, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (strlen(words[i]) == length && memcmp(words[i], word, length) == 0)
            return true;
    return false;
}

static bool begins_raw_string(const char *text, const char *quote) {
    static const char *const prefixes[] = {"R", "LR", "uR", "UR", "u8R"};
    const char *word = word_before(text, quote);
    return is_one_of(word, (size_t)(quote - word), prefixes, sizeof prefixes / sizeof *prefixes);
}

/* A backslash with nothing but blanks, of which there are some, to the line's end. */
static bool is_blank_splice(const char *backslash, const char *end) {
    const char *at = backslash + 1;
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\f' || *at == '\v'))
        at++;
    return at > backslash + 1 && at < end && (*at == '\n' || *at == '\r');
}

/* What goes on in the next line: _Pragma, a raw string's prefix; NULL: neither, as far as the
 * word's beginning tells. */
static const char *split_word(const char *text, const char *splice) {
    static const char *const prefixes[] = {"R", "L", "LR", "u", "uR", "U", "UR", "u8", "u8R"};
    const char *word = word_before(text, splice);
    const size_t length = (size_t)(splice - word);
    if (length > 0 && length < sizeof pragma_operator &&
        strncmp(word, pragma_operator, length) == 0)
        return pragma_operator;
    return is_one_of(word, length, prefixes, sizeof prefixes / sizeof *prefixes) ? raw_string
                                                                                 : NULL;
}

const char *lexing_in_doubt(const char *text, size_t length) {
    const char *end = text + length;
    if (memmem(text, length, "?\?/", 3))
        return "?\?/";
    for (const char *at = text; (at = memchr(at, '"', (size_t)(end - at))); at++)
        if (begins_raw_string(text, at))
            return raw_string;
    for (const char *at = text; (at = memchr(at, '\\', (size_t)(end - at))); at++) {
        if (is_blank_splice(at, end))
            return "a backslash and blanks";
        const char *split = splice_length(at, end) > 0 ? split_word(text, at) : NULL;
        if (split)
            return split;
    }
    return NULL;
}
