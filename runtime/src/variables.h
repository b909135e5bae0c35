/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The environment variables whose names begin with REDCC_. */
#ifndef REDCC_VARIABLES_H
#define REDCC_VARIABLES_H

#include <stdbool.h>

/** The variables that a translated program reads; docs/report.md describes them, and a test
 * compares the two lists. */
#define REDCC_VARIABLE_LIST(X)                                                                     \
    X("REDCC_METHOD")                                                                              \
    X("REDCC_ORDER")                                                                               \
    X("REDCC_SUM")                                                                                 \
    X("REDCC_MEMORY_LIMIT")                                                                        \
    X("REDCC_VALIDATE")                                                                            \
    X("REDCC_REPORT")                                                                              \
    X("REDCC_TRACE")                                                                               \
    X("REDCC_PREFETCH")                                                                            \
    X("REDCC_LANES")                                                                               \
    X("REDCC_WATCH")

/** The value of an environment variable. NULL if the variable is unset, or if the program has more
 * rights than its caller (setuid): then the environment is ignored. */
const char *redcc_environment(const char *name);

/** Prints to standard error those REDCC_... variables that are set, but that neither translated
 * programs nor redcc and redcc-cc read. Called once. */
void redcc_note_unknown_variables(void);

/** Is a variable set whose name begins with REDCC_? Those that only a build reads do not count.
 * Also true if the environment is unknown. */
bool redcc_any_variable(void);

#endif
