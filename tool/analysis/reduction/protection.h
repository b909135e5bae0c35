/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Do the loop's OpenMP directives agree with its updates? */
#ifndef ANALYSIS_PROTECTION_H
#define ANALYSIS_PROTECTION_H

#include "analysis/loop/loop_analysis.h"

/** Why the loop cannot be executed without its directives, in sequential order; REASON_NONE if it
 *  can, or has none. All accesses of the loop must be known. */
reason check_protection(const loop_analysis *j);

#endif
