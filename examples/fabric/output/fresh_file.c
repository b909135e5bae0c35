/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/fresh_file.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

static int complain(const char *path) {
    fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
    return -1;
}

int fresh_file_open(fresh_file *f, const char *path) {
    f->path = path;
    errno = ENAMETOOLONG;
    if (snprintf(f->temporary, FILE_PATH_SIZE, "%s.partial", path) >= FILE_PATH_SIZE)
        return complain(path);
    f->file = fopen(f->temporary, "wb");
    return f->file ? 0 : complain(path);
}

int fresh_file_sync(fresh_file *f) {
    /* fsync fails with EINVAL if the file is not a regular one. */
    if (!ferror(f->file) && fflush(f->file) == 0 &&
        (fsync(fileno(f->file)) == 0 || errno == EINVAL))
        return 0;
    return complain(f->path);
}

int fresh_file_close(fresh_file *f, int status) {
    const int reason = errno, had_failed = ferror(f->file);
    int failed = fclose(f->file) != 0;
    if (had_failed) {
        failed = 1;
        errno = reason;
    }
    if (status == 0 && (failed || rename(f->temporary, f->path) != 0))
        status = complain(f->path);
    if (status != 0)
        remove(f->temporary);
    return status;
}
