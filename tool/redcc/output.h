/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Files that are written whole or not at all. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdbool.h>
#include <stddef.h>

#include "support/arena.h"

/**
 * Writes `length` bytes to `path` ("-": standard output). A regular file is written beside and
 * renamed, its mode kept, so that readers see the old text or the new and a failure leaves the old
 * one; what is not a regular file (a device, a pipe) is written directly. Returns NULL, or in the
 * arena why it could not be done.
 */
const char *output_write(arena *a, const char *path, const char *text, size_t length);

#endif
