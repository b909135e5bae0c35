/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks whether a loop's OpenMP directives agree with its updates. */
#ifndef ANALYSIS_PROTECTION_H
#define ANALYSIS_PROTECTION_H

#include "analysis/loop/loop_analysis.h"

/** The reason for which the loop must keep its directives: without them its results may differ,
 *  redcc cannot express them, or they protect no update of an array. REASON_NONE if there is no
 *  such reason, or if the loop has no directives that redcc replaces. All accesses must be
 *  classified. */
reason check_protection(const loop_analysis *j);

#endif
