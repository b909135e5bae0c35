/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/block_ranges.h"

#include <assert.h>

#include "analysis/base/openmp_loop.h"
#include "emit/macro_names.h"
#include "emit/text/origin.h"
#include "ir/ir_words.h"

static const nested_blocks *inner_of(const loop_text *loop) {
    assert(loop->facts->variables.blocks);
    return loop->facts->variables.blocks->inner;
}

static bool is_inclusive(const counted_loop *counted) {
    return counted->comparison == IR_OP_LESS_EQUAL || counted->comparison == IR_OP_GREATER_EQUAL;
}

static const char *type_of(loop_text *loop, const counted_loop *counted) {
    const char *type = origin_type(loop->arena, counted->counter->type);
    if (!type)
        loop_obstacle(loop, loop->facts->loop->range, "the counter's type cannot be spelled");
    return type ? type : "int";
}

/* ---- the number of blocks -------------------------------------------------------------------- */

/** Declares the loop's bounds and trip count, with names that begin with `of`. `guard`: the
 * condition under which the bounds may be evaluated; NULL: always. */
static void write_trip(loop_text *loop, writer *out, const counted_loop *counted, const char *of,
                       const char *guard) {
    assert(counted->step != 0 && !counted->stride);
    const bool ascends = counted->step > 0;
    const char *lower = loop_operand(loop, counted->lower);
    const char *bound = loop_operand(loop, counted->bound);
    if (guard) {
        lower = arena_format(loop->arena, "%s ? %s : 0", guard, lower);
        bound = arena_format(loop->arena, "%s ? %s : 0", guard, bound);
    }
    writer_line(out, "const %s %slower = %s, %sbound = %s;", type_of(loop, counted), of, lower, of,
                bound);
    writer_line(out, "const redcc_int %strip = REDCC_TRIP%s(%s%s, %s%s, %lld);", of,
                is_inclusive(counted) ? "_TO" : "", of, ascends ? "lower" : "bound", of,
                ascends ? "bound" : "lower", (long long)(ascends ? counted->step : -counted->step));
}

void write_counts(loop_text *loop, writer *out, int most) {
    const nested_blocks *inner = inner_of(loop);
    const bool is_sequential =
        loop->options->order_is_explicit && loop->options->order == ORDER_SERIAL;
    write_trip(loop, out, &loop->facts->counted, "redcc__", NULL);
    if (inner)
        write_trip(loop, out, &inner->counted, "redcc__inner_", "redcc__trip > 0");
    writer_line(out, "const int redcc__in_order = %s;",
                is_sequential ? "1" : "REDCC_IN_ORDER(redcc__site)");
    writer_line(out, "const redcc_int redcc__%s = redcc__in_order ? redcc__trip > 0",
                inner ? "rows" : "blocks");
    writer_line(out, "    : REDCC_BLOCKS_%s(redcc__trip, %d);",
                loop->facts->has_short_iterations ? "SHORT" : "LONG", most);
    if (inner) {
        writer_line(out,
                    "const redcc_int redcc__columns = redcc__in_order ? redcc__inner_trip > 0");
        writer_line(out, "    : REDCC_COLUMNS_%s(redcc__rows, redcc__inner_trip, %d);",
                    inner->has_short_iterations ? "SHORT" : "LONG", most);
        writer_line(out, "const redcc_int redcc__blocks = redcc__rows * redcc__columns;");
    }
    writer_line(out, "redcc_int redcc__block;");
}

void write_shared(const loop_text *loop, buffer *out) {
    buffer_text(out, ", redcc__lower, redcc__bound, redcc__trip, redcc__blocks, redcc__in_order");
    if (inner_of(loop))
        buffer_text(out, ", \\\n    redcc__inner_lower, redcc__inner_bound, redcc__inner_trip, "
                         "redcc__rows, redcc__columns");
}

/* ---- loops without iterations ---------------------------------------------------------------- */

/** Is the variable `lastprivate`? With NULL: is any variable? */
static bool is_last(const loop_text *loop, const ir_variable *variable) {
    const openmp_directive *directive = &loop->facts->variables.blocks->directive;
    for (unsigned i = 0; i < directive->item_count; i++)
        if (directive->items[i].kind == OPENMP_LASTPRIVATE &&
            (!variable || openmp_variable(loop->unit, loop->facts->loop, loop->facts->function,
                                          directive->items[i].text) == variable))
            return true;
    return false;
}

void write_if_any(loop_text *loop, writer *out, bool is_of_team) {
    const counted_loop *counted = &loop->facts->counted;
    const nested_blocks *inner = inner_of(loop);
    if (!is_last(loop, NULL))
        return;
    writer_line(out, "if (redcc__blocks == 0) {");
    if (is_of_team)
        buffer_text(&out->out, "#pragma omp single nowait\n");
    writer_line(out, "    {");
    if (is_last(loop, counted->counter))
        writer_line(out,
                    "        %s = (%s)REDCC_PART_BEGIN(redcc__lower, redcc__trip, 1, 1, %lld, 0);",
                    origin_variable(loop->arena, counted->counter), type_of(loop, counted),
                    (long long)counted->step);
    if (inner && is_last(loop, inner->counted.counter))
        writer_line(out, "        if (redcc__trip > 0) %s = redcc__inner_lower;",
                    origin_variable(loop->arena, inner->counted.counter));
    writer_line(out, "    }");
    writer_line(out, "} else");
}

/* ---- the iterations of a block --------------------------------------------------------------- */

static void write_range(loop_text *loop, writer *out, const counted_loop *counted, const char *of,
                        const char *part, const char *parts) {
    const char *type = type_of(loop, counted);
    const char *begin = arena_format(loop->arena, "(%s)REDCC_PART_BEGIN(%slower, %strip, %s, %s",
                                     type, of, of, parts, part);
    writer_line(out, "const %s %sfirst = %s, %lld, 0),", type, of, begin, (long long)counted->step);
    writer_line(out, "    %sstop = %s + 1 == %s ? %sbound", of, part, parts, of);
    writer_line(out, "        : %s + 1, %lld, %d);", begin, (long long)counted->step,
                is_inclusive(counted));
}

void write_ranges(loop_text *loop, writer *out) {
    const nested_blocks *inner = inner_of(loop);
    write_range(loop, out, &loop->facts->counted, "redcc__",
                inner ? "redcc__block / redcc__columns" : "redcc__block",
                inner ? "redcc__rows" : "redcc__blocks");
    if (inner)
        write_range(loop, out, &inner->counted, "redcc__inner_", "redcc__block % redcc__columns",
                    "redcc__columns");
}

static void write_for(loop_text *loop, writer *out, const counted_loop *counted, const char *of) {
    const bool is_declared = counted->counter_is_declared_in_header;
    const char *name = origin_variable(loop->arena, counted->counter);
    writer_line(out, "for (%s%s%s = %sfirst; %s %s %sstop; %s += %lld)",
                is_declared ? type_of(loop, counted) : "", is_declared ? " " : "",
                is_declared ? origin_declarator(loop->arena, counted->counter) : name, of, name,
                ir_operator_spelling(counted->comparison), of, name, (long long)counted->step);
}

void write_header(loop_text *loop, writer *out) {
    write_for(loop, out, &loop->facts->counted, "redcc__");
}

loop_piece inner_header(loop_text *loop) {
    const nested_blocks *inner = inner_of(loop);
    if (!inner)
        return (loop_piece){0};
    const ir_range replaced = inner->header;
    const char *text = loop->unit->source->text;
    writer out = {0};
    buffer_text(&out.out, "\n#ifdef redcc__in_blocks\n");
    write_for(loop, &out, &inner->counted, "redcc__inner_");
    buffer_format(&out.out, "#else\n%s\n%s", loop_line_directive(loop, replaced.begin),
                  loop_column_blanks(loop, replaced.begin));
    buffer_append(&out.out, text + replaced.begin, replaced.end - replaced.begin);
    buffer_format(&out.out, "\n#endif\n%s\n%s", loop_line_directive(loop, replaced.end - 1),
                  loop_column_blanks(loop, replaced.end));
    check_macro_names(loop, &out.out);
    return (loop_piece){writer_text(loop->arena, &out), replaced};
}
