/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** LLVM optimization records, for opt-viewer and similar tools (llvm.org/docs/Remarks.html). */
#include "report/facts.h"
#include "report/plan.h"

/** Appends a single-quoted YAML scalar on one line. */
static void scalar(buffer *out, const char *text) {
    buffer_byte(out, '\'');
    for (const char *c = text; *c; c++) {
        if (*c == '\'')
            buffer_byte(out, '\'');
        buffer_byte(out, *c == '\n' || *c == '\r' ? ' ' : *c);
    }
    buffer_byte(out, '\'');
}

static void record(arena *a, buffer *out, const report_input *input, const loop_verdict *verdict) {
    const bool is_refused = verdict->kind == VERDICT_REFUSE;
    const ir_position at = verdict_position(input, verdict);
    buffer_format(out, "--- !%s\nPass:            redcc\nName:            ",
                  verdict_is_written(verdict) ? "Passed"
                  : is_refused                ? "Missed"
                                              : "Analysis");
    scalar(out, is_refused                    ? reason_slug(verdict->why.id)
                : verdict_is_written(verdict) ? "reduction"
                                              : "not-a-reduction");
    buffer_text(out, "\nDebugLoc:        { File: ");
    scalar(out, at.file);
    buffer_format(out, ", Line: %u, Column: %u }\nFunction:        ", at.line, at.column);
    scalar(out, verdict->function->name);
    buffer_text(out, "\nArgs:\n  - String:          ");
    scalar(out, verdict_sentence(a, verdict));
    for (unsigned i = 0; i < verdict->pragma_count; i++) {
        buffer_text(out, "\n  - Pragma:          ");
        scalar(out, verdict->pragmas[i].text);
    }
    const plan_answer plan = verdict_plan(a, verdict);
    if (plan.word) {
        buffer_text(out, "\n  - Plan:            ");
        scalar(out, plan.word);
    }
    if (plan.cause) {
        buffer_text(out, "\n  - PlanCause:       ");
        scalar(out, plan.cause);
    }
    const lanes_remark *lanes = verdict_lanes(input, verdict);
    if (lanes && lanes->slug) {
        const ir_position why = lanes_position(input, lanes);
        buffer_text(out, "\n  - NoLanes:         ");
        scalar(out, lanes->slug);
        buffer_text(out, "\n    DebugLoc:        { File: ");
        scalar(out, why.file);
        buffer_format(out, ", Line: %u, Column: %u }", why.line, why.column);
    }
    if (is_refused) {
        const ir_position why = reason_position(input, verdict);
        buffer_text(out, "\n  - Reason:          ");
        scalar(out, reason_code(verdict->why.id));
        buffer_text(out, "\n    DebugLoc:        { File: ");
        scalar(out, why.file);
        buffer_format(out, ", Line: %u, Column: %u }", why.line, why.column);
    }
    buffer_text(out, "\n...\n");
}

void report_yaml(arena *a, buffer *out, const report_input *input) {
    for (unsigned i = 0; i < input->analysis->verdict_count; i++)
        record(a, out, input, &input->analysis->verdicts[i]);
}
