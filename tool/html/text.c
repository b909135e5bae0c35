/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "html/text.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static const char replacement[] = "\xEF\xBF\xBD"; /* U+FFFD */

/* The character at `at`; *length is its number of bytes, or 0 if the bytes are not UTF-8. */
static uint32_t decode(const unsigned char *at, size_t room, size_t *length) {
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t count = *at < 0x80   ? 1
                         : *at < 0xC2 ? 0
                         : *at < 0xE0 ? 2
                         : *at < 0xF0 ? 3
                         : *at < 0xF5 ? 4
                                      : 0;
    *length = 0;
    if (count == 0 || count > room)
        return 0;
    uint32_t character = count == 1 ? *at : *at & (0xFFu >> (count + 1));
    for (size_t i = 1; i < count; i++) {
        if ((at[i] & 0xC0) != 0x80)
            return 0;
        character = character << 6 | (at[i] & 0x3F);
    }
    if (character < least[count] || (character >= 0xD800 && character < 0xE000) ||
        character > 0x10FFFF)
        return 0;
    *length = count;
    return character;
}

static bool is_utf8(const unsigned char *bytes, size_t length) {
    for (size_t at = 0, count; at < length; at += count) {
        decode(bytes + at, length - at, &count);
        if (count == 0)
            return false;
    }
    return true;
}

static bool is_allowed(uint32_t character) {
    return character == '\t' || character == '\n' ||
           (character >= 0x20 && !(character >= 0x7F && character < 0xA0) && character != 0xFFFE &&
            character != 0xFFFF);
}

static void add_character(buffer *out, uint32_t character, const char *bytes, size_t length) {
    static const char special[] = "&<>\"'";
    static const char *const names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    const char *found = character && character < 0x80 ? strchr(special, (int)character) : NULL;
    if (!is_allowed(character))
        buffer_text(out, replacement);
    else if (found)
        buffer_text(out, names[found - special]);
    else
        buffer_append(out, bytes, length);
}

void html_bytes(buffer *out, const char *bytes, size_t length) {
    const unsigned char *text = (const unsigned char *)bytes;
    const bool decoded = is_utf8(text, length);
    for (size_t at = 0, count = 1; at < length; at += count) {
        if (decoded) {
            const uint32_t character = decode(text + at, length - at, &count);
            add_character(out, character, bytes + at, count);
            continue;
        }
        const char two[] = {(char)(0xC0 | text[at] >> 6), (char)(0x80 | (text[at] & 0x3F))};
        if (text[at] < 0x80)
            add_character(out, text[at], bytes + at, 1);
        else
            add_character(out, text[at], two, 2);
    }
}

void html_text(buffer *out, const char *text) {
    html_bytes(out, text, strlen(text));
}

/* Appends a paragraph, in which text between backquotes is code. */
static void add_paragraph(buffer *out, const char *text, size_t length) {
    bool in_code = false;
    buffer_text(out, "<p>");
    for (const char *end = text + length; text < end;) {
        const char *quote = memchr(text, '`', (size_t)(end - text));
        const char *stop = quote ? quote : end;
        html_bytes(out, text, (size_t)(stop - text));
        if (quote)
            buffer_text(out, in_code ? "</code>" : "<code>");
        in_code ^= quote != NULL;
        text = stop + 1;
    }
    buffer_text(out, in_code ? "</code></p>\n" : "</p>\n");
}

/* Appends the block of code that begins at `at` with "```c"; returns the position after it. */
static const char *add_block(buffer *out, const char *at) {
    const char *first = strchr(at, '\n');
    const char *end = first ? strstr(first, "\n```") : NULL;
    if (!end)
        return at + strlen(at);
    buffer_text(out, "<pre class=\"example\">");
    if (end > first)
        html_bytes(out, first + 1, (size_t)(end - first - 1));
    buffer_text(out, "</pre>\n");
    return end + 4 + strcspn(end + 4, "\n");
}

void html_section(buffer *out, const char *section) {
    const char *at = section + strcspn(section, "\n");
    while (*at) {
        if (*at == '\n') {
            at++;
        } else if (strncmp(at, "```", 3) == 0) {
            at = add_block(out, at);
        } else {
            const size_t length = strcspn(at, "\n");
            add_paragraph(out, at, length);
            at += length;
        }
    }
}

void html_seconds(buffer *out, double seconds) {
    if (seconds >= 100)
        buffer_format(out, "%.0f s", seconds);
    else if (seconds >= 1)
        buffer_format(out, "%.2f s", seconds);
    else if (seconds >= 0.001)
        buffer_format(out, "%.1f ms", 1e3 * seconds);
    else
        buffer_format(out, "%.0f \xC2\xB5s", 1e6 * seconds);
}
