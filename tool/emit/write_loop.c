/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/write_loop.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/distributed.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/loop_loads.h"
#include "analysis/base/loop_text.h"
#include "emit/as_compiled.h"
#include "emit/base/names.h"
#include "emit/base/step.h"
#include "emit/body/body.h"
#include "emit/body/live_out.h"
#include "emit/body/scalars.h"
#include "emit/call.h"
#include "emit/context.h"
#include "emit/continuation.h"
#include "emit/crew.h"
#include "emit/distribution.h"
#include "emit/macro_names.h"
#include "emit/outline.h"
#include "emit/sections.h"
#include "emit/sequential_copy.h"
#include "emit/text/origin.h"
#include "ir/ir_position.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"

static void write_execution(loop_text *loop, writer *out) {
    fill_context(loop, out);
    if (loop->continues)
        writer_line(out, "REDCC_MAY_CONTINUE;");
    writer_line(out, "redcc__done = REDCC_EXECUTED(%s, %s);", outlined_name(loop, "site"),
                outlined_name(loop, "member"));
    write_distributed_stores(loop, out);
}

/** Writes the parallel execution, inside the `if` in which the loop is known to iterate. Elsewhere
 * the expressions that it evaluates may be invalid. */
static void write_attempt(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    writer_line(out, "REDCC_ATTEMPT(%s, %u, %u, %u);", outlined_name(loop, "context"),
                facts->array_count, loop->plan->source_count, loop->plan->execution.key_count);
    write_team(loop, out);
    write_sections(loop, out);
    if (loop->plan->prefetch.ahead > 0)
        writer_line(out, "REDCC_PREFETCH(%u);", loop->plan->prefetch.ahead);
    if (loop->options->linked)
        writer_line(out, "redcc__attempt.linkage = redcc__linked();");
    declare_extents(loop, out);
    declare_operands(loop, out);
    if (loop->plan->prefetch.ahead > 0)
        writer_line(out, "REDCC_NO_PROGRESSIONS;");
    write_starts(loop, out);
    declare_entry_values(loop, out, false);
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].is_scattered)
            writer_line(out, "redcc__bases[%u] = 0;", i);
        else
            writer_line(out, "REDCC_BASE(%u, %s);", i,
                        macro_argument(loop->arena, loop_operand(loop, facts->arrays[i].base)));
    fill_key(loop, out);
    fill_extents(loop, out);
    const char *known = extents_condition(loop);
    if (known) {
        writer_line(out, "if (%s) {", known);
        out->depth++;
    }
    write_execution(loop, out);
    if (known) {
        out->depth--;
        writer_line(out, "}");
    }
    apply_operands(loop, out);
}

/** Writes the assignments of live-out variables, in the branch that is the alternative to the
 * sequential form, so that compilers see the variables assigned on every path. */
static void write_outcome(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    out->depth++;
    const bool is_wanted = loop->continues && !facts->counted.counter_is_declared_in_header;
    if (is_wanted || counter_outlives(facts))
        writer_line(out, loop->continues ? "%s = (%s)(%s);" : "%s = (%s)%s;",
                    origin_variable(loop->arena, facts->counted.counter), loop->counter_type,
                    counter_after(loop));
    take_live_outs(loop, out);
    write_stepped_values(loop, out);
    take_conditional_live_outs(loop, out);
    out->depth--;
}

static const char *heading(loop_text *loop) {
    buffer out = {0};
    for (unsigned i = 0; i < loop->facts->array_count; i++) {
        const reduction_array *array = &loop->facts->arrays[i];
        buffer_format(&out, "%s%s (%s)", i > 0 ? ", " : "", array->name,
                      array->order_is_kept ? "order kept" : reduction_operator_spelling(array->op));
    }
    /* empty if a name contains the end of a comment (in a string, or in a comment of its own) */
    const char *text = strstr(out.data, "*/") ? "" : arena_copy(loop->arena, out.data, out.length);
    buffer_free(&out);
    return text;
}

const char *loop_condition(const loop_text *loop) {
    const bool has_branch = has_branches(loop), rounds = loop->facts->slice.has_floating_work;
    if (!has_branch && !rounds)
        return "#ifdef REDCC_RUNTIME_H\n";
    return arena_format(loop->arena, "#if defined(REDCC_RUNTIME_H)%s%s\n",
                        has_branch ? " && defined(redcc__as_compiled)" : "",
                        rounds ? " && REDCC_ROUNDS_ALIKE" : "");
}

/** Writes a comment with the reason why the loop has no lanes, if they were requested. */
static void write_no_lanes(const loop_text *loop, writer *out) {
    const lanes_outcome *outcome = loop->lanes.outcome;
    if (outcome && outcome->why != LANES_WRITTEN)
        writer_line(out, "/* redcc: one iteration at a time: line %u: %s (%s) */",
                    ir_position_of(loop->unit, outcome->range.begin).line,
                    lane_reason_message(outcome->why), lane_reason_slug(outcome->why));
}

/** Writes the opening brace of the loop's block, and a comment. Compilations that take other
 * branches (as_compiled.h) do not see the brace. */
static void open_block(loop_text *loop, writer *out, uint32_t begin) {
    static const char *const promises[] = {"with the bits of the sequential loop",
                                           "with the same bits at every thread count",
                                           "in any order"};
    _Static_assert(sizeof promises / sizeof *promises == ORDER_ANY + 1, "all orders");
    assert(loop->options->order <= ORDER_ANY);
    if (has_branches(loop)) {
        buffer_byte(&out->out, '\n');
        begin_as_compiled(loop, &out->out);
        buffer_text(&out->out, "#ifdef redcc__as_compiled\n");
    }
    /* broken as if the columns before it were blanks */
    const char *blanks = loop_column_blanks(loop, begin);
    writer line = {0};
    writer_line(&line, "%s{ /* redcc: in parallel, %s: %s */", has_branches(loop) ? "" : blanks,
                promises[loop->plan->execution.order], heading(loop));
    const char *text = writer_text(loop->arena, &line);
    buffer_text(&out->out, has_branches(loop) ? text : text + strlen(blanks));
    buffer_text(&out->out, has_branches(loop) ? "#endif\n" : "");
    write_no_lanes(loop, out);
}

/** Declares pointers that are loaded before the loop. Returns a condition, " && ...", that loads
 *  the pointers one after the other and becomes false at the first one that is not readable. */
static const char *write_loads(loop_text *loop, writer *out) {
    const loop_loads *loads = loop->facts->variables.loads;
    const char *site = outlined_name(loop, "site"), *all = "";
    if (reads_by_system(loop))
        all = arena_format(loop->arena, " && REDCC_MAY_LOAD(%s, %s)", site,
                           outlined_name(loop, "loaded"));
    for (unsigned i = 0; loads && i < loads->count; i++) {
        const loop_load *load = &loads->items[i];
        writer_line(out, "%s;",
                    assignable_declaration_text(loop, load->variable->type, load->variable->name));
        all = arena_format(loop->arena, "%s && REDCC_LOAD(%s, %s, %s, %lld)", all, site,
                           load->variable->name, origin_variable(loop->arena, load->through),
                           (long long)load->offset);
    }
    return all;
}

/** Writes the parallel form. Returns where the text of the original loop that is still to be
 * written begins; the loop's text begins at `begin`. */
static uint32_t write_parallel_form(loop_text *loop, writer *out, uint32_t begin) {
    open_block(loop, out, begin);
    buffer_text(&out->out, loop_condition(loop));
    out->depth = 1;
    writer_line(out, "%sREDCC_QUIET_BEGIN", loop->is_unfused ? "REDCC_UNFUSED_BLOCK " : "");
    write_meeting(loop, out);
    declare_replaces(loop, out);
    const char *entry = write_trip_count(loop, out, outlined_name(loop, "site"));
    declare_entry_values(loop, out, true);
    declare_live_outs(loop, out);
    declare_conditional_live_outs(loop, out);
    writer_line(out, "int redcc__done = 0;");
    if (loop->continues) {
        writer_line(out, "redcc_int redcc__made = redcc__trip;");
        writer_line(out, "REDCC_OVER_AT_JUMPS(%s);", outlined_name(loop, "site"));
    }
    const char *loaded = write_loads(loop, out);
    writer_line(out, "if (%s%s%s) {", replaced_condition(loop), entry, loaded);
    out->depth++;
    write_attempt(loop, out);
    out->depth--;
    writer_line(out, "}");
    /* not `if (!redcc__done)`: compilers would warn of an ambiguous `else` in the loop */
    writer_line(out, "REDCC_QUIET_END if (redcc__done) {");
    write_outcome(loop, out);
    const bool is_open = loop->facts->slice.exits && loop->facts->slice.exits->open;
    if (loop->continues && !is_open) {
        writer_line(out, "}");
        writer_line(out, "if (redcc__done && redcc__made == redcc__trip) {");
    }
    writer_line(out, is_open ? "}" : "} else");
    if (loop->facts->variables.openmp)
        write_sequential_copy(loop, out);
    if (loop->continues)
        begin = write_continued_header(loop, out, begin);
    buffer_text(&out->out, "#endif\n");
    return begin;
}

static void write_sequential_form(loop_text *loop, writer *out, ir_range range) {
    const char *text = loop->whole->source->text;
    buffer_format(&out->out, "%s\n%s", loop_line_directive(loop, range.begin),
                  loop_column_blanks(loop, range.begin));
    origin_copy(&out->out, text, range.begin, range.end);
}

/** Is the line of the file that contains this place too long for `more` bytes in addition? */
static bool is_too_long(const loop_text *loop, uint32_t place, size_t more) {
    const source *text = loop->unit->source;
    const uint32_t begin = text->line_begin[source_position(text, place).line - 1];
    return strcspn(text->text + begin, "\r\n") + more > MOST_COLUMNS;
}

/** Writes the end of the block. The timing of the sequential loop ends there. */
static void write_timing(loop_text *loop, writer *out, ir_range range) {
    const bool has_condition = /* some compilations do not time the loop */
        loop->facts->slice.has_floating_work || has_crew(loop);
    const char *site = outlined_name(loop, "site");
    const char *over = arena_format(loop->arena, "REDCC_OVER(%s)", site);
    if (!has_condition && !has_branches(loop) &&
        !is_too_long(loop, range.end - 1, strlen(over) + strlen("  }"))) {
        buffer_format(&out->out, " %s }", over);
        return;
    }
    buffer_byte(&out->out, '\n');
    if (!has_condition && !has_branches(loop))
        writer_line(out, "%s", over);
    if (has_condition) {
        buffer_text(&out->out, loop_condition(loop));
        writer_line(out, "REDCC_OVER(%s)", site);
        if (has_crew(loop))
            write_parting(loop, out);
        buffer_text(&out->out, "#endif\n");
    }
    if (has_branches(loop)) {
        buffer_format(&out->out, "#ifdef redcc__as_compiled\n%s }\n#endif\n",
                      has_condition ? "" : arena_format(loop->arena, "REDCC_OVER(%s)", site));
        end_as_compiled(loop, &out->out);
        buffer_format(&out->out, "%s\n%s", loop_line_directive(loop, range.end),
                      loop_column_blanks(loop, range.end));
    } else {
        buffer_format(&out->out, "%s\n%s}", loop_line_directive(loop, range.end - 1),
                      loop_column_blanks(loop, range.end - 1));
    }
}

/** Writes the text before the function, in the first form, from *form on, that is possible. */
static void write_front(loop_text *loop, loop_form *form, loop_piece *front) {
    for (;; (*form)++) {
        loop->lanes =
            (lanes_text){.is_wanted = *form == FORM_LANES, .outcome = loop->lanes.outcome};
        loop->bins = NULL;
        if (*form == FORM_LANES && loop->plan->no_lanes != LANES_WRITTEN)
            continue;
        if (*form == FORM_BINNED)
            loop->bins = loop->plan->bins;
        if (*form == FORM_BINNED && !loop->bins)
            continue;
        front->text = write_outlined(loop, &front->replaced.begin);
        front->replaced.end = front->replaced.begin;
        if ((front->text && (*form != FORM_LANES || loop->lanes.name)) || *form == FORM_SHORT ||
            !loop->facts->inspector.exists)
            break;
        loop->obstacle = NULL; /* the next form may have none */
    }
    lanes_outcome *outcome = loop->lanes.outcome;
    if (outcome && *form != FORM_LANES && outcome->why == LANES_WRITTEN)
        *outcome = (lanes_outcome){NO_LANES_PLACE, loop->facts->loop->range};
}

bool write_loop(loop_text loop, loop_form *form, loop_piece *front, loop_piece *block,
                reason *why) {
    const ir_node *whole = loop.facts->loop;
    writer out = {0};
    distributed_take_out(loop.facts->distribution);
    loop_exits_take_out(loop.facts->slice.exits);
    loop_loads_take_out(loop.facts->variables.loads);
    set_names(&loop);
    loop.continues = loop.plan->execution.may_continue && !has_branches(&loop);
    if (!loop.continues && loop.facts->slice.exits && loop.facts->slice.exits->open)
        loop_obstacle(&loop, whole->range, "it has no bound, and directives in its text");
    write_front(&loop, form, front);
    if (!front->text) {
        loop_loads_put_back(loop.facts->variables.loads);
        loop_exits_put_back(loop.facts->slice.exits);
        distributed_put_back(loop.facts->distribution);
        *why = (reason){.message = loop.obstacle, .range = loop.obstacle_range};
        return false;
    }
    block->replaced = (ir_range){loop_text_begin(loop.whole, whole),
                                 syntax_statement_end(loop.unit->source, whole)};
    assert(block->replaced.begin <= whole->range.begin && whole->range.end <= block->replaced.end);
    const uint32_t rest = write_parallel_form(&loop, &out, block->replaced.begin);
    write_sequential_form(&loop, &out, (ir_range){rest, block->replaced.end});
    write_timing(&loop, &out, block->replaced);
    assert(out.depth == 1);
    check_macro_names(&loop, &out.out);
    block->text = writer_text(loop.arena, &out);
    loop_loads_put_back(loop.facts->variables.loads);
    loop_exits_put_back(loop.facts->slice.exits);
    distributed_put_back(loop.facts->distribution);
    *why = (reason){.message = loop.obstacle, .range = loop.obstacle_range};
    return !loop.obstacle;
}
