/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks invariants of the analysis' results, on which code generation relies. */
#ifndef ANALYSIS_INVARIANTS_H
#define ANALYSIS_INVARIANTS_H

#include "analysis/analysis.h"

/** Asserts that a verdict and its facts have the properties stated in base/facts.h. Does nothing if
 *  NDEBUG is defined. */
void analysis_assert_verdict(const ir_unit *unit, const loop_verdict *verdict);

/** Asserts these properties of all verdicts, and that the verdicts on the loops of each function
 * are in source order. */
void analysis_assert_result(const ir_unit *unit, const analysis_result *result);

#endif
