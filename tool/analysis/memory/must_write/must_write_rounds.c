/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Computes trip counts that are known although the bounds are not, as in
 * `for (i = x - 1; i <= x + 1; i++)`. */
#include "analysis/base/counted.h"

#include "analysis/base/expression.h"
#include "analysis/memory/must_write/must_write_run.h"
#include <assert.h>

/* The sum variable + number. */
typedef struct offset_value {
    const ir_variable *variable;
    int64_t number;
} offset_value;

static bool is_wide_integer(const ir_type *type) {
    return ir_type_never_wraps(type) && !type->is_volatile && !type->is_atomic;
}

/* Splits the value into a variable plus a number. Only signed integers without narrowing
 * conversions are permitted, so no sum wraps around, and only constants of 32 bits, so differences
 * of the numbers do not either. */
static bool offset_of(const ir_node *node, offset_value *to) {
    int64_t number;
    if (!is_wide_integer(node->type))
        return false;
    if (node->kind == IR_VARIABLE) {
        *to = (offset_value){node->variable, 0};
        return true;
    }
    if (node->kind != IR_BINARY || (node->op != IR_OP_ADD && node->op != IR_OP_SUBTRACT))
        return false;
    const bool is_first = node->op == IR_OP_ADD && expression_constant(node->children[0], &number);
    if (!is_first && !expression_constant(node->children[1], &number))
        return false;
    return number > INT32_MIN && number < INT32_MAX && offset_of(node->children[is_first], to) &&
           !(node->op == IR_OP_ADD ? __builtin_add_overflow(to->number, number, &to->number)
                                   : __builtin_sub_overflow(to->number, number, &to->number));
}

/* Is the variable invariant in the loop, written neither by name nor through a pointer? */
static bool is_invariant(run *r, const ir_node *loop, const ir_variable *variable) {
    return (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER) &&
           variable->function == r->function && variable != r->object &&
           !variable_is_written_in(loop, variable) &&
           (!variable->address_taken || !address_kept_outside(r->prover, loop, variable));
}

int64_t run_known_trip_count(run *r, const ir_node *loop) {
    assert(ir_is_loop(loop));
    const counted_result found = counted_recognise((ir_node *)loop);
    const counted_loop *it = &found.loop;
    offset_value first, bound;
    if (!found.is_counted || !it->lower || it->stride || it->step != 1 || it->ahead ||
        (it->comparison != IR_OP_LESS && it->comparison != IR_OP_LESS_EQUAL) ||
        !offset_of(it->lower, &first) || !offset_of(it->bound, &bound) ||
        first.variable != bound.variable || it->counter == first.variable ||
        !is_wide_integer(it->counter->type) || it->counter->address_taken ||
        it->counter->type->size < first.variable->type->size ||
        !is_invariant(r, loop, first.variable))
        return -1;
    const int64_t trip_count =
        bound.number - first.number + (it->comparison == IR_OP_LESS_EQUAL ? 1 : 0);
    return trip_count > 0 ? trip_count : 0;
}
