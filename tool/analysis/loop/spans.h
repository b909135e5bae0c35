/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inner loops of the slice whose rows are recorded at once. */
#ifndef ANALYSIS_SPANS_H
#define ANALYSIS_SPANS_H

#include "analysis/loop/loop_analysis.h"

typedef VECTOR(loop_span) span_list;

/** All of them, in source order, each before those inside of it. Requires the slice. */
span_list find_spans(const loop_analysis *j);

#endif
