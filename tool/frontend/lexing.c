/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for memmem */
#include "frontend/lexing.h"

#include <assert.h>
#include <stdbool.h>
#include <string.h>

#include "frontend/directives.h"
#include "support/source.h"

static const char raw_string[] = "R\"", pragma_operator[] = "_Pragma";

/* The beginning of the word that ends at `end`. */
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

/* Does the quote begin a raw string: R"delimiter( with a delimiter of at most 16 bytes? The prefix
 * must be a whole word, because the text -R" may end an ordinary string. */
static bool begins_raw_string(const char *text, const char *quote, const char *end) {
    enum { LONGEST_DELIMITER = 16 };
    const char *at = quote + 1;
    while (at < end && at - quote <= LONGEST_DELIMITER && !strchr("() \\\t\v\f\n", *at))
        at++;
    if (at == end || *at != '(')
        return false;
    static const char *const prefixes[] = {"R", "LR", "uR", "UR", "u8R"};
    const char *word = word_before(text, quote);
    return is_one_of(word, (size_t)(quote - word), prefixes, sizeof prefixes / sizeof *prefixes);
}

/* Is the backslash followed by one or more blanks and then the line's end? */
static bool is_blank_splice(const char *backslash, const char *end) {
    const char *at = backslash + 1;
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\f' || *at == '\v'))
        at++;
    return at > backslash + 1 && at < end && (*at == '\n' || *at == '\r');
}

/* Returns the construct that the splice may divide, judging by the word before the splice: _Pragma,
 * or a raw string if the word is a prefix of one. NULL if it is neither. */
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

/* The byte after the splice and after any splices that directly follow it. */
static char byte_behind(const char *splice, const char *end) {
    for (unsigned length; (length = splice_length(splice, end)) > 0;)
        splice += length;
    return splice < end ? *splice : 0;
}

/* Does the byte end a block comment, according to a scan from the beginning of the text? The answer
 * is also false if a digit separator (a quote between digits) precedes the byte, because a scanner
 * may then take code for a character constant, or the reverse. */
static bool ends_comment(const char *text, const char *last) {
    const char *at = text, *begin = text;
    while (at <= last) {
        begin = at;
        at = piece_end(at, last + 1);
    }
    return last - begin >= 3 && memcmp(begin, "/*", 2) == 0 && memcmp(last - 1, "*/", 2) == 0 &&
           !lexing_has_digit_separator(text, (size_t)(last - text));
}

/* Does the splice divide a token of two bytes (a comment's mark, a digraph) or a trigraph? */
static bool splits_mark(const char *text, const char *splice, const char *end) {
    const char before = splice > text ? splice[-1] : 0, behind = byte_behind(splice, end);
    return (before == '/' && (behind == '/' || behind == '*') && !ends_comment(text, splice - 1)) ||
           (before == '*' && behind == '/') || (before == '%' && behind == ':') || before == '?';
}

/* Does the text contain pieces from which a macro may paste _Pragma: a proper prefix such as
 * `_Prag`, or both `_` and `Pragma`? */
static bool has_pieces_of_pragma(const char *text, size_t length) {
    static const char *const firsts[] = {"_P", "_Pr", "_Pra", "_Prag", "_Pragm"};
    for (size_t i = 0; i < sizeof firsts / sizeof *firsts; i++)
        if (source_has_name(text, length, firsts[i]))
            return true;
    return source_has_name(text, length, "_") && source_has_name(text, length, "Pragma");
}

bool lexing_has_digit_separator(const char *text, size_t length) {
    const char *end = text + length;
    for (const char *at = text; (at = memchr(at, '\'', (size_t)(end - at))); at++) {
        const char *word = word_before(text, at);
        if (word < at && *word >= '0' && *word <= '9' && at + 1 < end && source_is_name_byte(at[1]))
            return true;
    }
    return false;
}

const char *lexing_in_doubt(const char *text, size_t length) {
    assert(text);
    const char *end = text + length;
    if (memmem(text, length, "?\?/", 3))
        return "?\?/";
    if (has_pieces_of_pragma(text, length))
        return pragma_operator;
    /* directives of C23, which a compiler of an older standard may ignore or obey */
    static const char *const conditions[] = {"elifdef", "elifndef"};
    for (size_t i = 0; i < sizeof conditions / sizeof *conditions; i++)
        if (source_has_name(text, length, conditions[i]))
            return conditions[i];
    for (const char *at = text; (at = memchr(at, '"', (size_t)(end - at))); at++)
        if (begins_raw_string(text, at, end))
            return raw_string;
    for (const char *at = text; (at = memchr(at, '\\', (size_t)(end - at))); at++) {
        if (is_blank_splice(at, end))
            return "a backslash and blanks";
        if (splice_length(at, end) == 0)
            continue;
        const char *split = split_word(text, at);
        if (split)
            return split;
        if (splits_mark(text, at, end))
            return "a mark in two lines";
    }
    return NULL;
}
