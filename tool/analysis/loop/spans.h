/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds spans: inner loops of the slice whose rows are recorded all at once. */
#ifndef ANALYSIS_SPANS_H
#define ANALYSIS_SPANS_H

#include "analysis/loop/loop_analysis.h"

typedef VECTOR(loop_span) span_list;

/** All spans in source order, outer ones before inner ones. The slice must have been computed. */
span_list find_spans(const loop_analysis *j);

#endif
