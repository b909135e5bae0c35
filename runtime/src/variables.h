/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The variables REDCC_... of the environment. */
#ifndef REDCC_VARIABLES_H
#define REDCC_VARIABLES_H

#include <stdbool.h>

/** Those that a translated program reads; docs/report.md describes them, and a test compares. */
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

/** A variable of the environment; NULL: it is not set, or the program has more rights than who
 *  started it (setuid), who must not tell it anything then. */
const char *redcc_environment(const char *name);

/** Says on standard error, once for each, which variables REDCC_... are set that neither a
 *  translated program nor redcc and redcc-cc know. To be called once. */
void redcc_note_unknown_variables(void);

/** Is any variable set that begins as ours do and is not one of the build alone, or is that not
 * known? */
bool redcc_any_variable(void);

#endif
