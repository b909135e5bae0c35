/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/words.h"

#include <assert.h>
#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "driver/files.h"

enum { RESPONSE_FILES_MAX = 2000 }; /* gcc's own limit against recursive response files */

void words_add(arena *a, word_list *list, const char *word) {
    assert(word);
    VECTOR_PUSH(a, list, word);
}

void words_add_all(arena *a, word_list *list, const word_list *more) {
    for (unsigned i = 0; i < more->count; i++)
        words_add(a, list, more->items[i]);
}

char **words_argv(arena *a, const word_list *list) {
    char **argv = ARENA_ARRAY(a, char *, list->count + 1);
    for (unsigned i = 0; i < list->count; i++)
        argv[i] = arena_string(a, list->items[i]);
    return argv;
}

/* Reads one word that begins at `text`, and returns its end. A backslash quotes the next character.
 * In a shell (is_shell), it does not do so between single quotes. */
static const char *read_word(const char *text, bool is_shell, buffer *word) {
    char quote = 0;
    for (; *text && (quote || !isspace((unsigned char)*text)); text++) {
        if (*text == '\\' && !(is_shell && quote == '\'') && text[1])
            buffer_byte(word, *++text);
        else if (quote && *text == quote)
            quote = 0;
        else if (!quote && (*text == '\'' || *text == '"'))
            quote = *text;
        else
            buffer_byte(word, *text);
    }
    return text;
}

static void split(arena *a, const char *text, bool is_shell, word_list *list) {
    for (;;) {
        while (isspace((unsigned char)*text))
            text++;
        if (!*text)
            return;
        buffer word = {0};
        text = read_word(text, is_shell, &word);
        words_add(a, list, word.data ? arena_copy(a, word.data, word.length) : "");
        buffer_free(&word);
    }
}

void words_split(arena *a, const char *text, word_list *list) {
    split(a, text, true, list);
}

static bool expand_word(arena *a, const char *word, word_list *list, unsigned *files) {
    struct stat about;
    char *text = NULL;
    if (word[0] == '@' && *files < RESPONSE_FILES_MAX && stat(word + 1, &about) == 0 &&
        S_ISREG(about.st_mode))
        text = file_read(a, word + 1, NULL);
    if (!text) {
        words_add(a, list, word);
        return false;
    }
    ++*files;
    word_list inner = {0};
    split(a, text, false, &inner);
    for (unsigned i = 0; i < inner.count; i++)
        expand_word(a, inner.items[i], list, files);
    return true;
}

bool words_expand(arena *a, unsigned count, char *const *given, word_list *list) {
    bool any = false;
    unsigned files = 0;
    for (unsigned i = 0; i < count; i++)
        any |= expand_word(a, given[i], list, &files);
    return any;
}

bool words_write(const word_list *list, const char *path) {
    FILE *file = fopen(path, "w");
    if (!file)
        return false;
    for (unsigned i = 0; i < list->count; i++) {
        fputc('"', file);
        for (const char *c = list->items[i]; *c; c++) {
            if (*c == '"' || *c == '\\')
                fputc('\\', file);
            fputc(*c, file);
        }
        fputs("\"\n", file);
    }
    bool good = !ferror(file);
    return fclose(file) == 0 && good;
}

void word_for_shell(buffer *b, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+=./,:@%^";
    if (*word && strspn(word, plain) == strlen(word)) {
        buffer_text(b, word);
        return;
    }
    buffer_byte(b, '\'');
    for (; *word; word++)
        if (*word == '\'')
            buffer_text(b, "'\\''");
        else
            buffer_byte(b, *word);
    buffer_byte(b, '\'');
}
