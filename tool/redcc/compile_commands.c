/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* realpath */
#include "redcc/compile_commands.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "driver/words.h"
#include "support/compiler_options.h"

/** The path, joined to `folder` unless it is absolute. */
static const char *joined(arena *a, const char *folder, const char *path) {
    return path[0] == '/' ? path : arena_format(a, "%s/%s", folder, path);
}

static bool same_file(const char *left, const char *right) {
    char *left_path = realpath(left, NULL);
    char *right_path = realpath(right, NULL);
    const bool same = left_path && right_path && strcmp(left_path, right_path) == 0;
    free(left_path);
    free(right_path);
    return same;
}

/* ---- the words of a command ---------------------------------------------------------------- */

static word_list words_of(arena *a, const json_t *entry) {
    word_list words = {0};
    const json_t *arguments = json_object_get(entry, "arguments");
    const char *command = json_string_value(json_object_get(entry, "command"));
    for (size_t i = 0; i < json_array_size(arguments); i++) {
        const char *word = json_string_value(json_array_get(arguments, i));
        if (word)
            words_add(a, &words, arena_string(a, word));
    }
    if (!arguments && command)
        words_split(a, arena_string(a, command), &words);
    return words;
}

/* ---- flags --------------------------------------------------------------------------------- */

/** Does the option only select the last stage of the compilation, or outputs? */
static bool is_about_output(const option *known) {
    return strcmp(known->name, "-o") == 0 ||
           known->meaning & (OPTION_NO_LINK | OPTION_NO_OBJECT | OPTION_DEPENDENCY);
}

/** Adds the option words[*i], with its paths made relative to the current folder. */
static void add_option(arena *a, const word_list *words, unsigned *i, const char *directory,
                       string_list *flags) {
    const char *word = words->items[*i];
    const option *known = option_find(word);
    const unsigned meaning = known ? known->meaning : 0;
    const bool is_alone = known && strcmp(word, known->name) == 0;
    const char *value = NULL;
    if (is_alone && meaning & OPTION_ARGUMENT && *i + 1 < words->count)
        value = words->items[++*i];
    if (known && is_about_output(known))
        return;
    if (meaning & OPTION_PATH && !is_alone) {
        const size_t length = strlen(known->name);
        word = arena_format(a, "%s%s", known->name, joined(a, directory, word + length));
    }
    if (meaning & OPTION_LIBERTY) { /* redcc-cc compiles translated text without such options */
        for (const char *const *rest = option_without_liberty(word); *rest; rest++)
            VECTOR_PUSH(a, flags, *rest);
        return;
    }
    VECTOR_PUSH(a, flags, word);
    if (value)
        VECTOR_PUSH(a, flags, meaning & OPTION_PATH ? joined(a, directory, value) : value);
}

static void add_flags(arena *a, const word_list *words, const char *directory, const char *input,
                      string_list *flags) {
    for (unsigned i = 1; i < words->count; i++) { /* the first is the compiler */
        const char *word = words->items[i];
        if (strcmp(word, "--") == 0)
            continue;
        if (word[0] == '-' && word[1])
            add_option(a, words, &i, directory, flags);
        else if (!same_file(joined(a, directory, word), input))
            VECTOR_PUSH(a, flags, word);
    }
}

static bool is_entry_of(arena *a, const json_t *entry, const char *input, const char **directory) {
    const char *folder = json_string_value(json_object_get(entry, "directory"));
    const char *file = json_string_value(json_object_get(entry, "file"));
    *directory = folder ? arena_string(a, folder) : ".";
    return file && same_file(joined(a, *directory, file), input);
}

/** The database, or NULL, with a message in *wrong, if it cannot be read. */
static json_t *load(arena *a, const char *path, const char **wrong) {
    json_error_t error;
    json_t *root = json_load_file(path, 0, &error);
    if (!root)
        *wrong = error.line > 0
                     ? arena_format(a, "%s:%d:%d: %s", path, error.line, error.column, error.text)
                     : arena_format(a, "%s", error.text);
    return root;
}

const char *compile_commands_flags(arena *a, const char *folder, const char *input,
                                   string_list *flags) {
    const char *path = arena_format(a, "%s/compile_commands.json", folder);
    const char *wrong = NULL;
    json_t *root = load(a, path, &wrong);
    if (!root)
        return wrong;
    wrong = arena_format(a, "%s has no command for '%s'", path, input);
    for (size_t i = 0; i < json_array_size(root); i++) {
        const json_t *entry = json_array_get(root, i);
        const char *directory;
        if (!is_entry_of(a, entry, input, &directory))
            continue;
        const word_list words = words_of(a, entry);
        add_flags(a, &words, joined(a, folder, directory), input, flags);
        wrong = NULL;
        break;
    }
    json_decref(root);
    return wrong;
}

const char *compile_commands_of_c(arena *a, const char *folder, compile_command_list *commands) {
    const char *path = arena_format(a, "%s/compile_commands.json", folder);
    const char *wrong = NULL;
    json_t *root = load(a, path, &wrong);
    for (size_t i = 0; root && i < json_array_size(root); i++) {
        const json_t *entry = json_array_get(root, i);
        const char *directory = json_string_value(json_object_get(entry, "directory"));
        const char *file = json_string_value(json_object_get(entry, "file"));
        const size_t length = file ? strlen(file) : 0;
        if (length <= 2 || strcmp(file + length - 2, ".c") != 0)
            continue;
        const char *from = joined(a, folder, directory ? arena_string(a, directory) : ".");
        const compile_command command = {joined(a, from, arena_string(a, file)), from,
                                         words_of(a, entry)};
        VECTOR_PUSH(a, commands, command);
    }
    if (root)
        json_decref(root);
    return wrong;
}
