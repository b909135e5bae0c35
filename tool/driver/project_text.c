/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The format of the bytes:
 *   files:     their number; for each: path, digest, functions
 *   functions: their number; for each: name, is_static, has_loop, calls
 *   calls:     their number; for each: name
 * Numbers are unsigned; texts end with a zero byte.
 */
#include "driver/project_text.h"

#include <assert.h>

#include "support/buffer.h"

/* ---- writing --------------------------------------------------------------------------------- */

static void write_number(buffer *out, unsigned number) {
    buffer_append(out, (const char *)&number, sizeof number);
}

static void write_text(buffer *out, const char *text) {
    buffer_append(out, text, strlen(text) + 1);
}

static void write_function(buffer *out, const project_function *function) {
    write_text(out, function->name);
    buffer_byte(out, (char)function->is_static);
    buffer_byte(out, (char)function->has_loop);
    write_number(out, function->calls.count);
    for (unsigned i = 0; i < function->calls.count; i++)
        write_text(out, function->calls.items[i]);
}

store_part project_write(arena *a, const project_scan *files) {
    buffer out = {0};
    write_number(&out, files->count);
    for (unsigned i = 0; i < files->count; i++) {
        const project_file *file = &files->items[i];
        write_text(&out, file->path);
        buffer_append(&out, (const char *)file->contents.bytes, sizeof file->contents.bytes);
        write_number(&out, file->functions.count);
        for (unsigned k = 0; k < file->functions.count; k++)
            write_function(&out, &file->functions.items[k]);
    }
    const size_t length = out.length;
    return (store_part){buffer_take(a, &out), length};
}

/* ---- reading --------------------------------------------------------------------------------- */

static unsigned read_number(const char **at) {
    unsigned number;
    memcpy(&number, *at, sizeof number);
    *at += sizeof number;
    return number;
}

static const char *read_text(const char **at) {
    const char *text = *at;
    *at += strlen(text) + 1;
    return text;
}

static project_function read_function(arena *a, const char **at) {
    project_function function = {.name = read_text(at)};
    function.is_static = *(*at)++ != 0;
    function.has_loop = *(*at)++ != 0;
    for (unsigned left = read_number(at); left > 0; left--)
        VECTOR_PUSH(a, &function.calls, read_text(at));
    return function;
}

project_scan project_read(arena *a, const store_part *part) {
    project_scan files = {0};
    const char *at = part->bytes;
    for (unsigned left = read_number(&at); left > 0; left--) {
        project_file file = {.path = read_text(&at)};
        memcpy(file.contents.bytes, at, sizeof file.contents.bytes);
        at += sizeof file.contents.bytes;
        for (unsigned functions = read_number(&at); functions > 0; functions--)
            VECTOR_PUSH(a, &file.functions, read_function(a, &at));
        VECTOR_PUSH(a, &files, file);
    }
    assert(at == part->bytes + part->length);
    return files;
}
