/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Remarks in the form that clang prints and editors read. */
#include <assert.h>
#include <string.h>

#include "analysis/base/openmp_loop.h"
#include "report/facts.h"
#include "report/plan.h"

/** Appends the source line with a caret below it. */
static void show_place(buffer *out, const ir_unit *unit, uint32_t offset) {
    const source *s = unit->source;
    const position at = source_position(s, offset);
    const uint32_t begin = s->line_begin[at.line - 1];
    assert(begin <= offset && offset <= s->length);
    uint32_t end = begin;
    while (end < s->length && s->text[end] != '\n' && s->text[end] != '\r')
        end++;
    buffer_text(out, "    ");
    buffer_append(out, s->text + begin, end - begin);
    buffer_text(out, "\n    ");
    for (uint32_t i = begin; i < offset; i++)
        buffer_byte(out, s->text[i] == '\t' ? '\t' : ' ');
    buffer_text(out, "^\n");
}

static void message(buffer *out, const report_input *input, uint32_t offset, const char *kind,
                    const char *text, const char *flag) {
    const ir_position at = ir_position_of(input->unit, offset);
    buffer_format(out, "%s:%u:%u: %s: %s%s\n", at.file, at.line, at.column, kind, text, flag);
    show_place(out, input->unit, offset);
}

static bool has_place(ir_range range) {
    return range.begin < range.end;
}

/** Appends notes for facts that come from other files. */
static void by_other_files(arena *a, buffer *out, const report_input *input,
                           const loop_verdict *verdict) {
    for (unsigned i = 0; i < verdict->external_call_count; i++) {
        const external_call *call = &verdict->external_calls[i];
        message(out, input, has_place(call->range) ? call->range.begin : verdict_offset(verdict),
                "note",
                arena_format(a,
                             "'%s' is %s in %s: say so where it is declared, or this loop stays "
                             "sequential when its file is translated",
                             call->name, call->word, call->file),
                "");
    }
}

/** Appends notes for assertions of the user's pragmas. */
static void by_pragma(arena *a, buffer *out, const report_input *input,
                      const loop_verdict *verdict) {
    for (unsigned i = 0; i < verdict->pragma_count; i++)
        message(out, input, verdict->pragmas[i].range.begin, "note",
                arena_format(a, "as you assert: %s", verdict->pragmas[i].text), "");
}

/** Appends a note that says why the loop's plan is not kept, or why the loop stays sequential. */
static void say_plan(arena *a, buffer *out, const report_input *input,
                     const loop_verdict *verdict) {
    const plan_answer plan = verdict_plan(a, verdict);
    if (!plan.cause)
        return;
    const char *text = strcmp(plan.word, "never") == 0
                           ? plan.cause
                           : arena_format(a, "each execution makes a plan: %s%s%s", plan.cause,
                                          plan.advice ? "; " : "", plan.advice ? plan.advice : "");
    message(out, input, has_place(plan.range) ? plan.range.begin : verdict_offset(verdict), "note",
            text, "");
}

static void transformed(arena *a, buffer *out, const report_input *input,
                        const loop_verdict *verdict) {
    const loop_facts *facts = verdict->facts;
    message(out, input, verdict_offset(verdict), "remark", verdict_sentence(a, verdict),
            " [-Rredcc=reduction]");
    for (unsigned i = 0; i < facts->update_count; i++)
        if (has_place(facts->updates[i].target->range))
            message(out, input, facts->updates[i].target->range.begin, "note",
                    arena_format(a, "'%s' is updated here",
                                 facts->arrays[facts->updates[i].array].name),
                    "");
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        bool is_first = read->needs_guard;
        for (unsigned k = 0; k < i && is_first; k++)
            is_first =
                !facts->sources[k].needs_guard || strcmp(facts->sources[k].name, read->name) != 0;
        if (is_first && has_place(read->row->range))
            message(out, input, read->row->range.begin, "note",
                    arena_format(a,
                                 "runs sequentially where '%s' is found to overlap an array "
                                 "that is updated",
                                 read->name),
                    "");
    }
    say_plan(a, out, input, verdict);
    const char *in_order =
        input->in_order ? input->in_order[verdict - input->analysis->verdicts] : NULL;
    if (in_order)
        message(out, input, verdict_offset(verdict), "note",
                arena_format(a, "the updates keep the sequential order: %s", in_order), "");
    const lanes_remark *lanes = verdict_lanes(input, verdict);
    if (lanes && lanes->slug)
        message(out, input, lanes->range.begin, "note",
                arena_format(a, "one iteration at a time: %s (%s)", lanes->message, lanes->slug),
                "");
    by_other_files(a, out, input, verdict);
    by_pragma(a, out, input, verdict);
}

/** Appends the remark on a loop in a header, without the source line. */
static void in_header(arena *a, buffer *out, const ir_position *at, const loop_verdict *verdict) {
    const bool is_refused = verdict->kind == VERDICT_REFUSE;
    buffer_format(out, "%s:%u:%u: remark: %s [-Rredcc-%s%s]\n", at->file, at->line, at->column,
                  verdict_sentence(a, verdict), is_refused ? "missed=" : "analysis=",
                  is_refused ? reason_slug(verdict->why.id) : "not-a-reduction");
    if (is_refused && verdict->why.advice)
        buffer_format(out, "%s:%u:%u: note: %s\n", at->file, at->line, at->column,
                      verdict->why.advice);
}

static void refused(arena *a, buffer *out, const report_input *input, const loop_verdict *verdict) {
    message(out, input, verdict_offset(verdict), "remark", verdict_sentence(a, verdict),
            arena_format(a, " [-Rredcc-missed=%s]", reason_slug(verdict->why.id)));
    const char *advice = verdict->why.advice;
    if (has_place(verdict->why.range) && verdict->why.range.begin != verdict->loop->range.begin)
        message(out, input, verdict->why.range.begin, "note", advice ? advice : "here", "");
    else if (advice)
        message(out, input, verdict_offset(verdict), "note", advice, "");
    by_pragma(a, out, input, verdict);
}

static void in_blocks(arena *a, buffer *out, const report_input *input,
                      const loop_verdict *verdict) {
    const fixed_blocks *blocks = verdict->facts->variables.blocks;
    message(out, input, verdict_offset(verdict), "remark", verdict_sentence(a, verdict),
            " [-Rredcc=reduction]");
    if (blocks->lock && blocks->unordered)
        message(out, input, verdict_offset(verdict), "note",
                arena_format(a, "what '%s' protects keeps no order: %s", blocks->lock,
                             blocks->unordered),
                "");
}

void report_text(arena *a, buffer *out, const report_input *input) {
    for (unsigned i = 0; i < input->analysis->verdict_count; i++) {
        const loop_verdict *verdict = &input->analysis->verdicts[i];
        const ir_position *elsewhere = ir_position_in_header(input->unit, verdict->loop);
        if (elsewhere)
            in_header(a, out, elsewhere, verdict);
        else if (verdict->kind == VERDICT_TRANSFORM)
            transformed(a, out, input, verdict);
        else if (verdict->kind == VERDICT_BLOCKS)
            in_blocks(a, out, input, verdict);
        else if (verdict->kind == VERDICT_REFUSE)
            refused(a, out, input, verdict);
        else
            message(out, input, verdict_offset(verdict), "remark", verdict_sentence(a, verdict),
                    " [-Rredcc-analysis=not-a-reduction]");
    }
}
