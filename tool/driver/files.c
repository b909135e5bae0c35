/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/files.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/buffer.h"

char *file_read(arena *a, const char *path, size_t *length) {
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    buffer text = {0};
    char part[65536];
    size_t count;
    while ((count = fread(part, 1, sizeof part, file)) > 0)
        buffer_append(&text, part, count);
    char *copy = NULL;
    if (!ferror(file)) {
        copy = arena_copy(a, text.data ? text.data : "", text.length);
        if (length)
            *length = text.length;
    }
    buffer_free(&text);
    fclose(file);
    return copy;
}

bool file_equal(arena *a, const char *left, const char *right) {
    size_t left_length, right_length;
    char *left_text = file_read(a, left, &left_length);
    char *right_text = file_read(a, right, &right_length);
    return left_text && right_text && left_length == right_length &&
           memcmp(left_text, right_text, left_length) == 0;
}

bool file_copy(arena *a, const char *from, const char *to) {
    size_t length;
    char *text = file_read(a, from, &length);
    char *partial = arena_format(a, "%s.%ld", to, (long)getpid());
    FILE *file = text ? fopen(partial, "wb") : NULL;
    if (!file)
        return false;
    bool good = fwrite(text, 1, length, file) == length;
    good &= fclose(file) == 0;
    if (!good || rename(partial, to) != 0) {
        unlink(partial);
        return false;
    }
    return true;
}

bool file_is_empty(const char *path) {
    struct stat about;
    return stat(path, &about) != 0 || about.st_size == 0;
}

void file_show(const char *path, FILE *stream) {
    FILE *file = fopen(path, "rb");
    if (!file)
        return;
    char part[4096];
    size_t count;
    while ((count = fread(part, 1, sizeof part, file)) > 0)
        fwrite(part, 1, count, stream);
    fclose(file);
    fflush(stream);
}

bool folder_create_for(arena *a, const char *path) {
    char *copy = arena_string(a, path);
    for (char *slash = strchr(copy + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = 0;
        if (mkdir(copy, 0777) != 0 && errno != EEXIST)
            return false;
        *slash = '/';
    }
    return true;
}

const char *path_base(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

const char *path_folder(arena *a, const char *path) {
    const char *base = path_base(path);
    if (base == path)
        return "";
    size_t length = (size_t)(base - path) - 1;
    return length == 0 ? "/" : arena_copy(a, path, length);
}

bool path_is_executable(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 && S_ISREG(about.st_mode) && access(path, X_OK) == 0;
}

bool path_same_file(const char *left, const char *right) {
    struct stat one, other;
    return stat(left, &one) == 0 && stat(right, &other) == 0 && one.st_dev == other.st_dev &&
           one.st_ino == other.st_ino;
}
