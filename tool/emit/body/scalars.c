/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Scalars that the loop accumulates into: each iteration keeps its operands, redcc__operands_N[k],
 * and after the loop they are applied in order. For a conditional update the iteration records in
 * redcc__made_N[k] whether it was executed; if it was not, nothing is applied, so that memory is
 * written only if an iteration would have written it. If several threads execute an iteration, each
 * for its own elements, all of them store the same values, atomically.
 */
#include "emit/body/scalars.h"

#include <assert.h>

#include "emit/base/names.h"
#include "emit/body/own.h"
#include "emit/body/series.h"
#include "emit/text/origin.h"
#include "ir/ir_words.h"
#include "plan/sections.h"

static const char *type_of(const scalar_update *update) {
    static const char *const types[] = {"redcc_word", "float", "double"};
    return types[update->operand];
}

/** The neutral element for combining integers. */
static const char *neutral_of(const scalar_update *update) {
    switch (update->op) {
    case IR_OP_MULTIPLY:
        return "1";
    case IR_OP_BIT_AND:
        return "~(redcc_word)0";
    default:
        return "0";
    }
}

static char sign_of(ir_operator op) {
    switch (op) {
    case IR_OP_ADD:
        return '+';
    case IR_OP_SUBTRACT:
        return '-';
    case IR_OP_MULTIPLY:
        return '*';
    case IR_OP_BIT_AND:
        return '&';
    case IR_OP_BIT_OR:
        return '|';
    default:
        return '^';
    }
}

const char *kept_operand_type(const loop_text *loop, unsigned number, bool is_made) {
    assert(number < loop->facts->scalar_count);
    const scalar_update *update = &loop->facts->scalars[number];
    if (update->is_series)
        return NULL;
    if (!is_made)
        return type_of(update);
    return update->is_conditional ? "unsigned char" : NULL;
}

const char *kept_operand_name(loop_text *loop, unsigned number, bool is_made) {
    return arena_format(loop->arena, "redcc__%s_%u", is_made ? "made" : "operands", number);
}

unsigned kept_operand_number(const loop_text *loop, unsigned number, bool is_made) {
    assert(number <= loop->facts->scalar_count);
    unsigned count = is_made ? 1 : 0;
    for (unsigned i = 0; i < number; i++)
        if (!loop->facts->scalars[i].is_series)
            count += loop->facts->scalars[i].is_conditional ? 2 : 1;
    return count;
}

static bool has_operands(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (!facts->scalars[i].is_series)
            return true;
    return false;
}

void declare_operands(loop_text *loop, writer *out) {
    declare_series(loop, out);
    if (!has_operands(loop->facts) && loop->facts->variables.own_count == 0)
        return;
    unsigned count = 0;
    writer_line(out, "static const redcc_size redcc__operand_bytes[] = {");
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        for (unsigned k = 0; k < 2; k++)
            if (kept_operand_type(loop, i, k == 1)) {
                writer_line(out, "    sizeof(%s),", kept_operand_type(loop, i, k == 1));
                count++;
            }
    for (unsigned i = 0; i < loop->facts->variables.own_count; i++, count++)
        writer_line(out, "    sizeof(%s),", kept_own_type(loop, i));
    writer_line(out, "};");
    writer_line(out, "REDCC_OPERANDS(%u);", count);
}

/** Returns the statement that records whether the iteration executes the update; "" if every
 * iteration executes it. */
static const char *made_text(loop_text *loop, unsigned number, bool is_made) {
    return loop->facts->scalars[number].is_conditional
               ? arena_format(loop->arena,
                              "__atomic_store_n(&redcc__made_%u[redcc__k], %d, __ATOMIC_RELAXED);",
                              number, is_made)
               : "";
}

/** In a loop that is executed in a fixed order, may the operands be added up in another order? */
static bool is_plain_sum(const scalar_update *update) {
    return !update->is_series && !update->is_conditional && !update->is_extremum &&
           update->operand != OPERAND_INTEGER &&
           (update->op == IR_OP_ADD || update->op == IR_OP_SUBTRACT);
}

/** If the runtime executes the loop in a fixed order, are its operands added up in blocks of
 * iterations (REDCC_ADD_OPERAND)? */
static bool adds_in_blocks(const loop_text *loop) {
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->scalar_count; i++)
        if (!is_plain_sum(&facts->scalars[i]))
            return false;
    return is_reordered(loop->plan) && !loop->lanes.is_wanted;
}

/** Writes a block in place of the user's statement. The block is a single statement, so it may
 * follow an `if` without braces. */
static void store_operand(loop_text *loop, writer *out, unsigned number, const char *value) {
    const char *type = type_of(&loop->facts->scalars[number]);
    if (adds_in_blocks(loop) && !loop->tiles) {
        writer_line(out,
                    "{ %s redcc__operand = (%s)%s; "
                    "REDCC_ADD_OPERAND(redcc__operands_%u, redcc__k) }",
                    type, type, value, number);
        return;
    }
    writer_line(out,
                "{ %s redcc__operand = (%s)%s; "
                "__atomic_store(&redcc__operands_%u[redcc__k], &redcc__operand, "
                "__ATOMIC_RELAXED); %s }",
                type, type, value, number, made_text(loop, number, true));
}

/** Returns the initial value of redcc__so_far_N: the identity element. In a tile that continues an
 *  iteration, it is instead the operand that the iteration has accumulated in preceding tiles. */
static const char *so_far_text(loop_text *loop, unsigned number) {
    const scalar_update *update = &loop->facts->scalars[number];
    const char *neutral = neutral_of(update);
    if (!loop->tiles)
        return neutral;
    const char *is_made = update->is_conditional
                              ? arena_format(loop->arena, " || !redcc__made_%u[redcc__k]", number)
                              : "";
    return arena_format(loop->arena,
                        "redcc__tile->is_first%s ? %s : (redcc_word)redcc__operands_%u[redcc__k]",
                        is_made, neutral, number);
}

void declare_repeated_operands(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (loop->facts->scalars[i].is_repeated && !loop->facts->scalars[i].is_series)
            writer_line(out, "redcc_word redcc__so_far_%u = %s;", i, so_far_text(loop, i));
}

void note_no_operands(loop_text *loop, writer *out) {
    begin_series(loop, out);
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        if (loop->facts->scalars[i].is_conditional && !loop->facts->scalars[i].is_series)
            writer_line(out, "%s%s", loop->tiles ? "if (redcc__tile->is_first) " : "",
                        made_text(loop, i, false));
}

void write_operand(loop_text *loop, writer *out, unsigned number, const char *value) {
    assert(number < loop->facts->scalar_count && value);
    const scalar_update *update = &loop->facts->scalars[number];
    const char *operand = arena_format(loop->arena, "(%s)", value);
    if (update->is_series) {
        write_series_operand(loop, out, number, value);
        return;
    }
    if (update->is_repeated) /* the sum of subtracted operands is subtracted after the loop */
        operand = arena_format(loop->arena, "(redcc__so_far_%u %c= (redcc_word)%s)", number,
                               update->op == IR_OP_SUBTRACT ? '+' : sign_of(update->op), operand);
    store_operand(loop, out, number, operand);
}

static void apply_extremum(loop_text *loop, writer *out, unsigned number) {
    const scalar_update *update = &loop->facts->scalars[number];
    arena *a = loop->arena;
    const char *name = loop_operand(loop, update->target);
    const char *operand = arena_format(a, "redcc__operands_%u[redcc__i]", number);
    if (update->operand == OPERAND_INTEGER)
        operand = arena_format(a, "(__typeof__(%s))%s", name, operand);
    const char *place = "";
    if (update->place)
        place =
            arena_format(a, " %s = (%s)(redcc__lower + %s * redcc__i);",
                         origin_variable(a, update->place), loop->counter_type, loop_step(loop));
    writer_line(out, "        if (%s(%s %s %s)) { %s = %s;%s }", update->is_negated ? "!" : "",
                operand, ir_operator_spelling(update->op), name, name, operand, place);
}

static void apply_sum(loop_text *loop, writer *out, unsigned number) {
    const scalar_update *update = &loop->facts->scalars[number];
    const char *name = loop_operand(loop, update->target);
    const char *from = update->operand == OPERAND_INTEGER ? "(redcc_word)" : "";
    writer_line(out, "        %s = (__typeof__(%s))(%s%s %c redcc__operands_%u[redcc__i]);", name,
                name, from, name, sign_of(update->op), number);
}

/** Writes the updates of one iteration, in textual order. */
static void apply_iteration(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++) {
        const scalar_update *update = &loop->facts->scalars[i];
        if (update->is_series)
            continue;
        if (update->is_conditional)
            writer_line(out, "        if (redcc__made_%u[redcc__i]) {", i);
        if (update->is_extremum)
            apply_extremum(loop, out, i);
        else
            apply_sum(loop, out, i);
        if (update->is_conditional)
            writer_line(out, "        }");
    }
}

/** Writes the sums of all operands, if the runtime has executed the loop in a fixed order. */
static void write_sums(loop_text *loop, writer *out) {
    writer_line(out, "    if (redcc__done == REDCC_DONE_IN_BLOCKS) {");
    for (unsigned i = 0; i < loop->facts->scalar_count; i++) {
        const scalar_update *update = &loop->facts->scalars[i];
        const char *name = loop_operand(loop, update->target);
        writer_line(out,
                    "        %s = (__typeof__(%s))(%s %c redcc_sum_%s(redcc__operands_%u, "
                    "REDCC_SUM_COUNT(redcc__trip)));",
                    name, name, name, sign_of(update->op), type_of(update), i);
    }
    writer_line(out, "    } else");
}

static void name_operands(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        for (unsigned k = 0; k < 2; k++)
            if (kept_operand_type(loop, i, k == 1))
                writer_line(out, "    const %s *const %s = (%s *)redcc__operands[%u];",
                            kept_operand_type(loop, i, k == 1), kept_operand_name(loop, i, k == 1),
                            kept_operand_type(loop, i, k == 1),
                            kept_operand_number(loop, i, k == 1));
}

void apply_operands(loop_text *loop, writer *out) {
    if (loop->facts->scalar_count == 0 && loop->facts->variables.own_count == 0)
        return;
    writer_line(out, "if (redcc__done) {");
    store_own(loop, out);
    if (has_operands(loop->facts)) {
        writer_line(out, "    redcc_int redcc__i;");
        name_operands(loop, out);
        if (adds_in_blocks(loop))
            write_sums(loop, out);
        writer_line(out, "    for (redcc__i = 0; redcc__i < %s; redcc__i++) {", loop_made(loop));
        apply_iteration(loop, out);
        writer_line(out, "    }");
    }
    take_series(loop, out);
    writer_line(out, "    REDCC_OPERANDS_END(%s);", outlined_name(loop, "site"));
    writer_line(out, "}");
}
