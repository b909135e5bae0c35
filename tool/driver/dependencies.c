/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/dependencies.h"

#include <ctype.h>
#include <string.h>

#include "driver/files.h"
#include "support/source.h"

static const char *without_dot_slash(const char *path) {
    while (path[0] == '.' && path[1] == '/') {
        path += 2;
        while (*path == '/')
            path++;
    }
    return path;
}

/* Reads one file name of a rule: "\ " is a space, "\#" a '#', "$$" a '$'. */
static const char *read_name(const char *text, buffer *name) {
    while (*text && !isspace((unsigned char)*text)) {
        if (text[0] == '\\' && (text[1] == ' ' || text[1] == '#' || text[1] == '\t'))
            text++;
        else if (text[0] == '\\' && text[1] == '\n')
            break;
        else if (text[0] == '$' && text[1] == '$')
            text++;
        buffer_byte(name, *text++);
    }
    return text;
}

bool dependencies_read(arena *a, const char *path, word_list *list) {
    const char *text = file_read(a, path, NULL);
    const char *colon = text ? strstr(text, ": ") : NULL;
    if (!colon)
        return false;
    text = colon + 1;
    while (*text && *text != '\n') {
        if (text[0] == '\\' && text[1] == '\n')
            text += 2;
        if (*text == ' ' || *text == '\t') {
            text++;
            continue;
        }
        if (!*text || *text == '\n')
            break;
        buffer name = {0};
        text = read_name(text, &name);
        if (name.length > 0)
            words_add(a, list, without_dot_slash(arena_copy(a, name.data, name.length)));
        buffer_free(&name);
    }
    return list->count > 0;
}

static bool is_listed(const word_list *list, const char *name) {
    for (unsigned i = 0; i < list->count; i++)
        if (strcmp(list->items[i], name) == 0)
            return true;
    return false;
}

/* Does the name end like that of a header of the runtime which only translated text includes? */
static bool is_the_runtimes(const char *name) {
    static const char *const headers[] = {
        "/redcc/bins.h",   "/redcc/crew.h",   "/redcc/entry.h",    "/redcc/lanes.h",
        "/redcc/loop.h",   "/redcc/blocks.h", "/redcc/prefetch.h", "/redcc/runtime.h",
        "/redcc/series.h", "/redcc/slice.h",  "/redcc/steps.h",    "/redcc/structures.h",
        "/redcc/tiles.h",
    };
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++)
        if (source_ends_with(name, headers[i]))
            return true;
    return false;
}

/* Returns the headers in a list, without the source itself, the runtime's headers, and repetitions.
 * gcc lists a header twice if it finds it by two paths that differ only in a leading "./". */
static word_list headers_of(arena *a, const word_list *list, const char *path) {
    word_list headers = {0};
    const char *itself = without_dot_slash(path);
    for (unsigned i = 0; i < list->count; i++) {
        const char *name = list->items[i];
        if (strcmp(name, itself) != 0 && !is_the_runtimes(name) && !is_listed(&headers, name))
            words_add(a, &headers, name);
    }
    return headers;
}

bool dependencies_equal(arena *a, const word_list *original, const char *path,
                        const word_list *translated, const char *text) {
    word_list left = headers_of(a, original, path);
    word_list right = headers_of(a, translated, text);
    if (left.count != right.count)
        return false;
    for (unsigned i = 0; i < left.count; i++)
        if (strcmp(left.items[i], right.items[i]) != 0)
            return false;
    return true;
}

bool dependencies_mention(arena *a, const word_list *files, const char *word) {
    for (unsigned i = 0; i < files->count; i++) {
        size_t length;
        const char *text = file_read(a, files->items[i], &length);
        if (!text || source_has_word(text, length, word))
            return true;
    }
    return false;
}

/* The name in the #line directive that ends at `end`. */
static const char *named_by_line(arena *a, const char *text, const char *end) {
    static const char begins[] = "#line 1 \"";
    const char *line = end;
    while (line > text && line[-1] != '\n')
        line--;
    line += strspn(line, " \t");
    if (strncmp(line, begins, sizeof begins - 1) != 0 || end[-1] != '"')
        return NULL;
    line += sizeof begins - 1;
    return line < end ? without_dot_slash(arena_copy(a, line, (size_t)(end - 1 - line))) : NULL;
}

word_list dependencies_included(arena *a, const word_list *list, const char *text) {
    word_list in_place = {0}, others = {0};
    for (const char *at = text; (at = strstr(at, DEPENDENCY_IN_PLACE)); at++) {
        const char *name = named_by_line(a, text, at);
        if (name)
            words_add(a, &in_place, name);
    }
    for (unsigned i = 0; i < list->count; i++)
        if (!is_listed(&in_place, list->items[i]))
            words_add(a, &others, list->items[i]);
    return others;
}
