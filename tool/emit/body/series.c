/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Of a floating scalar that a loop inside accumulates into each iteration has as many operands as
 * it likes: a series, redcc__series_N of the scalar that update number N is the first of. The
 * thread that enters the loop adds them up in the region, so that its time is the loop's, and the
 * scalar gets the sum after it. (In the region its name is a copy, or what all threads share: a
 * variable that is written there would lie in memory for the sequential form, too.)
 */
#include "emit/body/series.h"

#include "emit/text/origin.h"
#include "ir/ir_words.h"
#include "plan/lookup.h"

static bool is_first(const loop_facts *facts, unsigned number) {
    return facts->scalars[number].is_series && series_of(facts, number) == number;
}

/** Which of the loop's series it is. */
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
    for (unsigned i = 0; i < facts->scalar_count; i++) {
        if (!is_first(facts, i))
            continue;
        writer_line(out,
                    "redcc_series *const redcc__series_%u = "
                    "redcc_series_take(&redcc__loop, redcc__trip);",
                    i);
        writer_line(out, "%s redcc__sum_%u = 0;", type_of(&facts->scalars[i]), i);
        writer_line(out, "int redcc__summed_%u = 0;", i);
    }
}

const char *series_are_there(loop_text *loop, const char *text) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            text = arena_format(loop->arena, "%s%sredcc__series_%u", text ? text : "",
                                text ? " && " : "", i);
    return text;
}

void add_series_variables(loop_text *loop, buffer *clause) {
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->scalar_count; i++) {
        const ir_variable *variable = facts->scalars[i].variable;
        if (is_first(facts, i) && variable && !is_captured(facts, variable))
            buffer_format(clause, "%s%s", clause->length > 0 ? ", " : "firstprivate(",
                          origin_declarator(loop->arena, variable));
    }
}

void join_series(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    if (!has_series(facts))
        return;
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (is_first(facts, i))
            writer_line(out, "%s redcc__own_sum_%u = 0;", type_of(&facts->scalars[i]), i);
    writer_line(out, "redcc_series_writer redcc__writers[%u];", count_series(facts));
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (is_first(facts, i))
            writer_line(out, "redcc_series_join(&redcc__writers[%u], redcc__series_%u);",
                        place_of(facts, i), i);
}

/** The scalar, as an argument of a macro. */
static const char *scalar_text(loop_text *loop, unsigned number) {
    return macro_argument(loop->arena, loop_operand(loop, loop->facts->scalars[number].target));
}

const char *series_go_on(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    if (!has_series(facts))
        return "redcc_next(&redcc__worker)";
    buffer out = {0};
    buffer_format(&out,
                  "redcc_next(&redcc__worker) || "
                  "(redcc_series_again(&redcc__worker, redcc__writers, %u) && (",
                  count_series(facts));
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (is_first(facts, i))
            buffer_format(&out, "REDCC_SERIES_BEGIN(redcc__writers[%u], redcc__own_sum_%u, %s), ",
                          place_of(facts, i), i, scalar_text(loop, i));
    buffer_text(&out, "1))");
    return buffer_take(loop->arena, &out);
}

void finish_series(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    if (!has_series(facts))
        return;
    writer_line(out, "if (redcc_series_is_over(&redcc__worker)) {");
    out->depth++;
    for (unsigned i = 0; i < facts->scalar_count; i++) {
        const scalar_update *update = &facts->scalars[i];
        if (is_first(facts, i))
            writer_line(out,
                        "REDCC_SERIES_APPLY(redcc__writers[%u], %s, %s, %s, %s, "
                        "redcc__own_sum_%u, redcc__sum_%u, redcc__summed_%u)",
                        place_of(facts, i), type_of(update), operand_type_of(update),
                        ir_operator_spelling(update->op), scalar_text(loop, i), i, i, i);
    }
    out->depth--;
    writer_line(out, "}");
}

void begin_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "REDCC_SERIES_NEXT(redcc__writers[%u]);", place_of(loop->facts, i));
}

void write_series_operand(loop_text *loop, writer *out, unsigned number, const char *value) {
    const scalar_update *update = &loop->facts->scalars[number];
    const unsigned first = series_of(loop->facts, number);
    const char *type = operand_type_of(update);
    writer_line(out,
                "{ const %s redcc__operand = (%s)(%s); "
                "if (!redcc_series_put(&redcc__writers[%u], redcc__k, (double)redcc__operand)) "
                "redcc__own_sum_%u = (%s)(redcc__own_sum_%u %s redcc__operand); }",
                type, type, value, place_of(loop->facts, number), first, type_of(update), first,
                ir_operator_spelling(update->op));
}

void take_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "if (redcc__done && redcc__summed_%u) { %s = redcc__sum_%u; }", i,
                        loop_operand(loop, loop->facts->scalars[i].target), i);
}

void give_series(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (is_first(loop->facts, i))
            writer_line(out, "redcc_series_give(redcc__series_%u);", i);
}
