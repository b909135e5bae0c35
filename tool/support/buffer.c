/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/buffer.h"

#include <assert.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void reserve(buffer *b, size_t more) {
    size_t needed = b->length + more + 1;
    if (needed <= b->capacity)
        return;
    size_t capacity = b->capacity < 64 ? 64 : b->capacity;
    while (capacity < needed)
        capacity *= 2;
    char *data = realloc(b->data, capacity);
    if (data == NULL) {
        fprintf(stderr, "redcc: out of memory (%zu bytes are needed)\n", capacity);
        exit(EXIT_FAILURE);
    }
    b->data = data;
    b->capacity = capacity;
    assert(b->length + more < b->capacity);
}

void buffer_append(buffer *b, const char *text, size_t length) {
    assert(text || length == 0);
    reserve(b, length);
    if (length > 0)
        memcpy(b->data + b->length, text, length);
    b->length += length;
    b->data[b->length] = 0;
}

void buffer_text(buffer *b, const char *text) {
    buffer_append(b, text, strlen(text));
}

void buffer_byte(buffer *b, char c) {
    buffer_append(b, &c, 1);
}

void buffer_format(buffer *b, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    assert(length >= 0);
    if (length >= 0) {
        reserve(b, (size_t)length);
        vsnprintf(b->data + b->length, (size_t)length + 1, format, again);
        b->length += (size_t)length;
    }
    va_end(again);
}

void buffer_uri(buffer *b, const char *path) {
    for (const char *c = path; *c; c++) {
        const unsigned char byte = (unsigned char)*c;
        const bool is_plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                              (byte >= '0' && byte <= '9') || strchr("-._~/", byte);
        if (is_plain)
            buffer_byte(b, *c);
        else
            buffer_format(b, "%%%02X", byte);
    }
}

void buffer_shorten(buffer *b, size_t count) {
    assert(count <= b->length);
    if (count == 0)
        return;
    b->length -= count;
    b->data[b->length] = 0;
}

char *buffer_take(arena *a, buffer *b) {
    assert(!b->data || b->data[b->length] == 0);
    char *text = arena_copy(a, b->length > 0 ? b->data : "", b->length);
    buffer_free(b);
    *b = (buffer){0};
    return text;
}

void buffer_free(buffer *b) {
    free(b->data);
    *b = (buffer){0};
}
