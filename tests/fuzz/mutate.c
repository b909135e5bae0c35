/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * mutate SEED <FILE
 *
 * Prints the file with damage: truncated, with changed bytes, with pieces removed, moved or
 * duplicated, or with deeply nested text inserted. The result is mostly not valid C.
 */
#include <stdio.h>
#include <stdlib.h>

#include "fuzz/random.h"
#include "support/buffer.h"

static size_t place_in(random_source *r, const buffer *b) {
    return (size_t)random_below(r, (int)b->length + 1);
}

/* Replaces [from, to) in the text. */
static void replace(buffer *b, size_t from, size_t to, const char *text, size_t length) {
    buffer result = {0};
    buffer_append(&result, b->data, from);
    buffer_append(&result, text, length);
    buffer_append(&result, b->data + to, b->length - to);
    buffer_free(b);
    *b = result;
}

static void cut(random_source *r, buffer *b) {
    replace(b, place_in(r, b), b->length, "", 0);
}

static void change_bytes(random_source *r, buffer *b) {
    static const char likely[] = "(){}[];,*&\"'\\#/\n\r0x<>=+-.\0\xff\xc3%:?";
    for (int i = 1 + random_below(r, 6); i > 0 && b->length; i--) {
        const size_t at = (size_t)random_below(r, (int)b->length);
        b->data[at] = random_chance(r, 70) ? likely[random_below(r, (int)sizeof likely - 1)]
                                           : (char)random_below(r, 256);
    }
}

static void leave_out(random_source *r, buffer *b) {
    const size_t from = place_in(r, b);
    const size_t most = b->length - from;
    const size_t length = (size_t)random_below(r, 60);
    replace(b, from, from + (length < most ? length : most), "", 0);
}

static void copy_piece(random_source *r, buffer *b) {
    const size_t from = place_in(r, b);
    const size_t most = b->length - from;
    size_t length = (size_t)random_below(r, 200);
    length = length < most ? length : most;
    buffer piece = {0};
    buffer_append(&piece, b->data + from, length);
    const size_t to = place_in(r, b);
    replace(b, to, to, piece.data, piece.length);
    buffer_free(&piece);
}

static void nest(random_source *r, buffer *b) {
    static const char *const openings[] = {"(",        "{",  "[",       "if (1) ", "for (;;) ",
                                           "*",        "&",  "-",       "x ? ",    "do ",
                                           "struct {", "({", "sizeof ", "(int)"};
    const char *opening = openings[random_below(r, (int)(sizeof openings / sizeof *openings))];
    buffer piece = {0};
    for (int i = 1 << random_below(r, 14); i > 0; i--)
        buffer_text(&piece, opening);
    const size_t to = place_in(r, b);
    replace(b, to, to, piece.data, piece.length);
    buffer_free(&piece);
}

int main(int argc, char **argv) {
    static void (*const kinds[])(random_source * r, buffer * b) = {
        cut, change_bytes, change_bytes, leave_out, leave_out, copy_piece, nest};
    if (argc != 2)
        return 2;
    random_source r = {strtoull(argv[1], NULL, 10)};
    buffer b = {0};
    buffer_text(&b, "");
    for (int c = getchar(); c != EOF; c = getchar())
        buffer_byte(&b, (char)c);
    for (int i = 1 + random_below(&r, 2); i > 0; i--)
        kinds[random_below(&r, (int)(sizeof kinds / sizeof *kinds))](&r, &b);
    fwrite(b.data, 1, b.length, stdout);
    buffer_free(&b);
    return 0;
}
