/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Verdicts against what a source's comments say. A comment on the line of a loop's keyword:
 *     // EXPECT: transform h(+) b(+) [guards=2] [verifiable | not-verifiable] [privates=1] [keys=0]
 *                          and what else expectation_describe prints
 *     // EXPECT: refuse other-store
 * Loops without a comment must have no verdict. Anywhere in the file:
 *     // PURE: f, g         as --pure=f,g
 *     // NOALIAS            as --assume-noalias
 */
#ifndef TESTS_ANALYSIS_EXPECTATION_H
#define TESTS_ANALYSIS_EXPECTATION_H

#include "analysis/analysis.h"

/** One line for a verdict, in the words of the comments: "transform h(+) guards=0 verifiable ...".
 */
const char *expectation_describe(arena *a, const loop_verdict *verdict);

/** The options that the source's comments ask for. */
analysis_options expectation_options(arena *a, const source *s);

/** Compares; prints each difference to standard error. Returns how many there are. */
unsigned expectation_check(arena *a, const ir_unit *unit, const analysis_result *result);

#endif
