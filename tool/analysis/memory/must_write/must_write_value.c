/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/must_write/must_write_run.h"

#include <assert.h>

/* Can the type represent the number, so that no conversion changes it? */
static bool number_fits(int64_t number, const ir_type *type) {
    if (type->kind == IR_BOOLEAN)
        return number == 0 || number == 1;
    if (type->kind != IR_INTEGER || type->size < 1 || type->size > 8)
        return false;
    if (type->size == 8)
        return type->is_signed || number >= 0;
    const int bits = (int)type->size * 8;
    const int64_t limit = INT64_C(1) << (type->is_signed ? bits - 1 : bits);
    return type->is_signed ? number >= -limit && number < limit : number >= 0 && number < limit;
}

value value_integer(int64_t number, const ir_type *type) {
    const value v = {VALUE_INTEGER, true, number};
    return number_fits(number, type) ? v : value_other;
}

value run_convert(run *r, const ir_node *node, value v, const ir_type *type) {
    if (v.kind == VALUE_INTEGER)
        return value_integer(v.number, type);
    if (v.kind == VALUE_POINTER && type->kind != IR_POINTER)
        return run_give_up(r, node, "its address is converted to something else");
    return v;
}

/* Does a conversion change a negative operand because the other operand is unsigned? The result is
 * then treated as unknown. */
static bool converts_sign(const ir_node *node, value left, value right) {
    const ir_type *a = node->children[0]->type, *b = node->children[1]->type;
    return (left.number < 0 && !b->is_signed) || (right.number < 0 && !a->is_signed);
}

bool value_compute(ir_operator op, int64_t a, int64_t b, int64_t *result) {
    switch (op) {
    case IR_OP_ADD:
        return !__builtin_add_overflow(a, b, result);
    case IR_OP_SUBTRACT:
        return !__builtin_sub_overflow(a, b, result);
    case IR_OP_MULTIPLY:
        return !__builtin_mul_overflow(a, b, result);
    case IR_OP_DIVIDE:
        *result = b > 0 ? a / b : 0;
        return b > 0;
    case IR_OP_REMAINDER:
        *result = b > 0 ? a % b : 0;
        return b > 0;
    case IR_OP_SHIFT_LEFT:
        *result = 0;
        return a >= 0 && b >= 0 && b < 62 && a < (INT64_C(1) << (62 - b)) &&
               !__builtin_mul_overflow(a, INT64_C(1) << b, result);
    case IR_OP_SHIFT_RIGHT:
        *result = a >= 0 && b >= 0 && b < 63 ? a >> b : 0;
        return a >= 0 && b >= 0 && b < 63;
    case IR_OP_BIT_AND:
        *result = a & b;
        return a >= 0 && b >= 0;
    case IR_OP_BIT_OR:
        *result = a | b;
        return a >= 0 && b >= 0;
    case IR_OP_BIT_XOR:
        *result = a ^ b;
        return a >= 0 && b >= 0;
    case IR_OP_LESS:
        *result = a < b;
        return true;
    case IR_OP_GREATER:
        *result = a > b;
        return true;
    case IR_OP_LESS_EQUAL:
        *result = a <= b;
        return true;
    case IR_OP_GREATER_EQUAL:
        *result = a >= b;
        return true;
    case IR_OP_EQUAL:
        *result = a == b;
        return true;
    case IR_OP_NOT_EQUAL:
        *result = a != b;
        return true;
    default:
        return false;
    }
}

int64_t value_pointee_size(const ir_type *type) {
    assert(type->kind == IR_POINTER || type->kind == IR_ARRAY);
    const ir_type *target = type->target;
    if (target == NULL)
        return -1;
    return target->kind == IR_VOID || target->kind == IR_FUNCTION_TYPE ? 1 : target->size;
}

value value_move(value pointer, value number, int64_t element, bool is_back) {
    int64_t bytes;
    value result = {VALUE_POINTER, false, 0};
    if (!pointer.is_exact || number.kind != VALUE_INTEGER || element < 0 ||
        __builtin_mul_overflow(number.number, element, &bytes) ||
        (is_back ? __builtin_sub_overflow(pointer.number, bytes, &result.number)
                 : __builtin_add_overflow(pointer.number, bytes, &result.number)))
        return result;
    result.is_exact = true;
    return result;
}

value value_combine(const ir_node *node, value left, value right) {
    const bool is_back = node->op == IR_OP_SUBTRACT;
    int64_t number;
    if (left.kind == VALUE_POINTER && right.kind == VALUE_POINTER && left.is_exact &&
        right.is_exact && node->op >= IR_OP_LESS && node->op <= IR_OP_NOT_EQUAL &&
        value_compute(node->op, left.number, right.number, &number))
        return value_integer(number, node->type);
    if (node->type->kind == IR_POINTER && left.kind == VALUE_POINTER)
        return value_move(left, right, value_pointee_size(node->type), is_back);
    if (node->type->kind == IR_POINTER && right.kind == VALUE_POINTER)
        return value_move(right, left, value_pointee_size(node->type), false);
    if (left.kind != VALUE_INTEGER || right.kind != VALUE_INTEGER ||
        converts_sign(node, left, right) ||
        !value_compute(node->op, left.number, right.number, &number))
        return value_other;
    return value_integer(number, node->type);
}
