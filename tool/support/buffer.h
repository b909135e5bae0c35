/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A growing string of bytes. After the first append it ends in a 0 that is not counted. */
#ifndef SUPPORT_BUFFER_H
#define SUPPORT_BUFFER_H

#include <stddef.h>

#include "support/arena.h"

typedef struct buffer {
    char *data; /* owned; never NULL after the first append */
    size_t length;
    size_t capacity;
} buffer; /* {0} is an empty one */

void buffer_append(buffer *b, const char *text, size_t length);
void buffer_text(buffer *b, const char *text);
void buffer_format(buffer *b, const char *format, ...) __attribute__((format(printf, 2, 3)));
void buffer_byte(buffer *b, char c);
/** Appends a path as a URI reference: all but unreserved characters and / are escaped. */
void buffer_uri(buffer *b, const char *path);
/** Removes `count` bytes from the end; `count` must be at most the buffer's length. */
void buffer_shorten(buffer *b, size_t count);
/** Returns the text, copied to the arena, and empties the buffer. */
char *buffer_take(arena *a, buffer *b);
void buffer_free(buffer *b);

#endif
