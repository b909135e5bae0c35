/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Values as a row of bytes, in either direction: one function says what belongs to a thing and in
 * which order, and counts, stores or loads it. Bytes are as the machine has them.
 */
#ifndef FABRIC_ARCHIVE_H
#define FABRIC_ARCHIVE_H

#include <stddef.h>

typedef enum archive_mode { ARCHIVE_COUNT, ARCHIVE_STORE, ARCHIVE_LOAD } archive_mode;

typedef struct archive {
    archive_mode mode;
    unsigned char *bytes; /* [size] written or read, by reference; NULL while counting */
    size_t size;
    size_t used;
    int failed; /* more was requested than is left, or a value is invalid */
} archive;

/** Passes `size` bytes from or to `value`. Where there are too few, `failed` is set, and nothing is
 *  passed any more. */
void archive_pass(archive *a, void *value, size_t size);

void archive_int(archive *a, int *value);
void archive_long(archive *a, long *value); /* as 64 bits */
void archive_double(archive *a, double *value);
void archive_doubles(archive *a, double *values, size_t count);

/** As archive_int, but fails if the loaded value is not from `low` to `high`. */
void archive_int_within(archive *a, int *value, int low, int high);

#endif
