/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Expressions. Implicit conversions and parentheses are looked through. */
#include <inttypes.h>
#include <string.h>

#include "frontend/translation.h"

static bool is_clang_expression(CXCursor cursor) {
    return clang_isExpression(clang_getCursorKind(cursor)) != 0;
}

ir_node *node_new(translation *t, CXCursor cursor, ir_kind kind, unsigned child_count) {
    const ir_type *type =
        is_clang_expression(cursor) ? translate_type(t, clang_getCursorType(cursor)) : NULL;
    ir_node *node = ir_new(t->arena, kind, type, child_count);
    node->range = place_range(t, cursor);
    if (!place_is_plain(t, cursor))
        node->flags |= IR_FROM_MACRO;
    return node;
}

static ir_node *translate_any(translation *t, CXCursor cursor) {
    const enum CXCursorKind kind = clang_getCursorKind(cursor);
    if (clang_isExpression(kind))
        return translate_expression(t, cursor);
    if (clang_isStatement(kind))
        return translate_statement(t, cursor);
    return NULL;
}

ir_node *node_opaque(translation *t, CXCursor cursor, const char *what) {
    const cursor_list children = children_of(t, cursor);
    node_list list = {0};
    for (unsigned i = 0; i < children.count; i++) {
        ir_node *child = translate_any(t, children.items[i]);
        if (child)
            VECTOR_PUSH(t->arena, &list, child);
    }
    ir_node *node = node_new(t, cursor, IR_OPAQUE, list.count);
    if (list.count)
        memcpy(node->children, list.items, list.count * sizeof *list.items);
    node->text = what;
    return node;
}

ir_node *node_with_children(translation *t, CXCursor cursor, ir_kind kind, const cursor_list *list,
                            unsigned first) {
    ir_node *node = node_new(t, cursor, kind, list->count - first);
    for (unsigned i = first; i < list->count; i++)
        node->children[i - first] = translate_any(t, list->items[i]);
    return node;
}

static bool same_extent(CXCursor a, CXCursor b) {
    return clang_equalRanges(clang_getCursorExtent(a), clang_getCursorExtent(b)) != 0;
}

/* ---- literals ------------------------------------------------------------------------------ */

static const char *integer_text(translation *t, const ir_type *type, int64_t value) {
    const char *suffix = type->size > 4    ? (type->is_signed ? "L" : "UL")
                         : type->is_signed ? ""
                                           : "U";
    return type->is_signed || type->size < 4
               ? arena_format(t->arena, "%" PRId64 "%s", value, type->size < 4 ? "" : suffix)
               : arena_format(t->arena, "%" PRIu64 "%s", (uint64_t)value, suffix);
}

/* The constant's value, where it is an integer that libclang can tell. */
static bool evaluate(CXCursor cursor, int64_t *value) {
    CXEvalResult result = clang_Cursor_Evaluate(cursor);
    if (!result)
        return false;
    const bool is_integer = clang_EvalResult_getKind(result) == CXEval_Int;
    if (is_integer)
        *value = clang_EvalResult_isUnsignedInt(result)
                     ? (int64_t)clang_EvalResult_getAsUnsigned(result)
                     : clang_EvalResult_getAsLongLong(result);
    clang_EvalResult_dispose(result);
    return is_integer;
}

static ir_node *integer_literal(translation *t, CXCursor cursor, bool keep_text) {
    ir_node *node = node_new(t, cursor, IR_NUMBER, 0);
    if (!evaluate(cursor, &node->value))
        return node_opaque(t, cursor, "literal");
    node->flags |= IR_HAS_VALUE;
    node->text = keep_text ? place_token(t, cursor) : NULL;
    if (!node->text)
        node->text = integer_text(t, node->type, node->value);
    return node;
}

static ir_node *floating_literal(translation *t, CXCursor cursor) {
    ir_node *node = node_new(t, cursor, IR_NUMBER, 0);
    node->text = place_token(t, cursor);
    return node->text ? node : node_opaque(t, cursor, "literal");
}

static ir_node *size_of(translation *t, CXCursor cursor) {
    ir_node *node = node_new(t, cursor, IR_SIZEOF, 0);
    if (!evaluate(cursor, &node->value))
        return node_opaque(t, cursor, "sizeof");
    node->flags |= IR_HAS_VALUE;
    node->text = integer_text(t, node->type, node->value);
    return node;
}

/* ---- names --------------------------------------------------------------------------------- */

static ir_node *reference(translation *t, CXCursor cursor) {
    const CXCursor declaration = clang_getCursorReferenced(cursor);
    ir_node *node;
    switch (clang_getCursorKind(declaration)) {
    case CXCursor_VarDecl:
    case CXCursor_ParmDecl:
        node = node_new(t, cursor, IR_VARIABLE, 0);
        node->variable = translate_variable(t, declaration);
        return node;
    case CXCursor_FunctionDecl:
        node = node_new(t, cursor, IR_FUNCTION, 0);
        node->function = translate_function(t, declaration);
        return node;
    case CXCursor_EnumConstantDecl:
        node = node_new(t, cursor, IR_NUMBER, 0);
        node->value = clang_getEnumConstantDeclValue(declaration);
        node->flags |= IR_HAS_VALUE;
        node->text = take_string(t, clang_getCursorSpelling(declaration));
        return node;
    default:
        return node_opaque(t, cursor, "name");
    }
}

static ir_node *member(translation *t, CXCursor cursor) {
    const cursor_list children = children_of(t, cursor);
    const CXCursor field = clang_getCursorReferenced(cursor);
    if (children.count == 0 || clang_getCursorKind(field) != CXCursor_FieldDecl)
        return node_opaque(t, cursor, "member");
    ir_node *object = translate_expression(t, children.items[0]);
    ir_node *node = node_new(t, cursor, IR_MEMBER, 1);
    node->children[0] = object;
    node->field = translate_field(t, field);
    if (object->type && object->type->kind == IR_POINTER)
        node->flags |= IR_ARROW;
    return node->field ? node : node_opaque(t, cursor, "member");
}

/* ---- operators ----------------------------------------------------------------------------- */

static ir_operator binary_operator(enum CXBinaryOperatorKind kind) {
    switch (kind) {
    case CXBinaryOperator_Add:
    case CXBinaryOperator_AddAssign:
        return IR_OP_ADD;
    case CXBinaryOperator_Sub:
    case CXBinaryOperator_SubAssign:
        return IR_OP_SUBTRACT;
    case CXBinaryOperator_Mul:
    case CXBinaryOperator_MulAssign:
        return IR_OP_MULTIPLY;
    case CXBinaryOperator_Div:
    case CXBinaryOperator_DivAssign:
        return IR_OP_DIVIDE;
    case CXBinaryOperator_Rem:
    case CXBinaryOperator_RemAssign:
        return IR_OP_REMAINDER;
    case CXBinaryOperator_Shl:
    case CXBinaryOperator_ShlAssign:
        return IR_OP_SHIFT_LEFT;
    case CXBinaryOperator_Shr:
    case CXBinaryOperator_ShrAssign:
        return IR_OP_SHIFT_RIGHT;
    case CXBinaryOperator_And:
    case CXBinaryOperator_AndAssign:
        return IR_OP_BIT_AND;
    case CXBinaryOperator_Or:
    case CXBinaryOperator_OrAssign:
        return IR_OP_BIT_OR;
    case CXBinaryOperator_Xor:
    case CXBinaryOperator_XorAssign:
        return IR_OP_BIT_XOR;
    case CXBinaryOperator_LT:
        return IR_OP_LESS;
    case CXBinaryOperator_GT:
        return IR_OP_GREATER;
    case CXBinaryOperator_LE:
        return IR_OP_LESS_EQUAL;
    case CXBinaryOperator_GE:
        return IR_OP_GREATER_EQUAL;
    case CXBinaryOperator_EQ:
        return IR_OP_EQUAL;
    case CXBinaryOperator_NE:
        return IR_OP_NOT_EQUAL;
    case CXBinaryOperator_LAnd:
        return IR_OP_AND;
    case CXBinaryOperator_LOr:
        return IR_OP_OR;
    case CXBinaryOperator_Comma:
        return IR_OP_COMMA;
    default:
        return IR_OP_NONE;
    }
}

static ir_operator unary_operator(enum CXUnaryOperatorKind kind) {
    switch (kind) {
    case CXUnaryOperator_PostInc:
        return IR_OP_POST_INCREMENT;
    case CXUnaryOperator_PostDec:
        return IR_OP_POST_DECREMENT;
    case CXUnaryOperator_PreInc:
        return IR_OP_PRE_INCREMENT;
    case CXUnaryOperator_PreDec:
        return IR_OP_PRE_DECREMENT;
    case CXUnaryOperator_AddrOf:
        return IR_OP_ADDRESS;
    case CXUnaryOperator_Deref:
        return IR_OP_DEREFERENCE;
    case CXUnaryOperator_Plus:
        return IR_OP_PLUS;
    case CXUnaryOperator_Minus:
        return IR_OP_MINUS;
    case CXUnaryOperator_Not:
        return IR_OP_BIT_NOT;
    case CXUnaryOperator_LNot:
        return IR_OP_NOT;
    case CXUnaryOperator_Real:
        return IR_OP_REAL;
    case CXUnaryOperator_Imag:
        return IR_OP_IMAG;
    default:
        return IR_OP_NONE;
    }
}

static ir_node *binary(translation *t, CXCursor cursor, const cursor_list *children) {
    const enum CXBinaryOperatorKind kind = clang_getCursorBinaryOperatorKind(cursor);
    const bool assigns = kind >= CXBinaryOperator_Assign && kind <= CXBinaryOperator_OrAssign;
    const ir_operator op = binary_operator(kind);
    if (children->count != 2 || (op == IR_OP_NONE && kind != CXBinaryOperator_Assign))
        return node_opaque(t, cursor, "operator");
    ir_node *node = node_with_children(t, cursor, assigns ? IR_ASSIGN : IR_BINARY, children, 0);
    node->op = op;
    return node;
}

static ir_node *unary(translation *t, CXCursor cursor, const cursor_list *children) {
    const enum CXUnaryOperatorKind kind = clang_getCursorUnaryOperatorKind(cursor);
    if (kind == CXUnaryOperator_Extension && children->count == 1)
        return translate_expression(t, children->items[0]);
    const ir_operator op = unary_operator(kind);
    if (children->count != 1 || op == IR_OP_NONE)
        return node_opaque(t, cursor, "operator");
    ir_node *node = node_with_children(t, cursor, IR_UNARY, children, 0);
    node->op = op;
    return node;
}

static ir_node *subscript(translation *t, CXCursor cursor, const cursor_list *children) {
    if (children->count != 2)
        return node_opaque(t, cursor, "subscript");
    ir_node *node = node_with_children(t, cursor, IR_INDEX, children, 0);
    ir_node *first = node->children[0];
    const ir_type *type = first->type;
    if (type && type->kind != IR_POINTER && type->kind != IR_ARRAY) {
        node->children[0] = node->children[1];
        node->children[1] = first;
    }
    type = node->children[0]->type;
    if (!type || (type->kind != IR_POINTER && type->kind != IR_ARRAY))
        return node_opaque(t, cursor, "subscript");
    return node;
}

/* ---- lists --------------------------------------------------------------------------------- */

/* A designated initialiser: an unexposed expression that names a field or an index first. */
static bool is_designated(CXCursor value, const cursor_list *inside) {
    if (clang_getCursorKind(value) != CXCursor_UnexposedExpr || inside->count == 0)
        return false;
    return clang_getCursorKind(inside->items[0]) == CXCursor_MemberRef ||
           !same_extent(value, inside->items[inside->count - 1]);
}

static ir_node *initializers(translation *t, CXCursor cursor, const cursor_list *children) {
    ir_node *node = node_new(t, cursor, IR_INITIALIZERS, children->count);
    for (unsigned i = 0; i < children->count; i++) {
        CXCursor value = children->items[i];
        const cursor_list inside = children_of(t, value);
        if (is_designated(value, &inside)) {
            node->flags |= IR_DESIGNATED;
            value = inside.items[inside.count - 1];
        }
        node->children[i] = translate_any(t, value);
        if (!node->children[i])
            return node_opaque(t, cursor, "initialiser");
    }
    return node;
}

static ir_node *compound_literal(translation *t, CXCursor cursor, const cursor_list *children) {
    for (unsigned i = 0; i < children->count; i++)
        if (clang_getCursorKind(children->items[i]) == CXCursor_InitListExpr) {
            ir_node *node = translate_expression(t, children->items[i]);
            node->flags |= IR_COMPOUND_LITERAL;
            node->range = place_range(t, cursor);
            return node;
        }
    return node_opaque(t, cursor, "compound literal");
}

static ir_node *cast(translation *t, CXCursor cursor, const cursor_list *children) {
    if (children->count == 0)
        return node_opaque(t, cursor, "cast");
    return node_with_children(t, cursor, IR_CAST, children, children->count - 1);
}

/* ---- all of them --------------------------------------------------------------------------- */

static ir_node *by_kind(translation *t, CXCursor cursor) {
    const cursor_list children = children_of(t, cursor);
    switch (clang_getCursorKind(cursor)) {
    case CXCursor_UnexposedExpr: /* an implicit conversion */
        if (children.count == 1 && is_clang_expression(children.items[0]) &&
            same_extent(cursor, children.items[0]))
            return translate_expression(t, children.items[0]);
        return node_opaque(t, cursor, "expression");
    case CXCursor_ParenExpr:
        return children.count == 1 ? translate_expression(t, children.items[0])
                                   : node_opaque(t, cursor, "expression");
    case CXCursor_DeclRefExpr:
        return reference(t, cursor);
    case CXCursor_IntegerLiteral:
        return integer_literal(t, cursor, true);
    case CXCursor_CharacterLiteral:
        return integer_literal(t, cursor, false);
    case CXCursor_FloatingLiteral:
        return floating_literal(t, cursor);
    case CXCursor_StringLiteral: {
        ir_node *node = node_new(t, cursor, IR_STRING, 0);
        node->text = take_string(t, clang_getCursorSpelling(cursor));
        return node;
    }
    case CXCursor_MemberRefExpr:
        return member(t, cursor);
    case CXCursor_ArraySubscriptExpr:
        return subscript(t, cursor, &children);
    case CXCursor_CallExpr:
        return children.count ? node_with_children(t, cursor, IR_CALL, &children, 0)
                              : node_opaque(t, cursor, "call");
    case CXCursor_UnaryOperator:
        return unary(t, cursor, &children);
    case CXCursor_BinaryOperator:
    case CXCursor_CompoundAssignOperator:
        return binary(t, cursor, &children);
    case CXCursor_ConditionalOperator:
        return children.count == 3 ? node_with_children(t, cursor, IR_CONDITIONAL, &children, 0)
                                   : node_opaque(t, cursor, "expression");
    case CXCursor_CStyleCastExpr:
        return cast(t, cursor, &children);
    case CXCursor_UnaryExpr:
        return size_of(t, cursor);
    case CXCursor_InitListExpr:
        return initializers(t, cursor, &children);
    case CXCursor_CompoundLiteralExpr:
        return compound_literal(t, cursor, &children);
    case CXCursor_StmtExpr:
        return node_opaque(t, cursor, "statement expression");
    default:
        return node_opaque(t, cursor, "expression");
    }
}

ir_node *translate_expression(translation *t, CXCursor cursor) {
    if (t->depth >= DEEPEST_NESTING) {
        t->too_deep = true;
        ir_node *node = node_new(t, cursor, IR_OPAQUE, 0);
        node->text = "nested too deeply";
        return node;
    }
    t->depth++;
    ir_node *node = by_kind(t, cursor);
    t->depth--;
    return node;
}
