/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * For a floating scalar that an inner loop accumulates into, each iteration has any number of
 * operands: a series, identified by the number of the scalar's first update. The thread that called
 * the loop adds all operands up before the parallel execution ends, so that the runtime's timing
 * includes it; the scalar gets the sum after the loop. (A local variable is passed by value: if its
 * address were taken, the sequential form would keep it in memory as well.)
 */
#include "emit/body/series.h"

#include <assert.h>

#include "emit/base/names.h"
#include "emit/text/origin.h"
#include "ir/ir_words.h"
#include "plan/lookup.h"

static const char *pointed(const ir_node *node, void *context) {
    return pointed_name(context, node);
}

static bool is_first(const loop_facts *facts, unsigned number) {
    return facts->scalars[number].is_series && series_of(facts, number) == number;
}

/** The index of the update's series among the loop's series. */
static unsigned place_of(const loop_facts *facts, unsigned number) {
    unsigned place = 0;
    for (unsigned i = 0; i < series_of(facts, number); i++)
        place += is_first(facts, i);
    return place;
}

static unsigned count_series(const loop_facts *facts) {
    unsigned count = 0;
    for (unsigned i = 0; i < facts->scalar_count; i++)
        count += is_first(facts, i);
    return count;
}

static const char *type_of(const scalar_update *update) {
    return update->target->type->size == sizeof(float) ? "float" : "double";
}

static const char *operand_type_of(const scalar_update *update) {
    return update->operand == OPERAND_FLOAT ? "float" : "double";
}

void declare_series(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    if (!has_series(facts))
        return;
    for (unsigned i = 0; i < facts->scalar_count; i++) {
        if (!is_first(facts, i))
            continue;
        writer_line(out, "%s redcc__sum_%u = 0;", type_of(&facts->scalars[i]), i);
        writer_line(out, "int redcc__summed_%u = 0;", i);
    }
    writer_line(out, "REDCC_HAS_SERIES(%u);", count_series(facts));
}

bool is_scalar_by_value(const loop_text *loop, unsigned number) {
    assert(number < loop->facts->scalar_count);
    const ir_node *target = loop->facts->scalars[number].target;
    return target->kind == IR_VARIABLE && target->variable->storage != IR_GLOBAL &&
           target->variable->storage != IR_STATIC;
}

void for_each_series_value(loop_text *loop, void (*take)(void *to, extra_value value), void *to) {
    arena *a = loop->arena;
    take(to, (extra_value){"redcc__writers", "redcc_series_writer *const redcc__writers", NULL,
                           "redcc__of_thread_writers"});
    for (unsigned i = 0; i < loop->facts->scalar_count; i++) {
        if (!is_first(loop->facts, i))
            continue;
        const char *type = type_of(&loop->facts->scalars[i]);
        const char *const names[] = {
            arena_format(a, "redcc__scalar_%u", i), arena_format(a, "redcc__own_sum_%u", i),
            arena_format(a, "redcc__sum_%u", i), arena_format(a, "redcc__summed_%u", i)};
        take(to, (extra_value){names[0], arena_format(a, "const %s %s", type, names[0]),
                               loop_operand(loop, loop->facts->scalars[i].target), NULL});
        take(to, (extra_value){names[1], arena_format(a, "%s *const %s", type, names[1]), NULL,
                               arena_format(a, "&redcc__of_thread_sum_%u", i)});
        take(to, (extra_value){names[2], arena_format(a, "%s *%s", type, names[2]),
                               arena_format(a, "&%s", names[2]), NULL});
        take(to, (extra_value){names[3], arena_format(a, "int *%s", names[3]),
                               arena_format(a, "&%s", names[3]), NULL});
    }
}

void declare_thread_series(loop_text *loop, writer *out) {
    if (!has_series(loop->facts))
        return;
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "%s redcc__of_thread_sum_%u = 0;", type_of(&loop->facts->scalars[i]),
                        i);
    writer_line(out, "redcc_series_writer redcc__of_thread_writers[%u];",
                count_series(loop->facts));
    if (loop->outline.tile_call)
        writer_line(out, "redcc_series_part *redcc__ends[%u][REDCC_TILE_ROWS];",
                    count_series(loop->facts));
}

void join_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out,
                        "redcc_series_begin(redcc__worker, redcc__attempt, redcc__writers, %u);",
                        place_of(loop->facts, i));
    for (unsigned i = 0; i < loop->facts->scalar_count && loop->outline.tile_call; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "redcc__writers[%u].ends = redcc__ends[%u];", place_of(loop->facts, i),
                        place_of(loop->facts, i));
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i) &&
            is_scalar_by_value(loop, i)) /* the caller has read its value */
            writer_line(
                out,
                "REDCC_SERIES_IN_FRONT(redcc__writers[%u], *redcc__own_sum_%u, redcc__scalar_%u)",
                place_of(loop->facts, i), i, i);
}

/** The text by which a thread reads the scalar, as an argument of a macro. */
static const char *scalar_text(loop_text *loop, unsigned number) {
    if (is_scalar_by_value(loop, number))
        return arena_format(loop->arena, "redcc__scalar_%u", number);
    const char *text =
        text_operand(loop->arena, loop->facts->scalars[number].target, pointed, loop);
    if (!text)
        loop_obstacle(loop, loop->facts->scalars[number].target->range,
                      "an expression of the loop cannot be written as C outside of it");
    return macro_argument(loop->arena, text ? text : "0");
}

const char *series_condition(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    buffer out = {0};
    buffer_format(&out, "REDCC_SERIES_REPEATS(%u) && (", count_series(facts));
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (is_first(facts, i))
            buffer_format(&out, "REDCC_SERIES_BEGIN(redcc__writers[%u], *redcc__own_sum_%u, %s), ",
                          place_of(facts, i), i, scalar_text(loop, i));
    buffer_text(&out, "1)");
    return buffer_take(loop->arena, &out);
}

/** The first arguments of REDCC_SERIES_APPLY and REDCC_SERIES_BAND, up to the scalar. */
static const char *operation_text(loop_text *loop, unsigned number) {
    const scalar_update *update = &loop->facts->scalars[number];
    return arena_format(loop->arena, "redcc__writers[%u], %s, %s, %s, %s",
                        place_of(loop->facts, number), type_of(update), operand_type_of(update),
                        ir_operator_spelling(update->op), scalar_text(loop, number));
}

const char *series_of_band(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    if (!has_series(facts))
        return "";
    buffer out = {0};
    buffer_format(&out, "REDCC_SERIES_BANDS(%u,", count_series(facts));
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (is_first(facts, i))
            buffer_format(&out, " REDCC_SERIES_BAND(%s, *redcc__sum_%u, *redcc__summed_%u)",
                          operation_text(loop, i), i, i);
    buffer_text(&out, ")");
    return buffer_take(loop->arena, &out);
}

void finish_series(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    if (!has_series(facts))
        return;
    writer_line(out, "if (redcc__worker->call->calls->series->is_over(redcc__worker)) {");
    out->depth++;
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (is_first(facts, i))
            writer_line(out,
                        "REDCC_SERIES_APPLY(%s, *redcc__own_sum_%u, *redcc__sum_%u, "
                        "*redcc__summed_%u)",
                        operation_text(loop, i), i, i, i);
    out->depth--;
    writer_line(out, "}");
}

void begin_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "REDCC_SERIES_%s(redcc__writers[%u]);",
                        loop->tiles ? "RESUME" : "NEXT", place_of(loop->facts, i));
}

void leave_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "REDCC_SERIES_SUSPEND(redcc__writers[%u]);", place_of(loop->facts, i));
}

void write_series_operand(loop_text *loop, writer *out, unsigned number, const char *value) {
    const scalar_update *update = &loop->facts->scalars[number];
    assert(update->is_series);
    const unsigned first = series_of(loop->facts, number);
    const char *type = operand_type_of(update);
    writer_line(out,
                "{ const %s redcc__operand = (%s)(%s); "
                "if (!redcc_series_put(&redcc__writers[%u], redcc__k, (double)redcc__operand)) "
                "*redcc__own_sum_%u = (%s)(*redcc__own_sum_%u %s redcc__operand); }",
                type, type, value, place_of(loop->facts, number), first, type_of(update), first,
                ir_operator_spelling(update->op));
}

void take_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "    if (redcc__summed_%u) { %s = redcc__sum_%u; }", i,
                        loop_operand(loop, loop->facts->scalars[i].target), i);
}
