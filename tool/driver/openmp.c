/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/openmp.h"

#include <ctype.h>
#include <string.h>

#include "driver/files.h"

static bool is_name_byte(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

static const char *skip_blanks(const char *at) {
    return at + strspn(at, " \t");
}

/* Behind `word`, where it stands at `at` as a whole word; NULL: it does not. */
static const char *after_word(const char *at, const char *word) {
    const size_t length = strlen(word);
    return strncmp(at, word, length) == 0 && !is_name_byte(at[length]) ? at + length : NULL;
}

static bool is_openmp_pragma(const char *line) {
    const char *at = skip_blanks(line);
    if (*at != '#')
        return false;
    at = after_word(skip_blanks(at + 1), "pragma");
    return at && after_word(skip_blanks(at), "omp");
}

/* A line marker, # 12 "file" 1 3: says whether what follows is of a system header (flag 3). */
static bool is_marker(const char *line, bool *of_system) {
    const char *at = skip_blanks(line);
    if (*at != '#')
        return false;
    at = skip_blanks(at + 1);
    if (!isdigit((unsigned char)*at))
        return false;
    const char *end = at + strcspn(at, "\n");
    const char *quote = end;
    while (quote > at && *quote != '"')
        quote--;
    *of_system = memchr(quote, '3', (size_t)(end - quote)) != NULL;
    return true;
}

/* Behind a string or character constant that begins at `at`. */
static const char *after_constant(const char *at) {
    const char quote = *at++;
    while (*at && *at != quote && *at != '\n')
        at += at[0] == '\\' && at[1] ? 2 : 1;
    return *at == quote ? at + 1 : at;
}

/* The next line of the text at `at` that says something: no marker, not blank; "" at the end. */
static const char *next_line(const char *at) {
    bool of_system;
    while (*at && (is_marker(at, &of_system) || *skip_blanks(at) == '\n'))
        at += strcspn(at, "\n"), at += *at == '\n';
    return at;
}

/* Are two preprocessed texts the same? Their markers may differ: clang counts its own macros. */
static bool is_same_text(const char *left, const char *right) {
    for (;;) {
        left = next_line(left);
        right = next_line(right);
        const size_t length = strcspn(left, "\n");
        if (strcspn(right, "\n") != length || memcmp(left, right, length) != 0)
            return false;
        if (!*left || !*right)
            return *left == *right;
        left += length;
        right += length;
    }
}

static bool line_names_openmp(const char *at) {
    while (*at && *at != '\n') {
        if (*at == '"' || *at == '\'') {
            at = after_constant(at);
            continue;
        }
        if (!is_name_byte(*at)) {
            at++;
            continue;
        }
        if (strncmp(at, "omp_", 4) == 0)
            return true;
        while (is_name_byte(*at))
            at++;
    }
    return false;
}

const char *openmp_in_text(const char *text) {
    bool of_system = false;
    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        if (is_marker(line, &of_system))
            continue;
        if (is_openmp_pragma(line))
            return "it has OpenMP pragmas, and OpenMP is off (-fopenmp turns it on)";
        if (!of_system && line_names_openmp(line))
            return "it uses names of OpenMP's library (omp_...), and OpenMP is off (-fopenmp "
                   "turns it on)";
    }
    return NULL;
}

/* Preprocesses the source into a file. */
static bool preprocess(session *s, const item *source, bool with_openmp, const char *to) {
    arena *a = s->memory;
    word_list words = {0};
    words_add_all(a, &words, &s->real.bare);
    if (with_openmp && !s->real.is_clang && !(s->command.meaning & OPTION_THREADS))
        words_add(a, &words, "-U_REENTRANT"); /* as the translated text is compiled */
    command_add_options(a, &words, &s->command,
                        OPTION_NO_LINK | OPTION_DEPENDENCY | OPTION_LINKER | OPTION_AUXILIARY);
    if (with_openmp)
        words_add(a, &words, "-fopenmp");
    static const char *const rest[] = {"-E", "-x", "c"};
    for (unsigned i = 0; i < sizeof rest / sizeof *rest; i++)
        words_add(a, &words, rest[i]);
    words_add(a, &words, source->text);
    return session_run(s, &words, (process_streams){s->input, to, "/dev/null"}) == 0;
}

const char *openmp_would_change(session *s, const item *source, const char *scratch_folder) {
    const char *without = arena_format(s->memory, "%s/without-openmp", scratch_folder);
    const char *with = arena_format(s->memory, "%s/with-openmp", scratch_folder);
    if (!preprocess(s, source, false, without) || !preprocess(s, source, true, with))
        return "it mentions OpenMP, and cannot be preprocessed with it";
    size_t length, other_length;
    const char *text = file_read(s->memory, without, &length);
    const char *other = file_read(s->memory, with, &other_length);
    if (!text || !other || strlen(text) != length || strlen(other) != other_length)
        return "it mentions OpenMP, and its preprocessed text cannot be read";
    if (!is_same_text(text, other))
        return "its text is another with OpenMP, which is off (-fopenmp turns it on)";
    return openmp_in_text(text);
}
