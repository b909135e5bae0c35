/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Files that are written entirely or not at all. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdbool.h>
#include <stddef.h>

#include "support/arena.h"

/**
 * Writes `length` bytes to `path` ("-": standard output). A regular file is written under a
 * temporary name and renamed; its mode is kept. So readers see the old text or the new one, and a
 * failure leaves the old one. Other files (a device, a pipe) are written directly. Returns NULL, or
 * a message in the arena.
 */
const char *output_write(arena *a, const char *path, const char *text, size_t length);

#endif
