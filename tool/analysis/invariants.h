/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Invariants of every result of the analysis, on which code generation relies. */
#ifndef ANALYSIS_INVARIANTS_H
#define ANALYSIS_INVARIANTS_H

#include "analysis/analysis.h"

/** Asserts that a verdict and its facts have the properties stated in base/facts.h. Checks nothing
 *  if NDEBUG is defined. */
void analysis_assert_verdict(const ir_unit *unit, const loop_verdict *verdict);

/** The same for all verdicts, and their order. */
void analysis_assert_result(const ir_unit *unit, const analysis_result *result);

#endif
