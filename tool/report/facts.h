/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The contents that all forms of the report share, in words. */
#ifndef REPORT_FACTS_H
#define REPORT_FACTS_H

#include "ir/ir_position.h"
#include "report/report.h"
#include "support/vector.h"

typedef VECTOR(const char *) text_list;

/** "transformed", "refused", "not-a-reduction" */
const char *verdict_word(const loop_verdict *verdict);
const char *element_word(const reduction_array *array);
/** "no-overlap(h, w)" for each pair that is checked at run time, each once. */
text_list verdict_guards(arena *a, const loop_verdict *verdict);
/** One line: "loop in 'kernel' runs in parallel: h (+ double)". */
const char *verdict_sentence(arena *a, const loop_verdict *verdict);

/** The offset of the loop's keyword; of the enclosing text if the loop's own is not in the file. */
uint32_t verdict_offset(const loop_verdict *verdict);
/** The position of the loop's keyword, and of the reason for a refusal (the loop's own, if that has
 *  none). */
ir_position verdict_position(const report_input *input, const loop_verdict *verdict);
ir_position reason_position(const report_input *input, const loop_verdict *verdict);

/** For a transformed loop, if forms for several iterations at once were requested; else NULL. */
const lanes_remark *verdict_lanes(const report_input *input, const loop_verdict *verdict);
/** The position of the reason why there is no such form. */
ir_position lanes_position(const report_input *input, const lanes_remark *lanes);

void report_text(arena *a, buffer *out, const report_input *input);
void report_json(arena *a, buffer *out, const report_input *input);
void report_sarif(arena *a, buffer *out, const report_input *input);
void report_yaml(arena *a, buffer *out, const report_input *input);

#endif
