/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/attributes.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

#include "support/source.h"

bool attribute_is_harmless(const char *name, size_t length) {
    static const char *const harmless[] = {"aligned",    "cold",
                                           "flatten",    "hot",
                                           "noclone",    "noinline",
                                           "noipa",      "nonnull",
                                           "nothrow",    "returns_nonnull",
                                           "unused",     "used",
                                           "visibility", "warn_unused_result"};
    if (length > 4 && strncmp(name, "__", 2) == 0 && strncmp(name + length - 2, "__", 2) == 0) {
        name += 2;
        length -= 4;
    }
    for (size_t i = 0; i < sizeof harmless / sizeof *harmless; i++)
        if (strlen(harmless[i]) == length && memcmp(harmless[i], name, length) == 0)
            return true;
    return false;
}

static const char *skip_blanks(const char *at, const char *end) {
    while (at < end && isspace((unsigned char)*at))
        at++;
    return at;
}

/* Returns the position after an attribute's arguments, such as `(1, 2)` or `("default")`. Returns
 * NULL if the arguments are not only numbers and quoted words. */
static const char *skip_numbers(const char *at, const char *end) {
    if (at == end || *at != '(')
        return at;
    for (at++; at < end && *at != ')'; at++)
        if (*at == '"' && memchr(at + 1, '"', (size_t)(end - at - 1)))
            at = memchr(at + 1, '"', (size_t)(end - at - 1));
        else if (!isdigit((unsigned char)*at) && !isspace((unsigned char)*at) && *at != ',')
            return NULL;
    return at < end ? skip_blanks(at + 1, end) : NULL;
}

/* The position after a list such as `((noinline, cold))`. Returns NULL if not all of its attributes
 * are harmless. */
static const char *skip_harmless(const char *at, const char *end) {
    for (int open = 0; open < 2; open++) {
        at = skip_blanks(at, end);
        if (at == end || *at++ != '(')
            return NULL;
    }
    for (at = skip_blanks(at, end); at < end && *at != ')'; at = skip_blanks(at, end)) {
        const char *const name = at;
        while (at < end && source_is_name_byte(*at))
            at++;
        if (!attribute_is_harmless(name, (size_t)(at - name)))
            return NULL;
        at = skip_numbers(skip_blanks(at, end), end);
        if (!at || at == end || (*at != ',' && *at != ')'))
            return NULL;
        at += *at == ',';
    }
    at = at < end ? skip_blanks(at + 1, end) : end;
    return at < end && *at == ')' ? at + 1 : NULL;
}

bool attributes_are_harmless(const char *at, const char *end) {
    assert(at <= end);
    static const char word[] = "__attribute";
    while (at < end) {
        if (end - at >= 2 && strncmp(at, "[[", 2) == 0)
            return false;
        if ((size_t)(end - at) < sizeof word - 1 || strncmp(at, word, sizeof word - 1) != 0) {
            at++;
            continue;
        }
        at += sizeof word - 1;
        at += end - at >= 2 && strncmp(at, "__", 2) == 0 ? 2 : 0;
        at = skip_harmless(at, end);
        if (!at)
            return false;
    }
    return true;
}
