/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Files written under a temporary name and renamed when complete. */
#ifndef FABRIC_OUTPUT_FRESH_FILE_H
#define FABRIC_OUTPUT_FRESH_FILE_H

#include <stdio.h>

#include "base/files.h"

typedef struct fresh_file {
    const char *path; /* final name, not owned */
    char temporary[FILE_PATH_SIZE];
    FILE *file; /* the temporary file, for the caller to write */
} fresh_file;

/** Opens a temporary file next to `path`. Returns 0, or -1 after a message; then fresh_file_close
 *  must not be called. */
int fresh_file_open(fresh_file *f, const char *path);

/** Flushes the data to the disk. Returns 0, or -1 after a message. Call fresh_file_close in either
 *  case. */
int fresh_file_sync(fresh_file *f);

/** Renames the file if `status`, the result of writing so far, is 0; otherwise removes it. Returns
 *  the status, or -1 after a message. */
int fresh_file_close(fresh_file *f, int status);

#endif
