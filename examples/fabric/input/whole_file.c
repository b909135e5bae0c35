/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "input/whole_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *read_all(FILE *file, size_t *size) {
    size_t room = 1 << 16;
    char *bytes = malloc(room);
    *size = 0;
    while (bytes) {
        *size += fread(bytes + *size, 1, room - 1 - *size, file);
        if (*size < room - 1)
            break;
        room *= 2;
        char *more = realloc(bytes, room);
        if (!more)
            free(bytes);
        bytes = more;
    }
    if (bytes && !ferror(file)) {
        bytes[*size] = '\0';
        return bytes;
    }
    free(bytes);
    return NULL;
}

char *whole_file_read(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    char *bytes = file ? read_all(file, size) : NULL;
    if (!bytes)
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
    if (file)
        fclose(file);
    return bytes;
}
