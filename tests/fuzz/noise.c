/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "fuzz/kernel.h"

/* Blanks may stand for a blank of the text, as for the end of a line. */
static const char *const blanks[] = {
    " ", "  ", "\n", "\t", " \\\n ", " /* i < n; */ ", "\n/* } */\n", " // k++;\n  "};

void put_with_noise(buffer *b, random_source *r, const char *text) {
    for (; *text; text++) {
        if ((*text == ' ' || *text == '\n') && random_chance(r, 25))
            buffer_text(b, blanks[random_below(r, (int)(sizeof blanks / sizeof *blanks))]);
        else
            buffer_byte(b, *text);
    }
}
