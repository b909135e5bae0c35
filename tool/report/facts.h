/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Texts that all forms of the report share. */
#ifndef REPORT_FACTS_H
#define REPORT_FACTS_H

#include "ir/ir_position.h"
#include "report/report.h"
#include "support/vector.h"

typedef VECTOR(const char *) text_list;

/** The verdict as a word: "transformed", "refused" or "not-a-reduction". */
const char *verdict_word(const loop_verdict *verdict);
const char *element_word(const reduction_array *array);
/** The guards of the loop, as texts such as "no-overlap(h, w)". Each is a pair of objects that are
 * checked at run time, and occurs once. */
text_list verdict_guards(arena *a, const loop_verdict *verdict);
/** One line: "loop in 'kernel' runs in parallel: h (+ double)". */
const char *verdict_sentence(arena *a, const loop_verdict *verdict);

/** The offset of the loop's keyword or, if the file does not contain it, of the text around it. */
uint32_t verdict_offset(const loop_verdict *verdict);
/** verdict_position is the position of the loop's keyword. reason_position is that of the reason
 * for a refusal or, if the reason has none, the loop's. */
ir_position verdict_position(const report_input *input, const loop_verdict *verdict);
ir_position reason_position(const report_input *input, const loop_verdict *verdict);

/** The remark on a transformed loop's form for several iterations at once, or NULL if none was
 * requested. */
const lanes_remark *verdict_lanes(const report_input *input, const loop_verdict *verdict);
/** The position of the reason why the loop has no such form. */
ir_position lanes_position(const report_input *input, const lanes_remark *lanes);

void report_text(arena *a, buffer *out, const report_input *input);
void report_json(arena *a, buffer *out, const report_input *input);
void report_sarif(arena *a, buffer *out, const report_input *input);
void report_yaml(arena *a, buffer *out, const report_input *input);

#endif
