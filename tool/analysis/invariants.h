/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What every result of the analysis promises to those who write code from it. */
#ifndef ANALYSIS_INVARIANTS_H
#define ANALYSIS_INVARIANTS_H

#include "analysis/analysis.h"

/** Stops the program where a verdict or its facts are not what base/facts.h says of them. Nothing
 *  is looked at where NDEBUG is defined. */
void analysis_assert_verdict(const ir_unit *unit, const loop_verdict *verdict);

/** The same of all verdicts, and of their order. */
void analysis_assert_result(const ir_unit *unit, const analysis_result *result);

#endif
