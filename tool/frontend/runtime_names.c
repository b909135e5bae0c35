/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Searches the program, its headers and its options for names that begin with redcc_ or REDCC_, the
 * prefixes of the runtime's names. The output includes the runtime's header, whose macros could
 * change what such a name means, for example in an #if. Branches that are not compiled and the
 * strings of _Pragma are searched too. */
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "frontend/flags.h"

/* Does a line splice follow directly after a byte of a name? */
static bool splits_name(file_text file) {
    const char *at = file.text, *const end = file.text + file.length;
    while ((at = memchr(at, '\\', (size_t)(end - at))) != NULL) {
        const unsigned length = splice_length(at, end);
        if (length > 0 && at > file.text && source_is_name_byte(at[-1]))
            return true;
        at++;
    }
    return false;
}

static file_text without_splices(converter *c, file_text file) {
    char *copy = arena_allocate(c->arena, file.length + 1);
    size_t length = 0;
    for (const char *at = file.text, *const end = at + file.length; at < end;) {
        const unsigned splice = splice_length(at, end);
        if (splice == 0)
            copy[length++] = *at++;
        at += splice;
    }
    copy[length] = 0;
    return (file_text){copy, length};
}

static void note(converter *c, const char *word, size_t length) {
    static const char *const beginnings[] = {"redcc_", "REDCC_"};
    for (unsigned i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        if (length >= strlen(beginnings[i]) && source_starts_with(word, beginnings[i]))
            VECTOR_PUSH(c->arena, &c->headers.runtime_names, arena_copy(c->arena, word, length));
}

static void note_names(converter *c, const char *at, const char *end) {
    while (at < end) {
        const char *const word = at;
        while (at < end && source_is_name_byte(*at))
            at++;
        note(c, word, (size_t)(at - word));
        at += at == word;
    }
}

/* Is the string at `at` the operand of _Pragma? */
static bool is_of_pragma(const char *begin, const char *at) {
    static const char operator[] = "_Pragma";
    const size_t length = sizeof operator- 1;
    while (at > begin && (source_is_name_byte(at[-1]) || strchr(" \t\r\n(", at[-1]))) {
        if ((size_t)(at - begin) >= length && memcmp(at - length, operator, length) == 0)
            return true;
        at--;
    }
    return false;
}

static void search(converter *c, file_text file) {
    if (file.length > 0 && splits_name(file))
        file = without_splices(c, file);
    if (!text_has(file, "redcc_") && !text_has(file, "REDCC_"))
        return;
    const char *at = file.text, *const end = file.text + file.length, *begin = at;
    while (at < end) {
        const char *next = piece_end(at, end);
        const bool is_comment = *at == '/' && next - at > 1;
        if (is_comment || *at == '"' || *at == '\'') {
            const bool is_searched = *at == '"' && is_of_pragma(file.text, at);
            note_names(c, begin, is_searched ? next : at);
            begin = next;
        }
        at = next;
    }
    note_names(c, begin, end);
}

static void visit(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    (void)depth;
    search(data, text_of_file(data, file));
}

void find_runtime_names(converter *c) {
    for (unsigned i = 0; i < c->compiler.flags->items.count; i++) {
        const char *flag = c->compiler.flags->items.items[i];
        note_names(c, flag, flag + strlen(flag));
    }
    clang_getInclusions(c->clang, visit, c);
    c->unit->text.runtime_name_count = c->headers.runtime_names.count;
    c->unit->text.runtime_names = c->headers.runtime_names.items;
}
