/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The variables that each iteration has for itself. */
#ifndef ANALYSIS_PRIVATES_H
#define ANALYSIS_PRIVATES_H

#include "analysis/loop/loop_analysis.h"

/** Proves what is left to the privates: not carried, last values. */
bool check_privates(loop_analysis *j);

#endif
