/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Writes the check by which a thread skips an inner iteration if it owns no row that the iteration
 * would update. Inserts the check into the body's text.
 */
#include "analysis/base/row_steps.h"
#include "analysis/base/stepped.h"
#include "emit/base/wrapping.h"
#include "emit/body/copy.h"
#include "emit/text/origin.h"
#include "ir/ir_syntax.h"
#include "plan/inner_iterations.h"
#include "plan/lookup.h"

/** Returns the address of a row as a number. The program may never compute this address, and then C
 * need not define the pointer. */
static const char *row_number(loop_text *loop, const ir_node *row) {
    row_address address;
    return row_address_of(row, &address)
               ? address_number(loop->arena, &address, NULL, wrapping_name, loop)
               : NULL;
}

/** The context of first_value_name, which replaces a loop's stepped variables by their first
 * values. */
typedef struct first_values {
    loop_text *loop;
    const loop_span *span;
} first_values;

static const char *first_value_name(const ir_node *node, void *context) {
    const first_values *it = context;
    const counted_loop *counted = &it->span->counted;
    const ir_node *value = NULL;
    if (node->kind == IR_VARIABLE && node->variable == counted->counter)
        value = counted->lower;
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < counted->start_count; i++)
        if (counted->starts[i].variable == node->variable)
            value = counted->starts[i].value;
    if (!value) {
        const char *name = local_name(node, it->loop);
        return name ? name : wrapping_operation(it->loop->arena, node, first_value_name, context);
    }
    const char *text = text_operand(it->loop->arena, value, wrapping_name, it->loop);
    const char *type = origin_type(it->loop->arena, node->type);
    return text && type ? arena_format(it->loop->arena, "((%s)%s)", type, text) : NULL;
}

/** Returns the check for ownership of all rows through which the nested loop steps. If the loop has
 * no iterations, there are no rows, and any answer is correct. */
static const char *span_check(loop_text *loop, const skip_row *skipped) {
    arena *a = loop->arena;
    const counted_loop *counted = &skipped->span->counted;
    const ir_node *row = skipped->update->row;
    first_values first = {loop, skipped->span};
    row_address address;
    const char *number = row_address_of(row, &address)
                             ? address_number(a, &address, NULL, first_value_name, &first)
                             : NULL;
    const char *lower = text_operand(a, counted->lower, wrapping_name, loop);
    const char *bound = text_operand(a, counted->bound, wrapping_name, loop);
    if (!number || !lower || !bound)
        return NULL;
    const char *count = arena_format(a, "((redcc_size)%s - (redcc_size)%s%s)", bound, lower,
                                     counted->comparison == IR_OP_LESS ? "" : " + 1");
    return arena_format(a, "REDCC_OWNS_ROW(%u, %s, %s * %lldu)", skipped->update->array,
                        macro_argument(a, number), macro_argument(a, count),
                        (long long)row_stride(row, span_stepped_in(skipped->span, row)));
}

static const char *row_check(loop_text *loop, const skip_row *skipped) {
    const ir_node *row = skipped->update->row;
    const char *number = row_number(loop, row);
    return number
               ? arena_format(loop->arena, "REDCC_OWNS_ROW(%u, %s, %lld)", skipped->update->array,
                              macro_argument(loop->arena, number), (long long)row->type->size)
               : NULL;
}

/** Returns the check whether the thread owns any of the rows, or leads in the iteration if the skip
 * needs a leader. NULL if it cannot be spelled. */
static const char *skip_check(loop_text *loop, const inner_skip *skip) {
    const char *check = !skip->needs_leader       ? ""
                        : has_series(loop->facts) ? "REDCC_LEADS(redcc__writers[0]) || "
                                                  : "REDCC_LEADS_ALONE || ";
    for (unsigned i = 0; i < skip->row_count; i++) {
        const skip_row *skipped = &skip->rows[i];
        const char *one = skipped->span ? span_check(loop, skipped) : row_check(loop, skipped);
        if (!one)
            return NULL;
        check = arena_format(loop->arena, "%s%s%s", check, i > 0 ? " || " : "", one);
    }
    return arena_format(loop->arena, "REDCC_INNER_ITERATION(%s) ", check);
}

void skip_inner_iterations(body_copy *copy, const ir_node *node) {
    loop_text *loop = copy->loop;
    const inner_skip *skip = is_printed(copy, node) ? NULL : skip_of(loop->plan, node);
    const char *check = skip ? skip_check(loop, skip) : NULL;
    if (check &&
        syntax_editable_statement(skip->before, loop->facts->counted.body) == skip->before &&
        !is_printed(copy, skip->before)) {
        edit_insert(loop->arena, &copy->edits, skip->before->range.begin, check);
        return;
    }
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        skip_inner_iterations(copy, node->children[i]);
}
