/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "report/facts.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/openmp_loop.h"
#include "report/plan.h"

const char *verdict_word(const loop_verdict *verdict) {
    switch (verdict->kind) {
    case VERDICT_TRANSFORM:
    case VERDICT_BLOCKS:
        return "transformed";
    case VERDICT_REFUSE:
        return "refused";
    default:
        return "not-a-reduction";
    }
}

const char *element_word(const reduction_array *array) {
    return array->element && array->element->spelling ? array->element->spelling : "unknown";
}

static bool contains(const text_list *list, const char *text) {
    for (unsigned i = 0; i < list->count; i++)
        if (strcmp(list->items[i], text) == 0)
            return true;
    return false;
}

text_list verdict_guards(arena *a, const loop_verdict *verdict) {
    text_list guards = {0};
    if (verdict->kind != VERDICT_TRANSFORM)
        return guards;
    const loop_facts *facts = verdict->facts;
    for (unsigned i = 0; i < facts->array_count; i++)
        for (unsigned k = 0; k < facts->source_count; k++) {
            if (!facts->sources[k].needs_guard)
                continue;
            const char *guard = arena_format(a, "no-overlap(%s, %s)", facts->arrays[i].name,
                                             facts->sources[k].name);
            if (!contains(&guards, guard))
                VECTOR_PUSH(a, &guards, guard);
        }
    return guards;
}

static void append_array(buffer *out, const reduction_array *array, bool follows) {
    const char *op = reduction_operator_spelling(array->op);
    buffer_format(out, "%s%s (", follows ? ", " : "", array->name);
    if (op)
        buffer_format(out, "%s ", op);
    buffer_format(out, "%s%s)", element_word(array), array->order_is_kept ? ", order kept" : "");
}

static const char *array_list(arena *a, const loop_facts *facts) {
    buffer out = {0};
    for (unsigned i = 0; i < facts->array_count; i++)
        append_array(&out, &facts->arrays[i], i > 0);
    return buffer_take(a, &out);
}

static const char *scalar_list(arena *a, const fixed_blocks *blocks) {
    buffer out = {0};
    for (unsigned i = 0; i < blocks->scalar_count; i++)
        buffer_format(&out, "%s%s (%s)", i > 0 ? ", " : "", blocks->scalars[i].variable->name,
                      blocks->scalars[i].operator);
    return buffer_take(a, &out);
}

/* A phrase about what the loop updates under a lock, or "" if there is no lock. */
static const char *lock_words(arena *a, const fixed_blocks *blocks) {
    return blocks->lock
               ? arena_format(a, "; what '%s' protects is updated in any order", blocks->lock)
               : "";
}

static const char *plan_words(arena *a, const loop_verdict *verdict) {
    const char *plan = verdict_plan(a, verdict).word;
    return strcmp(plan, "never") == 0    ? "is translated, but stays sequential"
           : strcmp(plan, "remade") == 0 ? "runs in parallel, by a plan for each execution"
                                         : "runs in parallel";
}

const char *verdict_sentence(arena *a, const loop_verdict *verdict) {
    const char *function = verdict->function->name;
    switch (verdict->kind) {
    case VERDICT_TRANSFORM:
        return arena_format(a, "loop in '%s' %s: %s%s", function, plan_words(a, verdict),
                            array_list(a, verdict->facts),
                            verdict->facts->variables.openmp
                                ? "; its directive is replaced: same bits at every thread count"
                                : "");
    case VERDICT_BLOCKS:
        return arena_format(a,
                            "loop in '%s' runs by its directive, in fixed blocks: same bits at "
                            "every thread count: %s%s",
                            function, scalar_list(a, verdict->facts->variables.blocks),
                            lock_words(a, verdict->facts->variables.blocks));
    case VERDICT_REFUSE:
        return arena_format(a, "loop in '%s' stays %s: %s: %s", function,
                            verdict->facts && verdict->facts->variables.openmp ? "as it is"
                                                                               : "sequential",
                            reason_code(verdict->why.id), verdict->why.message);
    default:
        return arena_format(a, "loop in '%s' has no update by which iterations may conflict",
                            function);
    }
}

uint32_t verdict_offset(const loop_verdict *verdict) {
    for (const ir_node *node = verdict->loop; node; node = node->parent)
        if (node->range.begin < node->range.end)
            return node->range.begin;
    return verdict->function->range.begin;
}

ir_position verdict_position(const report_input *input, const loop_verdict *verdict) {
    const ir_position *elsewhere = ir_position_in_header(input->unit, verdict->loop);
    if (elsewhere)
        return *elsewhere;
    assert(verdict_offset(verdict) <= input->unit->source->length);
    return ir_position_of(input->unit, verdict_offset(verdict));
}

ir_position reason_position(const report_input *input, const loop_verdict *verdict) {
    assert(verdict->kind == VERDICT_REFUSE);
    const ir_range range = verdict->why.range;
    if (range.begin == range.end)
        return verdict_position(input, verdict);
    return ir_position_of(input->unit, range.begin);
}

const lanes_remark *verdict_lanes(const report_input *input, const loop_verdict *verdict) {
    if (!input->lanes || verdict->kind != VERDICT_TRANSFORM)
        return NULL;
    const lanes_remark *lanes = &input->lanes[verdict - input->analysis->verdicts];
    assert(lanes < input->lanes + input->analysis->verdict_count);
    return lanes->is_asked ? lanes : NULL;
}

ir_position lanes_position(const report_input *input, const lanes_remark *lanes) {
    return ir_position_of(input->unit, lanes->range.begin);
}

void report_write(arena *a, buffer *out, report_form form, const report_input *input) {
    assert(form <= REPORT_YAML);
    switch (form) {
    case REPORT_TEXT:
        report_text(a, out, input);
        break;
    case REPORT_JSON:
        report_json(a, out, input);
        break;
    case REPORT_SARIF:
        report_sarif(a, out, input);
        break;
    case REPORT_YAML:
        report_yaml(a, out, input);
        break;
    }
}
