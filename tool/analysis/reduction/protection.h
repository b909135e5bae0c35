/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks whether a loop's OpenMP directives agree with its updates. */
#ifndef ANALYSIS_PROTECTION_H
#define ANALYSIS_PROTECTION_H

#include "analysis/loop/loop_analysis.h"

/** The reason for which the loop must keep its directives: they change its results, or protect no
 *  update of an array. REASON_NONE if it may run without them, or has none. All accesses must be
 *  classified. */
reason check_protection(const loop_analysis *j);

#endif
