/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of the C library that no pragma of the user makes free of side effects. */
#ifndef ANALYSIS_STATEFUL_H
#define ANALYSIS_STATEFUL_H

/** The effect of a function of this name, as a verb with its object: "writes output"; NULL: it is
 *  not known to print, allocate, keep state, write memory or end the program. */
const char *stateful_effect(const char *name);

#endif
