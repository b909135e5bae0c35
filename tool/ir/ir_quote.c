/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Quotes texts for the text form. */
#include "ir/ir_printer.h"

/* The letter that follows the backslash in the byte's escape; 0 if it has none. */
static char escape_letter(char c) {
    switch (c) {
    case '\n':
        return 'n';
    case '\r':
        return 'r';
    case '\t':
        return 't';
    case '\\':
    case '"':
        return c;
    default:
        return 0;
    }
}

void ir_print_quoted(buffer *out, const char *text, size_t length) {
    buffer_byte(out, '"');
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)text[i];
        char letter = escape_letter(text[i]);
        if (letter != 0)
            buffer_format(out, "\\%c", letter);
        else if (c < 32 || c == 127)
            buffer_format(out, "\\%03o", c);
        else
            buffer_byte(out, text[i]);
    }
    buffer_byte(out, '"');
}
