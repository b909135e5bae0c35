/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Do the loop's OpenMP directives agree with its updates? */
#ifndef ANALYSIS_PROTECTION_H
#define ANALYSIS_PROTECTION_H

#include "analysis/loop/loop_analysis.h"

/** Why the loop cannot be executed without its directives, in sequential order; of a loop all of
 *  whose accesses are known. Nothing, of a loop without directives. */
reason check_protection(const loop_analysis *j);

#endif
