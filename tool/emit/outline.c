/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Slice and body of a loop as functions in front of the user's function; loop.h has what is around
 *  them. Compilers inline both at each of their uses. */
#include "emit/outline.h"

#include <string.h>

#include "emit/as_compiled.h"
#include "emit/base/names.h"
#include "emit/bins/bins.h"
#include "emit/body/body.h"
#include "emit/lanes/lanes.h"
#include "emit/macro_names.h"
#include "emit/slice/slice.h"
#include "emit/text/origin.h"
#include "emit/write_loop.h"
#include "ir/ir_position.h"
#include "plan/lookup.h"
#include "plan/outline.h"
#include "plan/place.h"

/* ---- what is handed over ------------------------------------------------------------------- */

static const char *parameter_text(loop_text *loop, const ir_variable *variable) {
    const char *name = origin_declarator(loop->arena, variable);
    if (variable->type->kind == IR_ARRAY)
        return declaration_text(loop, variable->type->target,
                                arena_format(loop->arena, "*%s", name));
    return declaration_text(loop, variable->type, name);
}

/* ---- heads and calls ----------------------------------------------------------------------- */

/** Marks each variable that the user's body mentions, what is replaced in it left out. */
static void mark_mentioned(const loop_text *loop, const ir_node *node, bool *is_mentioned) {
    const int array = loop_array_of_base(loop->facts, node);
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

static const char *counter_parameter(loop_text *loop, bool is_used) {
    return arena_format(loop->arena, "%s%s", parameter_text(loop, loop->facts->counted.counter),
                        is_used ? "" : " __attribute__((__unused__))");
}

typedef struct head {
    buffer parameters, arguments;
} head;

static void add_variables(loop_text *loop, const bool *is_mentioned, bool of_body, head *h) {
    for (unsigned i = 0; i < loop->unit->variable_count; i++) {
        const ir_variable *variable = loop->unit->variables[i];
        const handing how =
            is_mentioned[i] ? handing_of(loop->plan, variable, of_body) : NOT_HANDED;
        loop->outline.possible &= how != CANNOT_BE_HANDED;
        if (how != HANDED)
            continue;
        buffer_format(&h->parameters, ", %s", parameter_text(loop, variable));
        buffer_format(&h->arguments, ", %s", origin_variable(loop->arena, variable));
    }
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
        buffer_format(&h->parameters, ", %s", declaration_text(loop, row, name));
        buffer_format(&h->arguments, ", redcc__base_%u", i);
    }
}

static void write_slice(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    bool *is_mentioned = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    writer statements = {.depth = 1};
    head h = {0};
    write_slice_statements(loop, &statements, is_mentioned);
    const bool is_used = is_mentioned[facts->counted.counter->id];
    add_variables(loop, is_mentioned, false, &h);
    loop->outline.slice_call =
        arena_format(loop->arena, "%s(REDCC_SLICE_ARGUMENTS, %s%s)", outlined_name(loop, "slice"),
                     loop_counter_value(loop), buffer_take(loop->arena, &h.arguments));
    const bool is_unfused = loop->is_unfused && facts->slice.has_floating_work;
    writer_line(out, "REDCC_SLICE %s(REDCC_SLICE_PARAMETERS, %s%s) {%s",
                outlined_name(loop, "slice"), counter_parameter(loop, is_used),
                buffer_take(loop->arena, &h.parameters), is_unfused ? " REDCC_UNFUSED_BLOCK" : "");
    if (statements.out.length > 0)
        buffer_shorten(&statements.out, 1); /* the line goes on */
    buffer_text(&out->out, writer_text(loop->arena, &statements));
    writer_line(out, " }");
}

static void write_body(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    bool *is_mentioned = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    head h = {0};
    mark_mentioned(loop, facts->counted.body, is_mentioned);
    loop->outline.possible &= !is_mentioned[loop->unit->variable_count];
    add_stand_ins(loop, &h);
    add_variables(loop, is_mentioned, true, &h);
    const unsigned count = facts->array_count;
    const char *kind = loop->bins ? "BINNED" : "BODY";
    loop->outline.body_arguments = buffer_take(loop->arena, &h.arguments);
    loop->outline.body_parameters = buffer_take(loop->arena, &h.parameters);
    loop->outline.body_call =
        arena_format(loop->arena, "%s(REDCC_%s_ARGUMENTS_%u, %s%s)", outlined_name(loop, "body"),
                     kind, count, loop_counter_value(loop), loop->outline.body_arguments);
    writer_line(out, "%s %s(REDCC_%s_PARAMETERS_%u, %s%s) {%s",
                loop->lanes.is_wanted ? "REDCC_BODY_BESIDE_LANES" : "REDCC_BODY",
                outlined_name(loop, "body"), kind, count,
                counter_parameter(loop, body_reads(facts, facts->counted.counter)),
                loop->outline.body_parameters, loop->is_unfused ? " REDCC_UNFUSED_BLOCK" : "");
    out->depth = 1;
    write_iteration(loop, out);
    out->depth = 0;
    writer_line(out, loop->lanes.is_wanted ? "}" : "} REDCC_QUIET_END");
    write_lanes(loop, out);
    if (loop->lanes.is_wanted)
        writer_line(out, "REDCC_QUIET_END");
}

const char *write_outlined(loop_text *loop, uint32_t *place) {
    const loop_facts *facts = loop->facts;
    loop->outline.possible = !loop->plan->no_functions;
    if (!loop->outline.possible)
        return NULL;
    writer out = {0};
    const bool is_in_line = place_in_front(loop->unit, facts->function, place);
    buffer_text(&out.out, is_in_line ? "\n" : "");
    loop->outline.done = true;
    begin_as_compiled(loop, &out.out);
    buffer_text(&out.out, loop_condition(loop));
    writer_fill(&out, true);
    writer_line(&out, "/* redcc: what an iteration of line %u's loop touches, and what it does */",
                ir_position_of(loop->unit, facts->loop->range.begin).line);
    writer_line(&out, "REDCC_QUIET_BEGIN");
    declare_inlined(loop, &out);
    if (loop->bins)
        write_bins(loop, &out);
    writer_fill(&out, false);
    write_slice(loop, &out);
    write_body(loop, &out);
    loop->outline.done = loop->outline.possible && !loop->obstacle;
    buffer_text(&out.out, "#endif\n");
    end_as_compiled(loop, &out.out);
    if (!loop->is_unfused) /* else the function's own piece says it */
        buffer_format(&out.out, "%s\n%s", loop_line_directive(loop, facts->function->range.begin),
                      is_in_line ? loop_column_blanks(loop, *place) : "");
    check_macro_names(loop, &out.out);
    const char *text = writer_text(loop->arena, &out);
    return loop->outline.done ? text : NULL;
}
