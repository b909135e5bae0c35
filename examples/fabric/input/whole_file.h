/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A file's bytes in memory. */
#ifndef FABRIC_INPUT_WHOLE_FILE_H
#define FABRIC_INPUT_WHOLE_FILE_H

#include <stddef.h>

/** Reads all of it, with a 0 after the last byte; to be freed. NULL after a message. */
char *whole_file_read(const char *path, size_t *size);

#endif
