/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What all forms of the report say of a loop, in words. */
#ifndef REPORT_FACTS_H
#define REPORT_FACTS_H

#include "ir/ir_position.h"
#include "report/report.h"
#include "support/vector.h"

typedef VECTOR(const char *) text_list;

/** "transformed", "refused", "not-a-reduction" */
const char *verdict_word(const loop_verdict *verdict);
const char *element_word(const reduction_array *array);
/** "no-overlap(h, w)" for each pair that is asked at run time, each once. */
text_list verdict_guards(arena *a, const loop_verdict *verdict);
/** One line: "loop in 'kernel' runs in parallel: h (+ double)". */
const char *verdict_sentence(arena *a, const loop_verdict *verdict);

/** Of the loop's keyword; of what is around it where its own text is not in the file. */
uint32_t verdict_offset(const loop_verdict *verdict);
/** Of the loop's keyword, and of what stands in the way (the loop's own, where that has no place).
 */
ir_position verdict_position(const report_input *input, const loop_verdict *verdict);
ir_position reason_position(const report_input *input, const loop_verdict *verdict);

/** Of a transformed loop where forms for several iterations at once were asked for, else NULL. */
const lanes_remark *verdict_lanes(const report_input *input, const loop_verdict *verdict);
/** Where what stands in the way of such a form is. */
ir_position lanes_position(const report_input *input, const lanes_remark *lanes);

void report_text(arena *a, buffer *out, const report_input *input);
void report_json(arena *a, buffer *out, const report_input *input);
void report_sarif(arena *a, buffer *out, const report_input *input);
void report_yaml(arena *a, buffer *out, const report_input *input);

#endif
