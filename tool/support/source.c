/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* memmem */
#include "support/source.h"

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "support/buffer.h"

static uint32_t count_lines(const char *text, size_t length) {
    uint32_t count = 1;
    const char *end = text + length;
    for (const char *at = text; at < end && (at = memchr(at, '\n', (size_t)(end - at))); at++)
        count++;
    return count;
}

/* Makes a source that refers to `text`, which must be in the arena, without copying it. */
static source *make_source(arena *a, const char *path, const char *text, size_t length) {
    assert(length <= UINT32_MAX && text[length] == 0);
    source *s = ARENA_NEW(a, source);
    s->path = arena_string(a, path);
    s->text = text;
    s->length = (uint32_t)length;
    s->line_count = count_lines(text, length);
    uint32_t *begin = ARENA_ARRAY(a, uint32_t, s->line_count);
    uint32_t line = 0;
    const char *end = text + length;
    for (const char *at = text; at < end && (at = memchr(at, '\n', (size_t)(end - at))); at++)
        begin[++line] = (uint32_t)(at - text) + 1;
    assert(line + 1 == s->line_count);
    s->line_begin = begin;
    return s;
}

source *source_from_text(arena *a, const char *path, const char *text, size_t length) {
    return make_source(a, path, arena_copy(a, text, length), length);
}

/* Appends the stream's bytes. Stops when they are too many for a source. Returns NULL, or the error
 * message. */
static const char *read_all(buffer *bytes, FILE *stream) {
    char piece[1 << 14];
    size_t count;
    while (bytes->length <= UINT32_MAX && (count = fread(piece, 1, sizeof piece, stream)) > 0)
        buffer_append(bytes, piece, count);
    if (ferror(stream))
        return strerror(errno);
    return bytes->length > UINT32_MAX ? "the file is too large (4 GiB or more)" : NULL;
}

static source *read_stream(arena *a, const char *path, FILE *stream, const char **message) {
    struct stat status;
    if (fstat(fileno(stream), &status) == 0 && S_ISDIR(status.st_mode)) {
        *message = arena_format(a, "%s: is a directory", path);
        return NULL;
    }
    buffer bytes = {0};
    const char *problem = read_all(&bytes, stream);
    source *s = NULL;
    if (problem != NULL)
        *message = arena_format(a, "%s: %s", path, problem);
    else
        s = source_from_text(a, path, bytes.data, bytes.length);
    buffer_free(&bytes);
    return s;
}

source *source_read(arena *a, const char *path, const char **message) {
    if (strcmp(path, "-") == 0)
        return read_stream(a, path, stdin, message);
    FILE *stream = fopen(path, "rb");
    if (stream == NULL) {
        *message = arena_format(a, "%s: %s", path, strerror(errno));
        return NULL;
    }
    source *s = read_stream(a, path, stream, message);
    fclose(stream);
    return s;
}

position source_position(const source *s, uint32_t offset) {
    assert(offset <= s->length);
    uint32_t low = 0, high = s->line_count; /* line_begin[low] <= offset < line_begin[high] */
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (s->line_begin[middle] <= offset)
            low = middle;
        else
            high = middle;
    }
    assert(s->line_begin[low] <= offset);
    return (position){.line = low + 1, .column = offset - s->line_begin[low] + 1};
}

/** The offset after the comment that begins at `at`. */
static uint32_t skip_comment(const source *s, uint32_t at) {
    const char *text = s->text; /* ends in 0: looking one byte ahead is safe */
    if (text[at + 1] == '*') {
        const char *close = strstr(text + at + 2, "*/");
        return close ? (uint32_t)(close + 2 - text) : (uint32_t)s->length;
    }
    while (at < s->length && text[at] != '\n')
        at += text[at] == '\\' && at + 1 < s->length ? 2 : 1;
    return at;
}

uint32_t source_skip_blanks(const source *s, uint32_t from, uint32_t to) {
    assert(to <= s->length);
    while (from < to) {
        const char *at = s->text + from;
        if (at[0] == '\\' && (at[1] == '\n' || at[1] == '\r'))
            from += 2;
        else if (at[0] == '/' && (at[1] == '/' || at[1] == '*'))
            from = skip_comment(s, from);
        else if (isspace((unsigned char)*at))
            from++;
        else
            return from;
    }
    return to;
}

uint32_t source_skip_quoted(const source *s, uint32_t from, uint32_t to) {
    assert(from < to && to <= s->length);
    const char quote = s->text[from++];
    while (from < to && s->text[from] != quote && s->text[from] != '\n')
        from += s->text[from] == '\\' && from + 1 < to ? 2 : 1;
    return from < to ? from + 1 : to;
}

bool source_is_word_byte(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool source_is_name_byte(char c) {
    return source_is_word_byte(c) || c == '$' || (unsigned char)c >= 0x80;
}

bool source_same_text(const char *a, const char *b) {
    return a == b || (a && b && strcmp(a, b) == 0);
}

bool source_starts_with(const char *text, const char *prefix) {
    return strncmp(text, prefix, strlen(prefix)) == 0;
}

bool source_ends_with(const char *text, const char *suffix) {
    const size_t length = strlen(text), size = strlen(suffix);
    return length >= size && strcmp(text + length - size, suffix) == 0;
}

const char *source_find_name(const char *text, const char *end, const map *names, size_t *length) {
    assert(text <= end);
    for (const char *at = text; at < end; at++) {
        const char *word = at;
        while (at < end && source_is_name_byte(*at))
            at++;
        *length = (size_t)(at - word);
        if (*length > 0 && map_get(names, word, *length))
            return word;
    }
    return NULL;
}

static bool has_between(const char *text, size_t length, const char *word, bool (*is_part)(char)) {
    const size_t size = strlen(word);
    const char *end = text + length;
    for (const char *at = text; (at = memmem(at, (size_t)(end - at), word, size)); at++)
        if ((at == text || !is_part(at[-1])) && (at + size == end || !is_part(at[size])))
            return true;
    return false;
}

bool source_has_name(const char *text, size_t length, const char *name) {
    return has_between(text, length, name, source_is_name_byte);
}

bool source_has_word(const char *text, size_t length, const char *word) {
    return has_between(text, length, word, source_is_word_byte);
}
