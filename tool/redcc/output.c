/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* realpath, mkstemp */
#include "redcc/output.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *failure(arena *a, const char *path) {
    return arena_format(a, "cannot write '%s': %s", path, strerror(errno));
}

static bool write_all(int file, const char *text, size_t length) {
    while (length > 0) {
        const ssize_t written = write(file, text, length);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        text += written;
        length -= (size_t)written;
    }
    return true;
}

static const char *write_directly(arena *a, const char *path, int file, const char *text,
                                  size_t length) {
    if (file < 0 || !write_all(file, text, length))
        return failure(a, path);
    if (file != STDOUT_FILENO && close(file) != 0)
        return failure(a, path);
    return NULL;
}

/** The permissions that a new file gets. */
static mode_t default_mode(void) {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

static const char *write_beside(arena *a, const char *path, const char *target, mode_t mode,
                                const char *text, size_t length) {
    char *temporary = arena_format(a, "%s.XXXXXX", target);
    const int file = mkstemp(temporary);
    if (file < 0)
        return failure(a, path);
    bool ok = write_all(file, text, length) && fchmod(file, mode) == 0;
    int reason = errno;
    if (close(file) != 0 && ok) {
        ok = false;
        reason = errno;
    }
    if (ok && rename(temporary, target) != 0) {
        ok = false;
        reason = errno;
    }
    if (ok)
        return NULL;
    unlink(temporary);
    errno = reason;
    return failure(a, path);
}

const char *output_write(arena *a, const char *path, const char *text, size_t length) {
    assert(text || length == 0);
    if (strcmp(path, "-") == 0)
        return write_directly(a, "standard output", STDOUT_FILENO, text, length);
    struct stat state;
    if (stat(path, &state) != 0)
        return errno == ENOENT ? write_beside(a, path, path, default_mode(), text, length)
                               : failure(a, path);
    if (!S_ISREG(state.st_mode)) /* for a directory, opening it gives the right message */
        return write_directly(a, path, open(path, O_WRONLY | O_TRUNC), text, length);
    if (access(path, W_OK) != 0)
        return failure(a, path);
    char *target =
        realpath(path, NULL); /* the file that a link points to is replaced, not the link */
    if (!target)
        return failure(a, path);
    const char *wrong = write_beside(a, path, target, state.st_mode & 07777, text, length);
    free(target);
    return wrong;
}
