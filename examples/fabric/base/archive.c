/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "archive.h"

#include <stdint.h>
#include <string.h>

void archive_pass(archive *a, void *value, size_t size) {
    if (a->mode != ARCHIVE_COUNT && (a->failed || size > a->size - a->used)) {
        a->failed = 1;
        return;
    }
    if (a->mode == ARCHIVE_STORE && size > 0)
        memcpy(a->bytes + a->used, value, size);
    else if (a->mode == ARCHIVE_LOAD && size > 0)
        memcpy(value, a->bytes + a->used, size);
    a->used += size;
}

void archive_int(archive *a, int *value) {
    archive_pass(a, value, sizeof *value);
}

void archive_long(archive *a, long *value) {
    int64_t wide = *value;
    archive_pass(a, &wide, sizeof wide);
    *value = (long)wide;
}

void archive_double(archive *a, double *value) {
    archive_pass(a, value, sizeof *value);
}

void archive_doubles(archive *a, double *values, size_t count) {
    archive_pass(a, values, sizeof *values * count);
}

void archive_int_within(archive *a, int *value, int low, int high) {
    archive_int(a, value);
    if (a->mode == ARCHIVE_LOAD && (*value < low || *value > high)) {
        *value = low;
        a->failed = 1;
    }
}
