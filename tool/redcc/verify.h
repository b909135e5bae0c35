/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** --verify: builds and runs the sequential and the parallel program, which must print the same. */
#ifndef VERIFY_H
#define VERIFY_H

#include "redcc/options.h"
#include "support/source.h"

/**
 * Builds `input` without OpenMP and the output with OpenMP, and compares what the two programs
 * write to standard output and their exit status. Both run without arguments and with empty
 * standard input. The input must be a whole program. The parallel program runs under
 * REDCC_VALIDATE=1: all loops that can run in parallel do so, whatever their size, and each reports
 * its result on standard error. Returns NULL if the programs agree, or a message in the arena.
 */
const char *verify_output(arena *a, const source *input, const string_list *flags, const char *text,
                          size_t length);

#endif
