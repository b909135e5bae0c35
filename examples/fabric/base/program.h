/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A program of several commands: `NAME COMMAND ...`, `NAME --help`, `NAME --version`. */
#ifndef FABRIC_BASE_PROGRAM_H
#define FABRIC_BASE_PROGRAM_H

#include "base/options.h"

/** Sets program_name, then runs the command that argv[1] names, or answers --help (whose first
 *  sentence is `purpose`) or --version. Returns the exit status, which is EXIT_USAGE if there is no
 *  such command. */
int program_run(const char *purpose, const command *const *commands, int count, int argc,
                char **argv);

#endif
