/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The variables that each iteration has for itself. */
#ifndef ANALYSIS_PRIVATES_H
#define ANALYSIS_PRIVATES_H

#include "analysis/loop/judgement.h"

/** Proves what is left to the privates: not carried, last values. */
bool judge_privates(judgement *j);

#endif
