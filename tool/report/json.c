/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The JSON report. docs/report.md describes its fields. */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "report/facts.h"
#include "report/plan.h"
#include "support/json_text.h"

static json_t *arrays_of(const loop_verdict *verdict) {
    json_t *arrays = json_array();
    const loop_facts *facts = verdict->facts;
    for (unsigned i = 0; facts && i < facts->array_count; i++) {
        const reduction_array *array = &facts->arrays[i];
        json_t *one = json_object();
        json_object_set_new(one, "name", json_text(array->name));
        const char *op = reduction_operator_spelling(array->op);
        json_object_set_new(one, "operator", op ? json_text(op) : json_null());
        json_object_set_new(one, "type", json_text(element_word(array)));
        if (array->order_is_kept)
            json_object_set_new(one, "order", json_text("kept"));
        json_array_append_new(arrays, one);
    }
    return arrays;
}

static json_t *guards_of(arena *a, const loop_verdict *verdict) {
    json_t *guards = json_array();
    const text_list list = verdict_guards(a, verdict);
    for (unsigned i = 0; i < list.count; i++)
        json_array_append_new(guards, json_text(list.items[i]));
    return guards;
}

static json_t *external_of(const loop_verdict *verdict) {
    json_t *calls = json_array();
    for (unsigned i = 0; i < verdict->external_call_count; i++) {
        json_t *call = json_object();
        json_object_set_new(call, "function", json_text(verdict->external_calls[i].name));
        json_object_set_new(call, "file", json_text(verdict->external_calls[i].file));
        json_object_set_new(call, "is", json_text(verdict->external_calls[i].word));
        json_array_append_new(calls, call);
    }
    return calls;
}

static json_t *pragmas_of(const loop_verdict *verdict) {
    json_t *pragmas = json_array();
    for (unsigned i = 0; i < verdict->pragma_count; i++)
        json_array_append_new(pragmas, json_text(verdict->pragmas[i].text));
    return pragmas;
}

static json_t *reason_of(const report_input *input, const loop_verdict *verdict) {
    if (verdict->kind != VERDICT_REFUSE)
        return json_null();
    const ir_position at = reason_position(input, verdict);
    json_t *why = json_object();
    json_object_set_new(why, "id", json_text(reason_code(verdict->why.id)));
    json_object_set_new(why, "slug", json_text(reason_slug(verdict->why.id)));
    json_object_set_new(why, "message", json_text(verdict->why.message));
    json_object_set_new(why, "line", json_integer(at.line));
    json_object_set_new(why, "column", json_integer(at.column));
    return why;
}

static json_t *lanes_of(const report_input *input, const lanes_remark *lanes) {
    json_t *object = json_object();
    json_object_set_new(object, "written", json_boolean(!lanes->slug));
    if (!lanes->slug)
        return object;
    const ir_position at = lanes_position(input, lanes);
    json_object_set_new(object, "slug", json_text(lanes->slug));
    json_object_set_new(object, "message", json_text(lanes->message));
    json_object_set_new(object, "line", json_integer(at.line));
    json_object_set_new(object, "column", json_integer(at.column));
    return object;
}

static void add_plan(arena *a, json_t *loop, const report_input *input,
                     const loop_verdict *verdict) {
    const plan_answer plan = verdict_plan(a, verdict);
    if (!plan.word)
        return;
    json_object_set_new(loop, "plan", json_text(plan.word));
    if (!plan.cause)
        return;
    const ir_position at =
        ir_position_of(input->unit, plan.range.begin < plan.range.end ? plan.range.begin
                                                                      : verdict_offset(verdict));
    json_t *why = json_object();
    json_object_set_new(why, "message", json_text(plan.cause));
    json_object_set_new(why, "advice", plan.advice ? json_text(plan.advice) : json_null());
    json_object_set_new(why, "line", json_integer(at.line));
    json_object_set_new(why, "column", json_integer(at.column));
    json_object_set_new(loop, "plan_cause", why);
}

static json_t *loop_object(arena *a, const report_input *input, const loop_verdict *verdict) {
    const ir_position at = verdict_position(input, verdict);
    json_t *loop = json_object();
    if (strcmp(at.file, input->unit->source->path) != 0)
        json_object_set_new(loop, "file", json_text(at.file));
    json_object_set_new(loop, "line", json_integer(at.line));
    json_object_set_new(loop, "column", json_integer(at.column));
    json_object_set_new(loop, "function", json_text(verdict->function->name));
    json_object_set_new(loop, "verdict", json_text(verdict_word(verdict)));
    json_object_set_new(loop, "reason", reason_of(input, verdict));
    json_object_set_new(loop, "arrays", arrays_of(verdict));
    json_object_set_new(loop, "guards", guards_of(a, verdict));
    add_plan(a, loop, input, verdict);
    if (verdict->external_call_count > 0)
        json_object_set_new(loop, "from_other_files", external_of(verdict));
    if (verdict->pragma_count > 0)
        json_object_set_new(loop, "pragmas", pragmas_of(verdict));
    const lanes_remark *lanes = verdict_lanes(input, verdict);
    if (lanes)
        json_object_set_new(loop, "lanes", lanes_of(input, lanes));
    json_object_set_new(loop, "multiversioned", json_boolean(verdict_is_written(verdict)));
    return loop;
}

void report_json(arena *a, buffer *out, const report_input *input) {
    json_t *root = json_object();
    json_object_set_new(root, "redcc", json_text(input->version));
    json_object_set_new(root, "schema", json_integer(1)); /* docs/report.schema.json */
    json_object_set_new(root, "file", json_text(input->unit->source->path));
    json_object_set_new(root, "order", json_text(input->order));
    json_t *loops = json_array();
    for (unsigned i = 0; i < input->analysis->verdict_count; i++)
        json_array_append_new(loops, loop_object(a, input, &input->analysis->verdicts[i]));
    json_object_set_new(root, "loops", loops);
    json_print(out, root);
}
