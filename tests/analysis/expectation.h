/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compares verdicts with a source's comments. A comment on the line of a loop's keyword:
 *     // EXPECT: transform h(+) b(+) [guards=2] [verifiable | not-verifiable] [privates=1] [keys=0]
 *                          and other words that expectation_describe prints
 *     // EXPECT: refuse other-store
 * Loops without a comment must have no verdict. Anywhere in the file:
 *     // PURE: f, g         like the option --pure=f,g
 *     // NOALIAS            like the option --assume-noalias
 */
#ifndef TESTS_ANALYSIS_EXPECTATION_H
#define TESTS_ANALYSIS_EXPECTATION_H

#include "analysis/analysis.h"

/** Describes a verdict in the words of the comments, on one line: "transform h(+) guards=0 verifiable ...".
 */
const char *expectation_describe(arena *a, const loop_verdict *verdict);

/** Returns the options that the source's comments give. */
analysis_options expectation_options(arena *a, const source *s);

/** Compares verdicts with comments and prints the differences to standard error. Returns their number. */
unsigned expectation_check(arena *a, const ir_unit *unit, const analysis_result *result);

#endif
