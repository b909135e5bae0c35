/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Files written under a temporary name and renamed when complete. */
#ifndef FABRIC_OUTPUT_FRESH_FILE_H
#define FABRIC_OUTPUT_FRESH_FILE_H

#include <stdio.h>

#include "base/files.h"

typedef struct fresh_file {
    const char *path; /* by reference */
    char beside[FILE_PATH_SIZE];
    FILE *file; /* to be written to */
} fresh_file;

/** Begins one. 0, or -1 after a message: then there is nothing to close. */
int fresh_file_open(fresh_file *f, const char *path);

/** Waits until the data is on the disk. 0, or -1 after a message; fresh_file_close in either
 *  case. */
int fresh_file_sync(fresh_file *f);

/** Renames the file if `status`, the result of writing so far, is 0; else removes it. Returns the
 *  status, or -1 after a message. */
int fresh_file_close(fresh_file *f, int status);

#endif
