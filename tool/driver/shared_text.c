/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/shared_text.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "driver/files.h"

/* FNV-1a of 64 bits. */
static uint64_t hash(uint64_t so_far, const char *bytes, size_t length) {
    for (size_t i = 0; i < length; i++)
        so_far = (so_far ^ (unsigned char)bytes[i]) * 0x100000001b3u;
    return so_far;
}

const char *shared_text(session *s, const char *path, const char *source) {
    size_t length;
    const char *bytes = s->show ? NULL : file_read(s->memory, path, &length);
    if (!bytes || memmem(bytes, length, "__TIMESTAMP__", 13)) /* expands to the file's own time */
        return path;
    uint64_t key = hash(0xcbf29ce484222325u, bytes, length);
    key = hash(key, source, strlen(source) + 1);
    shared_folder folder = temporary_share(s->memory, key);
    if (!folder.path)
        return path;
    VECTOR_PUSH(s->memory, &s->shared, folder);
    const char *shared = arena_format(s->memory, "%s/%s", folder.path, path_base(path));
    const bool is_there = access(shared, F_OK) == 0; /* another call compiles the same text */
    const bool is_good = is_there ? file_equal(s->memory, path, shared) : rename(path, shared) == 0;
    return is_good ? shared : path;
}
