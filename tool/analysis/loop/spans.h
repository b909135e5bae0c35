/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inner loops of the slice whose rows are told at once. */
#ifndef ANALYSIS_SPANS_H
#define ANALYSIS_SPANS_H

#include "analysis/loop/loop_analysis.h"

/** Fills in j->spans. */
void find_spans(loop_analysis *j);

#endif
