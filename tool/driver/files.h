/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads and copies files, creates folders, and splits paths. */
#ifndef DRIVER_FILES_H
#define DRIVER_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "support/arena.h"

/** The bytes of a file followed by a 0, or NULL if it cannot be read. Sets *length unless length is
 * NULL. */
char *file_read(arena *a, const char *path, size_t *length);

/** Returns whether both files can be read and contain the same bytes. */
bool file_equal(arena *a, const char *left, const char *right);

/** Copies through a temporary file in the folder of `to` and a rename, so that no reader sees a
 *  partial file. */
bool file_copy(arena *a, const char *from, const char *to);

/** Returns whether a file is empty or does not exist. */
bool file_is_empty(const char *path);

/** Copies a file's bytes to a stream; a missing file counts as empty. */
void file_show(const char *path, FILE *stream);

/** Creates the folder of `path`, and those above it. */
bool folder_create_for(arena *a, const char *path);

/** path_base returns the part after the last slash; path_folder the part before it ("" without a
 * slash, "/" for the root). */
const char *path_base(const char *path);
const char *path_folder(arena *a, const char *path);

/** Returns whether `path` names a file, not a folder, that this process may execute. */
bool path_is_executable(const char *path);

/** Returns whether both paths lead to one file; false if either does not exist. */
bool path_same_file(const char *left, const char *right);

#endif
