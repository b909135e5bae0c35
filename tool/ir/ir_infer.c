/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Infers the type of an expression from the types of its parts by C's rules (C17 6.3.1, 6.5). The
 * text form omits a type that can be inferred here and states any other. A missing rule therefore
 * only makes the text longer. */
#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "ir/ir_words.h"

bool ir_type_identical(const ir_type *a, const ir_type *b) {
    if (a == b)
        return true;
    if (a == NULL || b == NULL)
        return false;
    return a->kind == b->kind && a->is_signed == b->is_signed &&
           a->is_character == b->is_character && a->is_const == b->is_const &&
           a->is_volatile == b->is_volatile && a->is_restrict == b->is_restrict &&
           a->is_atomic == b->is_atomic && a->size == b->size && a->count == b->count &&
           a->record == b->record && source_same_text(a->spelling, b->spelling) &&
           ir_type_identical(a->target, b->target);
}

/* ---- literals ------------------------------------------------------------------------------ */

static bool is_hexadecimal(const char *text) {
    return text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
}

static bool is_floating_literal(const char *text) {
    if (!isdigit((unsigned char)text[0]) && text[0] != '.')
        return false;
    return strpbrk(text, is_hexadecimal(text) ? ".pP" : ".eE") != NULL;
}

/* Parses digits as strtoull does, but also binary literals such as 0b101 (GNU, C23), which strtoull
 * may not know. Sets *end to the position after the digits. */
static unsigned long long digits(const char *text, char **end) {
    if (text[0] == '0' && (text[1] == 'b' || text[1] == 'B'))
        return strtoull(text + 2, end, 2);
    return strtoull(text, end, 0);
}

bool ir_literal_value(const char *text, int64_t *value) {
    if (text == NULL || !isdigit((unsigned char)text[0]) || is_floating_literal(text))
        return false;
    char *end;
    errno = 0;
    unsigned long long number = digits(text, &end);
    if (errno != 0 || number > INT64_MAX || end[strspn(end, "uUlL")] != 0)
        return false;
    *value = (int64_t)number;
    return true;
}

static const ir_type *scalar(arena *a, const char *word) {
    ir_type *type = ARENA_NEW(a, ir_type);
    ir_scalar_type(type, ir_scalar_named(word, strlen(word)));
    return type;
}

/* The first type of C's list (C17 6.4.4.1) that can hold the value. */
static const char *integer_literal_word(const char *text) {
    char *end;
    unsigned long long value = digits(text, &end);
    unsigned longs = 0;
    bool is_unsigned = false;
    for (; *end != 0; end++) {
        longs += *end == 'l' || *end == 'L';
        is_unsigned = is_unsigned || *end == 'u' || *end == 'U';
    }
    bool may_be_unsigned = is_unsigned || text[0] == '0';
    if (longs == 0 && value <= INT32_MAX && !is_unsigned)
        return "int";
    if (longs == 0 && value <= UINT32_MAX && may_be_unsigned)
        return "uint";
    if (value <= INT64_MAX && !is_unsigned)
        return longs == 2 ? "llong" : "long";
    return longs == 2 ? "ullong" : "ulong";
}

static const ir_type *number_type(arena *a, const char *text) {
    if (text == NULL)
        return NULL;
    if (is_floating_literal(text)) {
        char last = text[strlen(text) - 1];
        bool is_float = (last == 'f' || last == 'F'), is_long = (last == 'l' || last == 'L');
        return scalar(a, is_float ? "float" : is_long ? "ldouble" : "double");
    }
    return scalar(a, isdigit((unsigned char)text[0]) ? integer_literal_word(text) : "int");
}

/* ---- conversions --------------------------------------------------------------------------- */

static const ir_type *pointer_to(arena *a, const ir_type *target) {
    ir_type *type = ARENA_NEW(a, ir_type);
    type->kind = IR_POINTER;
    type->count = -1;
    type->size = 8;
    type->target = target;
    type->spelling = ir_type_default_spelling(a, type);
    return type;
}

/* The type that the value of an lvalue of this type has: without qualifiers (C17 6.3.2.1). */
static const ir_type *unqualified(arena *a, const ir_type *type) {
    if (!type->is_const && !type->is_volatile && !type->is_restrict && !type->is_atomic)
        return type;
    ir_type *bare = ARENA_NEW(a, ir_type);
    *bare = *type;
    bare->is_const = bare->is_volatile = bare->is_restrict = bare->is_atomic = false;
    bare->spelling = type->spelling != NULL ? ir_type_default_spelling(a, bare) : NULL;
    return bare;
}

static const ir_type *decayed(arena *a, const ir_type *type) {
    if (type->kind == IR_ARRAY)
        return pointer_to(a, type->target);
    if (type->kind == IR_FUNCTION_TYPE)
        return pointer_to(a, type);
    return unqualified(a, type);
}

static const ir_type *promoted(arena *a, const ir_type *type) {
    if (type->kind == IR_BOOLEAN || (type->kind == IR_INTEGER && type->size < 4))
        return scalar(a, "int");
    return unqualified(a, type);
}

/* Returns the conversion rank, computed from kind and size. long long outranks long even if their
 * sizes are equal, because the text form distinguishes the two types. */
static int rank(const ir_type *type) {
    int base = type->kind == IR_COMPLEX ? 200 : type->kind == IR_FLOATING ? 100 : 0;
    int is_long_long = type->spelling != NULL && strstr(type->spelling, "long long") != NULL;
    return base + 4 * (int)type->size + 2 * is_long_long + (type->is_signed ? 0 : 1);
}

static bool is_arithmetic(const ir_type *type) {
    return ir_type_is_scalar(type) && type->kind != IR_POINTER;
}

/* The type that the usual arithmetic conversions give (C17 6.3.1.8); NULL if an operand is not
 * arithmetic. */
static const ir_type *usual(arena *a, const ir_type *left, const ir_type *right) {
    if (!is_arithmetic(left) || !is_arithmetic(right))
        return NULL;
    left = promoted(a, left);
    right = promoted(a, right);
    return rank(left) >= rank(right) ? left : right;
}

/* ---- expressions --------------------------------------------------------------------------- */

static const ir_type *binary_type(arena *a, const ir_node *node) {
    const ir_type *left = node->children[0]->type, *right = node->children[1]->type;
    switch (node->op) {
    case IR_OP_LESS:
    case IR_OP_GREATER:
    case IR_OP_LESS_EQUAL:
    case IR_OP_GREATER_EQUAL:
    case IR_OP_EQUAL:
    case IR_OP_NOT_EQUAL:
    case IR_OP_AND:
    case IR_OP_OR:
        return scalar(a, "int");
    case IR_OP_COMMA:
        return decayed(a, right);
    case IR_OP_SHIFT_LEFT:
    case IR_OP_SHIFT_RIGHT:
        return promoted(a, left);
    default:
        break;
    }
    left = decayed(a, left);
    right = decayed(a, right);
    if (left->kind == IR_POINTER)
        return right->kind == IR_POINTER ? scalar(a, "long") : left;
    return right->kind == IR_POINTER ? right : usual(a, left, right);
}

static const ir_type *part_of_complex(arena *a, const ir_type *type) {
    if (type->kind != IR_COMPLEX)
        return unqualified(a, type);
    assert(type->size == 8 || type->size == 16 || type->size == 32);
    return scalar(a, type->size == 8 ? "float" : type->size == 16 ? "double" : "ldouble");
}

static const ir_type *unary_type(arena *a, const ir_node *node) {
    const ir_type *operand = node->children[0]->type;
    switch (node->op) {
    case IR_OP_NOT:
        return scalar(a, "int");
    case IR_OP_DEREFERENCE:
        return operand->kind == IR_FUNCTION_TYPE ? operand : operand->target;
    case IR_OP_ADDRESS:
        return pointer_to(a, operand);
    case IR_OP_REAL:
    case IR_OP_IMAG:
        return part_of_complex(a, operand);
    case IR_OP_PLUS:
    case IR_OP_MINUS:
    case IR_OP_BIT_NOT:
        return promoted(a, operand);
    default:
        return unqualified(a, operand);
    }
}

static const ir_type *conditional_type(arena *a, const ir_node *node) {
    const ir_type *left = decayed(a, node->children[1]->type);
    const ir_type *right = decayed(a, node->children[2]->type);
    const ir_type *common = usual(a, left, right);
    return common != NULL ? common : left;
}

static const ir_type *call_type(arena *a, const ir_node *node) {
    const ir_type *callee = node->children[0]->type;
    if (callee->kind == IR_POINTER)
        callee = callee->target;
    if (callee->kind != IR_FUNCTION_TYPE || callee->target == NULL)
        return NULL;
    return unqualified(a, callee->target);
}

static bool children_have_types(const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (node->children[i]->type == NULL)
            return false;
    return true;
}

const ir_type *ir_infer_type(arena *a, const ir_node *node) {
    const ir_kind_word *words = ir_kind_words(node->kind);
    if (node->child_count < words->min_children || !children_have_types(node))
        return NULL;
    switch (node->kind) {
    case IR_NUMBER:
        return number_type(a, node->text);
    case IR_STRING:
        return pointer_to(a, scalar(a, "char"));
    case IR_VARIABLE:
        return node->variable->type;
    case IR_FUNCTION:
        return node->function->type;
    case IR_INDEX:
        return node->children[0]->type->target;
    case IR_MEMBER:
        return node->field->type;
    case IR_UNARY:
        return unary_type(a, node);
    case IR_BINARY:
        return binary_type(a, node);
    case IR_ASSIGN:
        return unqualified(a, node->children[0]->type);
    case IR_CONDITIONAL:
        return conditional_type(a, node);
    case IR_CALL:
        return call_type(a, node);
    case IR_SIZEOF:
        return scalar(a, "ulong");
    default:
        return NULL;
    }
}
