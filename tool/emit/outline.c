/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes slice and body of a loop as functions before the user's function; redcc/loop.h has the
 * code around them. Compilers inline both at each use, except in a loop with lanes. */
#include "emit/outline.h"

#include <string.h>

#include "emit/as_compiled.h"
#include "emit/base/names.h"
#include "emit/bins/bins.h"
#include "emit/body/body.h"
#include "emit/body/series.h"
#include "emit/body/tile_rows.h"
#include "emit/call.h"
#include "emit/context.h"
#include "emit/lanes/lanes.h"
#include "emit/macro_names.h"
#include "emit/region.h"
#include "emit/slice/slice.h"
#include "emit/text/origin.h"
#include "emit/write_loop.h"
#include "ir/ir_position.h"
#include "plan/bins.h"
#include "plan/inner_iterations.h"
#include "plan/lookup.h"
#include "plan/outline.h"
#include "plan/place.h"
#include "plan/tiles.h"

/* ---- heads and calls ----------------------------------------------------------------------- */

/** Marks each variable that the body names, except in parts that are replaced. */
static void mark_mentioned(const loop_text *loop, const ir_node *node, bool *is_mentioned) {
    const int array = loop_array_of_base(loop->facts, node);
    const int scalar = scalar_update_at(loop->facts, node);
    if (scalar >= 0) {
        if (loop->facts->scalars[scalar].value)
            mark_mentioned(loop, loop->facts->scalars[scalar].value, is_mentioned);
        return;
    }
    if (node == body_increment(loop->facts))
        return;
    if (array >= 0 && !loop->arrays[array].is_shadowed)
        return;
    if (node->kind == IR_OPAQUE)
        is_mentioned[loop->unit->variable_count] = true;
    if (node->kind == IR_VARIABLE)
        is_mentioned[node->variable->id] = true;
    for (unsigned i = 0; i < node->child_count; i++)
        mark_mentioned(loop, node->children[i], is_mentioned);
}

static void mark_variables(const ir_node *node, bool *is_mentioned) {
    if (node->kind == IR_VARIABLE)
        is_mentioned[node->variable->id] = true;
    for (unsigned i = 0; i < node->child_count; i++)
        mark_variables(node->children[i], is_mentioned);
}

static const char *counter_parameter(loop_text *loop, bool is_used) {
    return arena_format(loop->arena, "%s%s", passed_declaration(loop, loop->facts->counted.counter),
                        is_used ? "" : " __attribute__((__unused__))");
}

typedef struct head {
    buffer parameters, arguments;
} head;

static void add_variables(loop_text *loop, const bool *is_mentioned, bool of_body, head *h) {
    for (unsigned i = 0; i < loop->unit->variable_count; i++) {
        const ir_variable *variable = loop->unit->variables[i];
        const passing how =
            is_mentioned[i] ? passing_of(loop->plan, variable, of_body) : NOT_PASSED;
        if (how == CANNOT_BE_PASSED)
            loop_obstacle(loop, loop->facts->loop->range,
                          "'%s' cannot be passed to a separate function", variable->name);
        if (how == NOT_PASSED || how == CANNOT_BE_PASSED)
            continue;
        loop->outline.is_passed[i] = true;
        buffer_format(&h->parameters, ", %s", passed_declaration(loop, variable));
        buffer_format(&h->arguments, ", %s", passed_argument(loop, variable));
    }
}

/** Determines which variables are passed by address. Called before any text is written. */
static void name_pointed(loop_text *loop) {
    loop->outline.by_address =
        ARENA_ARRAY(loop->arena, const char *, loop->unit->variable_count + 1);
    bool *is_mentioned = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    mark_variables(loop->facts->counted.body, is_mentioned);
    for (unsigned i = 0; i < loop->unit->variable_count; i++) {
        const ir_variable *variable = loop->unit->variables[i];
        if (is_mentioned[i] && passing_of(loop->plan, variable, false) == PASSED_BY_ADDRESS)
            loop->outline.by_address[i] =
                arena_format(loop->arena, "(*%s)", pointer_name(loop, variable));
    }
}

static void add_extra(const extra_value *value, void *context) {
    head *h = context;
    buffer_format(&h->parameters, ", %s", value->declaration);
    buffer_format(&h->arguments, ", %s", value->name);
}

/** Adds the text to outline.text. The context passes each value that is named there. */
static void remember_text(loop_text *loop, const char *text) {
    loop->outline.text = arena_format(loop->arena, "%s%s", loop->outline.text, text);
}

static void add_stand_ins(loop_text *loop, head *h) {
    for (unsigned i = 0; i < loop->facts->array_count; i++) {
        const array_text *array = &loop->arrays[i];
        if (!array->local)
            continue;
        const ir_type *row = loop->facts->arrays[i].base->type->target;
        if (!row || row->size <= 0) {
            loop->outline.possible = false;
            continue;
        }
        const char *name = arena_format(loop->arena, "*%s", array->declarator);
        if (row->spelling)
            buffer_format(&h->parameters, ", %s", declaration_text(loop, row, name));
        else
            buffer_format(&h->parameters, ", void *const redcc__start_%u", i);
        buffer_format(&h->arguments, ", redcc__base_%u", i);
    }
}

/** Writes the slice as a function of that name; returns its call. */
static const char *write_slice_as(loop_text *loop, const char *function, writer *out) {
    const loop_facts *facts = loop->facts;
    bool *is_mentioned = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    writer statements = {.depth = 1};
    head h = {0};
    write_slice_statements(loop, &statements, is_mentioned);
    const char *text = writer_text(loop->arena, &statements);
    const bool is_used = is_mentioned[facts->counted.counter->id];
    add_variables(loop, is_mentioned, false, &h);
    for_each_extra(loop, text, add_extra, &h);
    remember_text(loop, text);
    const bool is_unfused = loop->is_unfused && facts->slice.has_floating_work;
    writer_line(out, "%s %s(REDCC_SLICE_PARAMETERS, %s%s) {%s",
                loop->lanes.is_wanted ? "REDCC_SLICE_OF_LANES" : "REDCC_SLICE", function,
                counter_parameter(loop, is_used), buffer_take(loop->arena, &h.parameters),
                is_unfused ? " REDCC_UNFUSED_BLOCK" : "");
    if (loop->lanes.is_wanted)
        writer_line(out, "    REDCC_LANES_BY_CALLS");
    buffer_text(&out->out, text);
    writer_line(out, "}");
    return arena_format(loop->arena, "%s(REDCC_SLICE_ARGUMENTS, %s%s)", function,
                        loop_counter_value(loop), buffer_take(loop->arena, &h.arguments));
}

static bool holds_work(const ir_node *node) {
    if (ir_is_loop(node) || node->kind == IR_CALL)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (ir_is_expression(node->children[i]) && holds_work(node->children[i]))
            return true;
    return false;
}

/** Does the inspector's slice have loops or calls that the addresses of reads do not need? */
static bool computes_more(const loop_slice *slice, const ir_node *node) {
    if (ir_is_expression(node))
        return false;
    if (slice->holds[node->id] && !slice->reads[node->id] && holds_work(node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (computes_more(slice, node->children[i]))
            return true;
    return false;
}

/** Writes a slice that logs only the reads, without computing the subscripts of updates. It is for
 * executions that append records. Returns the call of this slice, or NULL if none is written. */
static const char *write_slice_of_reads(loop_text *loop, writer *out) {
    const loop_plan *plan = loop->plan;
    const loop_facts *facts = loop->facts;
    if (!loop->bins || !loop->bins->guarded_sources || !facts->slice.reads ||
        plan_has_leaders(plan) || !computes_more(&facts->slice, facts->counted.body))
        return NULL;
    loop_facts reads = *facts;
    loop_plan recorded = *plan;
    int *numbers = ARENA_ARRAY(loop->arena, int, facts->source_count + 1);
    for (unsigned i = 0; i < facts->source_count; i++) {
        const int number = plan->source_number[i];
        const bool is_recorded = number >= 0 && loop->bins->guarded_sources >> number & 1 &&
                                 facts->sources[i].needs_guard;
        numbers[i] = is_recorded ? number : SOURCE_NOT_LOGGED;
    }
    reads.slice.holds = (bool *)facts->slice.reads;
    reads.slice.has_rows = false;
    recorded.facts = &reads;
    recorded.source_number = numbers;
    loop->facts = &reads;
    loop->plan = &recorded;
    const char *call = write_slice_as(loop, outlined_name(loop, "reads"), out);
    loop->facts = facts;
    loop->plan = plan;
    return call;
}

static void write_slice(loop_text *loop, writer *out) {
    loop->outline.slice_call = write_slice_as(loop, outlined_name(loop, "slice"), out);
    loop->outline.reads_call = write_slice_of_reads(loop, out);
    const bool has_repeated = loop->bins && !plan_has_leaders(loop->plan) &&
                              loop->bins->varied_sources != loop->bins->guarded_sources;
    if (!loop->outline.reads_call && (has_repeated || bins_have_spans(loop)))
        loop->outline.reads_call = loop->outline.slice_call;
}

static bool names_by_address(const loop_text *loop) {
    for (unsigned i = 0; i < loop->unit->variable_count; i++)
        if (loop->outline.by_address[i])
            return true;
    return false;
}

/** Declares the pointers that replace arrays whose element type has no name. */
static void declare_stand_ins(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->array_count; i++) {
        const ir_type *row = loop->facts->arrays[i].base->type->target;
        if (loop->arrays[i].local && row && !row->spelling)
            writer_line(out, "__typeof__(&%s[0]) %s = redcc__start_%u;",
                        loop_operand(loop, loop->facts->arrays[i].base), loop->arrays[i].declarator,
                        i);
    }
}

/** Makes the context pass the scalars of series, which each thread's last statements access. */
static void pass_series(loop_text *loop) {
    bool *is_mentioned = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    head unused = {0};
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (loop->facts->scalars[i].is_series && !is_scalar_by_value(loop, i))
            mark_variables(loop->facts->scalars[i].target, is_mentioned);
    add_variables(loop, is_mentioned, false, &unused);
    buffer_free(&unused.parameters);
    buffer_free(&unused.arguments);
}

/** Sets parameters and arguments of the body in *h, and returns its statements. */
static const char *write_iteration_for(loop_text *loop, head *h) {
    const loop_facts *facts = loop->facts;
    bool *is_mentioned = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    mark_mentioned(loop, facts->counted.body, is_mentioned);
    loop->outline.possible &= !is_mentioned[loop->unit->variable_count];
    for (unsigned i = 0; i < facts->array_count; i++)
        if (loop->arrays[i].local && facts->arrays[i].base->type->target &&
            !facts->arrays[i].base->type->target->spelling)
            mark_variables(facts->arrays[i].base, is_mentioned); /* the pointer's type is taken from
                                                                  * the base */
    add_variables(loop, is_mentioned, true, h);
    add_stand_ins(loop, h);
    writer iteration = {.depth = 1};
    declare_stand_ins(loop, &iteration);
    write_iteration(loop, &iteration);
    const char *text = writer_text(loop->arena, &iteration);
    for_each_extra(loop, text, add_extra, h);
    return text;
}

/** Writes the function for the part of an iteration that lies in a tile. If that is impossible, the
 *  loop has no tiles. */
static void write_tile_body(loop_text *loop, writer *out) {
    head h = {0};
    loop->tiles = loop->lanes.is_wanted || loop->obstacle ? NULL : tiles_of(loop->plan);
    if (!loop->tiles)
        return;
    const char *text = write_iteration_for(loop, &h);
    const char *parameters = buffer_take(loop->arena, &h.parameters);
    const char *arguments = buffer_take(loop->arena, &h.arguments);
    loop->tiles = NULL;
    if (loop->obstacle) {
        loop->obstacle = NULL;
        return;
    }
    remember_text(loop, text);
    declare_tile_row(loop, out);
    loop->outline.tile_call =
        arena_format(loop->arena, "%s(REDCC_TILE_ARGUMENTS, %s%s)", outlined_name(loop, "tile"),
                     loop_counter_value(loop), arguments);
    writer_line(out, "REDCC_BODY %s(REDCC_TILE_PARAMETERS, %s%s) {%s", outlined_name(loop, "tile"),
                counter_parameter(loop, true), parameters,
                loop->is_unfused ? " REDCC_UNFUSED_BLOCK" : "");
    buffer_text(&out->out, text);
    writer_line(out, "}");
}

static void write_body(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    head h = {0};
    const char *text = write_iteration_for(loop, &h);
    remember_text(loop, text);
    const unsigned count = facts->array_count;
    const char *kind = loop->bins ? "BINNED" : "BODY";
    loop->outline.body_arguments = buffer_take(loop->arena, &h.arguments);
    loop->outline.body_parameters = buffer_take(loop->arena, &h.parameters);
    loop->outline.body_call =
        arena_format(loop->arena, "%s(REDCC_%s_ARGUMENTS_%u, %s%s)", outlined_name(loop, "body"),
                     kind, count, loop_counter_value(loop), loop->outline.body_arguments);
    writer_line(out, "%s %s(REDCC_%s_PARAMETERS_%u, %s%s) {%s",
                loop->lanes.is_wanted ? "REDCC_SCALAR_BODY" : "REDCC_BODY",
                outlined_name(loop, "body"), kind, count,
                counter_parameter(loop, body_reads(facts, facts->counted.counter)),
                loop->outline.body_parameters, loop->is_unfused ? " REDCC_UNFUSED_BLOCK" : "");
    if (loop->lanes.is_wanted)
        writer_line(out, "    REDCC_LANES_BY_CALLS");
    buffer_text(&out->out, text);
    writer_line(out, "}");
    if (!names_by_address(loop))
        write_lanes(loop, out);
}

/** Writes the function that each thread calls. It copies the context's values, then inspects and
 * executes iterations. */
static void write_member(loop_text *loop, writer *out) {
    writer_line(out, "%sREDCC_MEMBER %s(REDCC_MEMBER_PARAMETERS) {",
                loop->is_unfused ? "REDCC_UNFUSED " : "", outlined_name(loop, "member"));
    out->depth++;
    if (loop->plan->prefetch.ahead > 0)
        writer_line(out, "REDCC_PREFETCH(%u);", loop->plan->prefetch.ahead);
    take_context(loop, out);
    write_region(loop, out);
    out->depth--;
    writer_line(out, "}");
}

/** Writes the function for updates on private copies, if there is one. */
static void write_copier(loop_text *loop, writer *out) {
    if (!bins_have_copier(loop))
        return;
    writer_line(out, "%sREDCC_COPIER %s(REDCC_COPIER_PARAMETERS) {",
                loop->is_unfused ? "REDCC_UNFUSED " : "", outlined_name(loop, "copies"));
    out->depth++;
    take_context(loop, out);
    writer_line(out, "REDCC_COPY_CHUNK(%s,", bins_copied(loop));
    writer_line(out, "    %s,",
                loop->outline.reads_call ? loop->outline.reads_call : loop->outline.slice_call);
    writer_line(out, "    %s)", loop->outline.body_call);
    out->depth--;
    writer_line(out, "}");
}

/** Writes all text before the function. Slice and body are written to a buffer first, because they
 * determine which declarations must precede them. */
static void write_parts(loop_text *loop, writer *out) {
    writer parts = {0}, last = {0};
    write_slice(loop, &parts);
    write_body(loop, &parts);
    write_tile_body(loop, &parts);
    pass_series(loop);
    remember_text(loop, loop_counter_value(loop));
    write_thread_end(loop, &last);
    remember_text(loop, writer_text(loop->arena, &last));
    declare_inlined(loop, out);
    const bool is_context_first = bins_have_spans(loop);
    if (is_context_first)
        write_context(loop, out);
    if (loop->bins)
        write_bins(loop, out);
    write_description(loop, out);
    if (!is_context_first)
        write_context(loop, out);
    buffer_text(&out->out, writer_text(loop->arena, &parts));
    write_copier(loop, out);
    write_member(loop, out);
}

const char *write_outlined(loop_text *loop, uint32_t *place) {
    const loop_facts *facts = loop->facts;
    loop->outline.possible = true;
    writer out = {0};
    const bool is_in_line = place_in_front(loop->unit, facts->function, place);
    buffer_text(&out.out, is_in_line ? "\n" : "");
    loop->outline.is_passed = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    loop->outline.text = "";
    loop->outline.tile_call = NULL;
    name_pointed(loop);
    begin_as_compiled(loop, &out.out);
    buffer_text(&out.out, loop_condition(loop));
    writer_line(&out, "/* redcc: what an iteration of line %u's loop touches, and what it does */",
                ir_position_of(loop->unit, facts->loop->range.begin).line);
    writer_line(&out, "REDCC_QUIET_BEGIN");
    write_parts(loop, &out);
    writer_line(&out, "REDCC_QUIET_END");
    buffer_text(&out.out, "#endif\n");
    end_as_compiled(loop, &out.out);
    if (!loop->is_unfused) /* else unfused_function writes the #line directive */
        buffer_format(&out.out, "%s\n%s", loop_line_directive(loop, *place),
                      is_in_line ? loop_column_blanks(loop, *place) : "");
    check_macro_names(loop, &out.out);
    const char *text = writer_text(loop->arena, &out);
    if (!loop->outline.possible)
        loop_obstacle(loop, facts->loop->range,
                      "its slice or its body names something that cannot be passed to a separate "
                      "function");
    return loop->obstacle ? NULL : text;
}
