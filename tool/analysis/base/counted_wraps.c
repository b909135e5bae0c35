/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/counted_wraps.h"

#include <assert.h>

#include "analysis/base/expression.h"

static const ir_node *strip_casts(const ir_node *node) {
    while (node->kind == IR_CAST && node->type && node->type->kind == IR_INTEGER)
        node = node->children[0];
    return node;
}

static bool is_non_negative(const ir_node *node) {
    int64_t value;
    if (!node)
        return false;
    if (expression_constant(node, &value))
        return value >= 0;
    node = strip_casts(node);
    return node->type && node->type->kind == IR_INTEGER && !node->type->is_signed;
}

static int64_t type_maximum(const ir_type *type) {
    assert(type->kind == IR_INTEGER && type->size > 0);
    int bits = (int)type->size * 8 - (type->is_signed ? 1 : 0);
    return bits >= 63 ? INT64_MAX : ((int64_t)1 << bits) - 1;
}

/* Under -fwrapv, may a signed counter wrap around before it reaches the bound? */
static bool signed_wraps(const counted_loop *loop) {
    const ir_type *counter = loop->counter->type, *bound = loop->bound->type;
    int64_t constant;
    if (loop->stride || loop->step > 1 || loop->step < -1 || bound->size > counter->size ||
        (!bound->is_signed && bound->size == counter->size))
        return true;
    if (loop->comparison == IR_OP_GREATER_EQUAL)
        return !expression_constant(loop->bound, &constant) || constant <= INT32_MIN;
    return loop->comparison != IR_OP_LESS && loop->comparison != IR_OP_GREATER;
}

/* The generated code counts iterations in 64 bits and treats lower, bound and step as mathematical
 * numbers. That agrees with the loop if no conversion changes the numbers compared, and if the
 * counter reaches the bound without overflow. Overflow of a signed type at least as wide as int is
 * undefined behaviour, except under -fwrapv. If the computed trip count is zero or less, the
 * original loop runs. */
bool counted_wraps(const counted_loop *loop) {
    assert(loop->step != 0);
    const ir_type *counter = loop->counter->type;
    const ir_type *bound = loop->bound->type;
    int64_t constant = 0;
    bool bound_is_constant = expression_constant(loop->bound, &constant);
    int64_t magnitude = loop->step < 0 ? -loop->step : loop->step;
    bool is_up = loop->step > 0;
    bool is_inclusive =
        loop->comparison == IR_OP_LESS_EQUAL || loop->comparison == IR_OP_GREATER_EQUAL;
    bool bound_is_unsigned = !bound->is_signed && !(bound_is_constant && constant >= 0) &&
                             bound->size >= 4 && bound->size >= counter->size;
    if (counter->wraps && loop->comparison == IR_OP_NOT_EQUAL)
        return true;
    if (bound_is_constant && is_up && constant >= 0 && !loop->stride &&
        constant <= type_maximum(counter) - magnitude)
        return counter->is_signed && bound->size >= 4 && !bound->is_signed &&
               !is_non_negative(loop->lower);
    if (counter->is_signed) {
        if (counter->size < 4)
            return true;
        /* Compared with an unsigned bound, a signed counter is converted, so that negative values
         * become large. */
        return (counter->wraps && signed_wraps(loop)) ||
               ((bound_is_unsigned || (!bound->is_signed && bound->size >= counter->size)) &&
                (!is_up || !is_non_negative(loop->lower)));
    }
    if (loop->comparison == IR_OP_NOT_EQUAL) {
        int64_t lower;
        return !(is_up && loop->lower && expression_constant(loop->lower, &lower) && lower == 0 &&
                 bound->size <= counter->size && counter->size >= 4);
    }
    if (is_up)
        return counter->size < 4 || magnitude != 1 || loop->stride || bound->size > counter->size ||
               (is_inclusive && counter->size < 8);
    /* The counter decreases. The loop i > bound ends if bound >= 0 and the step is -1; i >= 0 never
     * ends. */
    if (counter->size < 4 || magnitude != 1 || loop->stride)
        return true;
    if (is_inclusive)
        return !(bound_is_constant && constant >= 1);
    return bound->is_signed && !(bound_is_constant && constant >= 0);
}

bool counted_wrap_is_seen(const counted_loop *loop) {
    assert(loop->step != 0);
    const ir_type *counter = loop->counter->type;
    return !counter->is_signed && counter->size >= 4 && loop->bound->type->size <= counter->size &&
           loop->comparison == IR_OP_LESS && (loop->stride || loop->step > 1);
}
