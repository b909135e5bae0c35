/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of the C library of which no user's word makes functions without side effects. */
#ifndef ANALYSIS_STATEFUL_H
#define ANALYSIS_STATEFUL_H

/** What a function of this name does, as a verb with its object: "writes output"; NULL: it is none
 *  of those known to print, allocate, keep state, write memory or end the program. */
const char *stateful_deed(const char *name);

#endif
