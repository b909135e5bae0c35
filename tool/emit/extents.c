/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the extents of the loop's reads (their ranges in memory) that are known before the
 * inspection. */
#include "analysis/base/exact.h"
#include "analysis/base/expression.h"
#include "emit/base/names.h"
#include "emit/base/wrapping.h"
#include "emit/call.h"
#include "emit/text/origin.h"

bool has_affine_extents(const loop_text *loop) {
    for (unsigned i = 0; i < loop->plan->source_count; i++)
        if (loop->plan->sources[i].fact->extent == EXTENT_AFFINE)
            return true;
    return false;
}

/** If is_checked is false: is there an affine extent that is computed without checks? If true: is
 * there any extent that is computed with checks? */
static bool has_extents(const loop_text *loop, bool is_checked) {
    for (unsigned i = 0; i < loop->plan->source_count; i++)
        if ((is_checked && loop->plan->sources[i].fact->extent == EXTENT_BOUNDED) ||
            (loop->plan->sources[i].fact->extent == EXTENT_AFFINE &&
             loop->plan->sources[i].fact->is_checked == is_checked))
            return true;
    return false;
}

static bool is_address(const ir_type *type) {
    return type->kind == IR_POINTER || type->kind == IR_ARRAY;
}

typedef struct wrap_context {
    arena *arena;
} wrap_context;

/** A rename hook: signed operations wrap around, since the program may not evaluate them. */
static const char *wrap(const ir_node *node, void *context) {
    return wrapping_operation(((wrap_context *)context)->arena, node, wrap, context);
}

/** The address of the source's row, &row, converted to const char *. */
static const char *address_text(loop_text *loop, const loop_source *read) {
    row_address address;
    wrap_context context = {loop->arena};
    const char *number = NULL;
    if (!read->is_sometimes)
        return arena_format(loop->arena, "(const char *)&%s", loop_operand(loop, read->row));
    if (row_address_of(read->row, &address))
        number = address_number(loop->arena, &address, NULL, wrap, &context);
    if (!number)
        loop_obstacle(loop, read->row->range,
                      "an expression of the loop cannot be written as C outside of it");
    return arena_format(loop->arena, "(const char *)(%s)", number ? number : "0");
}

static void fill_fixed_extents(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->plan->source_count; i++) {
        const loop_source *read = loop->plan->sources[i].fact;
        if (read->extent == EXTENT_INVARIANT) {
            writer_line(out, "redcc_known_row(&redcc__known[%u], %s, sizeof(%s));", i,
                        address_text(loop, read), loop_operand(loop, read->row));
        } else if (read->extent == EXTENT_TOUCHED && read->base &&
                   loop->plan->has_ready_base[read - loop->facts->sources]) {
            writer_line(out, "redcc__known[%u].first = (const char *)%s%s;", i,
                        is_address(read->base->type) ? "" : "&", loop_operand(loop, read->base));
        } else if (read->extent == EXTENT_TOUCHED && !read->base) {
            /* A plan that later executions reuse stores ranges relative to `first`, which may move
             * between executions. The range of a source without a base is stored relative to the
             * site, which never moves. */
            writer_line(out, "redcc__known[%u].first = (const char *)&%s;", i,
                        outlined_name(loop, "site"));
        }
    }
}

/* ---- rows that each iteration reads -------------------------------------------------------- */

/** Returns the difference between the counter's value after the loop and in the last iteration. */
static const char *last_step(loop_text *loop) {
    return loop->facts->counted.steps_at_start ? "0" : loop_step(loop);
}

/** Writes extents from the row of the first iteration to that of the last, in either order in
 *  memory. */
static void fill_affine_extents(loop_text *loop, writer *out) {
    if (!has_extents(loop, false))
        return;
    const counted_loop *counted = &loop->facts->counted;
    writer_line(out, "REDCC_FIRST_AND_LAST {");
    out->depth++;
    writer_line(out, "%s %s = (%s)REDCC_FIRST_OR_LAST(%s);", loop->counter_type,
                origin_declarator(loop->arena, counted->counter), loop->counter_type,
                last_step(loop));
    for (unsigned i = 0; i < loop->plan->source_count; i++) {
        if (loop->plan->sources[i].fact->extent != EXTENT_AFFINE ||
            loop->plan->sources[i].fact->is_checked)
            continue;
        const char *row = loop_operand(loop, loop->plan->sources[i].fact->row);
        writer_line(out, "REDCC_KNOWN_ROW(%u, %s);", i, macro_argument(loop->arena, row));
    }
    out->depth--;
    writer_line(out, "}");
}

/* ---- rows of some iterations, subscripts that may wrap around ------------------------------- */

/** Context for writing an exact number (analysis/base/exact.h). `at`: the counter's value as
 * text. */
typedef struct exact_text {
    loop_text *loop;
    const char *at;
} exact_text;

static const char *exact_number(exact_text *self, const ir_node *node);

/** Returns the number, with a check that the node's type can represent it. If the check fails at
 * run time, the extents are unknown. */
static const char *settled_number(exact_text *self, const ir_node *node) {
    const char *number = exact_number(self, node);
    if (exact_is_settled(node, self->loop->facts->counted.counter))
        return number;
    return arena_format(self->loop->arena, "redcc_exact_%s(%s, %lld, &redcc__unknown)",
                        node->type->is_signed ? "signed" : "unsigned", number,
                        (long long)node->type->size * 8);
}

static const char *operand_number(exact_text *self, const ir_node *node, unsigned child) {
    const ir_node *operand = node->children[child];
    return exact_needs_settled(node, operand) ? settled_number(self, operand)
                                              : exact_number(self, operand);
}

static const char *fixed_number(exact_text *self, const ir_node *node) {
    wrap_context context = {self->loop->arena};
    const char *text = text_operand(self->loop->arena, node, wrap, &context);
    if (!text)
        loop_obstacle(self->loop, node->range,
                      "an expression of the loop cannot be written as C outside of it");
    return arena_format(self->loop->arena, "(redcc_int)%s", text ? text : "0");
}

static const char *exact_number(exact_text *self, const ir_node *node) {
    const ir_variable *counter = self->loop->facts->counted.counter;
    arena *a = self->loop->arena;
    if (!expression_mentions(node, counter))
        return fixed_number(self, node);
    if (node->kind == IR_VARIABLE)
        return self->at;
    if (node->kind == IR_CAST || node->op == IR_OP_PLUS)
        return operand_number(self, node, 0);
    if (node->kind == IR_UNARY)
        return arena_format(a, "redcc_exact_difference(0, %s, &redcc__unknown)",
                            operand_number(self, node, 0));
    const char *left = operand_number(self, node, 0), *right = operand_number(self, node, 1);
    return arena_format(a, "redcc_exact_%s(%s, %s, &redcc__unknown)",
                        node->op == IR_OP_ADD        ? "sum"
                        : node->op == IR_OP_SUBTRACT ? "difference"
                                                     : "product",
                        left, right);
}

/** The address of the row for counter value `at`. */
static const char *exact_address(loop_text *loop, const row_address *address, const char *at) {
    exact_text self = {loop, at};
    arena *a = loop->arena;
    const char *sum =
        arena_format(a, "(redcc_int)(redcc_size)%s%s", address->base_is_object ? "&" : "",
                     loop_operand(loop, address->base));
    if (address->offset != 0)
        sum = arena_format(a, "%s + %lld", sum, (long long)address->offset);
    for (unsigned i = 0; i < address->term_count; i++)
        sum = arena_format(
            a,
            "redcc_exact_sum(%s, redcc_exact_product(%lld, %s, &redcc__unknown), &redcc__unknown)",
            sum, (long long)address->terms[i].bytes,
            settled_number(&self, address->terms[i].subscript));
    return sum;
}

/** Narrows the counter's range to the iterations that satisfy the limit, because only they read the
 * row. */
static void write_limit(loop_text *loop, writer *out, const counter_limit *limit) {
    exact_text self = {loop, NULL};
    const char *bound = fixed_number(&self, limit->bound);
    const bool is_equality =
        limit->comparison == IR_OP_EQUAL || limit->comparison == IR_OP_NOT_EQUAL;
    if (limit->comparison == IR_OP_NOT_EQUAL) {
        writer_line(out, "redcc__from += redcc__from == %s;", bound);
        writer_line(out, "redcc__to -= redcc__to == %s;", bound);
    }
    if (limit->comparison == IR_OP_EQUAL || limit->comparison == IR_OP_GREATER_EQUAL)
        writer_line(out, "redcc__from = redcc__from < %s ? %s : redcc__from;", bound, bound);
    if (limit->comparison == IR_OP_EQUAL || limit->comparison == IR_OP_LESS_EQUAL)
        writer_line(out, "redcc__to = redcc__to > %s ? %s : redcc__to;", bound, bound);
    if (is_equality)
        return;
    if (limit->comparison == IR_OP_GREATER)
        writer_line(out, "redcc__from = redcc__from <= %s ? %s + 1 : redcc__from;", bound, bound);
    if (limit->comparison == IR_OP_LESS)
        writer_line(out, "redcc__to = redcc__to >= %s ? %s - 1 : redcc__to;", bound, bound);
}

static void fill_checked_extent(loop_text *loop, writer *out, unsigned number) {
    const loop_source *read = loop->plan->sources[number].fact;
    const bool descends = loop->facts->counted.step < 0;
    const char *last = arena_format(
        loop->arena, descends ? "redcc__final - (%s)" : "redcc__final - %s", last_step(loop));
    row_address address;
    if (!row_address_of(read->row, &address)) {
        loop_obstacle(loop, read->row->range,
                      "an expression of the loop cannot be written as C outside of it");
        return;
    }
    writer_line(out, "{");
    out->depth++;
    writer_line(out, "redcc_int redcc__from = %s;", descends ? last : "redcc__lower");
    writer_line(out, "redcc_int redcc__to = %s;", descends ? "redcc__lower" : last);
    for (unsigned i = 0; i < read->limit_count; i++)
        write_limit(loop, out, &read->limits[i]);
    writer_line(out, "redcc__known[%u].first = redcc__known[%u].end = (const char *)&%s;", number,
                number, outlined_name(loop, "site"));
    writer_line(out, "if (redcc__from <= redcc__to)");
    writer_line(out, "    redcc_exact_extent(&redcc__known[%u], %s,", number,
                exact_address(loop, &address, "redcc__from"));
    writer_line(out, "                       %s, %lld, &redcc__unknown);",
                exact_address(loop, &address, "redcc__to"), (long long)read->row->type->size);
    out->depth--;
    writer_line(out, "}");
}

/* ---- all of them --------------------------------------------------------------------------- */

void declare_extents(loop_text *loop, writer *out) {
    if (has_extents(loop, true))
        writer_line(out, "int redcc__unknown = 0;");
}

void fill_extents(loop_text *loop, writer *out) {
    fill_fixed_extents(loop, out);
    fill_affine_extents(loop, out);
    for (unsigned i = 0; i < loop->plan->source_count; i++) {
        const loop_source *read = loop->plan->sources[i].fact;
        if (read->extent == EXTENT_AFFINE && read->is_checked)
            fill_checked_extent(loop, out, i);
        else if (read->extent == EXTENT_BOUNDED)
            fill_bounded_extent(loop, out, i);
    }
}

const char *extents_condition(const loop_text *loop) {
    return has_extents(loop, true) ? "!redcc__unknown" : NULL;
}
