/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts expressions. */
#include <assert.h>
#include <string.h>

#include "frontend/convert.h"

/* ---- children ------------------------------------------------------------------------------ */

static enum CXChildVisitResult collect_child(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    converter *c = data;
    enum CXCursorKind kind = clang_getCursorKind(child);
    if (clang_isExpression(kind) || clang_isStatement(kind))
        VECTOR_PUSH(c->arena, &c->collected, child);
    return CXChildVisit_Continue;
}

cursor_list children_of(converter *c, CXCursor cursor) {
    const unsigned first = c->collected.count;
    clang_visitChildren(cursor, collect_child, c);
    assert(c->collected.count >= first);
    cursor_list list = {.count = c->collected.count - first};
    list.capacity = list.count;
    if (list.count > 0) {
        list.items = ARENA_ARRAY(c->scratch, CXCursor, list.count);
        memcpy(list.items, c->collected.items + first, list.count * sizeof(CXCursor));
    }
    c->collected.count = first;
    return list;
}

/* ---- creating nodes -------------------------------------------------------------------------- */

static const ir_type *type_of(converter *c, CXCursor cursor) {
    return convert_type(c, clang_getCursorType(cursor));
}

/* May an expression of this kind have array type? Only expressions that name or reach an object
 * may; see decayed(). */
static bool may_be_array(ir_kind kind) {
    return kind == IR_VARIABLE || kind == IR_INDEX || kind == IR_MEMBER || kind == IR_UNARY ||
           kind == IR_INITIALIZERS;
}

static ir_node *new_expression(converter *c, CXCursor cursor, ir_kind kind, unsigned child_count) {
    const ir_type *type = type_of(c, cursor);
    if (!may_be_array(kind))
        type = decayed(c, type);
    ir_node *node = ir_new(c->arena, kind, type, child_count);
    place_node(c, node, cursor);
    return node;
}

/* Creates a node whose children are the given expressions, in this order. */
static ir_node *convert_parts(converter *c, CXCursor cursor, ir_kind kind,
                              const cursor_list *parts) {
    ir_node *node = new_expression(c, cursor, kind, parts->count);
    for (unsigned i = 0; i < parts->count; i++)
        node->children[i] = convert_expression(c, parts->items[i]);
    return node;
}

ir_node *convert_opaque(converter *c, CXCursor cursor, const ir_type *type, const char *what) {
    cursor_list parts = children_of(c, cursor);
    ir_node *node = ir_new(c->arena, IR_OPAQUE, type, parts.count);
    place_node(c, node, cursor);
    node->text = what;
    for (unsigned i = 0; i < parts.count; i++)
        node->children[i] = convert_any(c, parts.items[i]);
    return node;
}

static ir_node *opaque_expression(converter *c, CXCursor cursor, const char *what) {
    return convert_opaque(c, cursor, decayed(c, type_of(c, cursor)), what);
}

/* ---- names --------------------------------------------------------------------------------- */

static ir_node *convert_enumerator(converter *c, CXCursor cursor, CXCursor enumerator) {
    ir_node *node = new_expression(c, cursor, IR_NUMBER, 0);
    node->text = take_string(c, clang_getCursorSpelling(enumerator));
    node->value = clang_getEnumConstantDeclValue(enumerator);
    node->flags |= IR_HAS_VALUE;
    return node;
}

static ir_node *convert_name(converter *c, CXCursor cursor) {
    CXCursor declaration = clang_getCursorReferenced(cursor);
    ir_node *node;
    switch (clang_getCursorKind(declaration)) {
    case CXCursor_VarDecl:
    case CXCursor_ParmDecl:
        node = new_expression(c, cursor, IR_VARIABLE, 0);
        node->variable = convert_variable(c, declaration);
        if (node->variable->storage == IR_PARAMETER)
            node->type = node->variable->type;
        return node;
    case CXCursor_FunctionDecl:
        node = new_expression(c, cursor, IR_FUNCTION, 0);
        node->function = convert_function(c, declaration);
        node->type = node->function->type;
        return node;
    case CXCursor_EnumConstantDecl:
        return convert_enumerator(c, cursor, declaration);
    default:
        return opaque_expression(c, cursor, "name");
    }
}

/* ---- operators ----------------------------------------------------------------------------- */

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

static ir_operator binary_operator(enum CXBinaryOperatorKind kind) {
    switch (kind) {
    case CXBinaryOperator_Mul:
    case CXBinaryOperator_MulAssign:
        return IR_OP_MULTIPLY;
    case CXBinaryOperator_Div:
    case CXBinaryOperator_DivAssign:
        return IR_OP_DIVIDE;
    case CXBinaryOperator_Rem:
    case CXBinaryOperator_RemAssign:
        return IR_OP_REMAINDER;
    case CXBinaryOperator_Add:
    case CXBinaryOperator_AddAssign:
        return IR_OP_ADD;
    case CXBinaryOperator_Sub:
    case CXBinaryOperator_SubAssign:
        return IR_OP_SUBTRACT;
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

static ir_node *convert_unary(converter *c, CXCursor cursor) {
    enum CXUnaryOperatorKind kind = clang_getCursorUnaryOperatorKind(cursor);
    cursor_list parts = children_of(c, cursor);
    if (parts.count == 1 && kind == CXUnaryOperator_Extension)
        return convert_expression(c, parts.items[0]);
    ir_operator op = unary_operator(kind);
    if (parts.count != 1 || op == IR_OP_NONE)
        return opaque_expression(c, cursor, "unary operator");
    ir_node *node = convert_parts(c, cursor, IR_UNARY, &parts);
    node->op = op;
    if (op == IR_OP_ADDRESS && node->children[0]->type->kind != IR_FUNCTION_TYPE)
        node->type = pointer_to(c, node->children[0]->type);
    else if (op != IR_OP_DEREFERENCE)
        node->type = decayed(c, node->type);
    return node;
}

static ir_node *convert_binary(converter *c, CXCursor cursor) {
    enum CXBinaryOperatorKind kind = clang_getCursorBinaryOperatorKind(cursor);
    cursor_list parts = children_of(c, cursor);
    bool is_assignment = kind == CXBinaryOperator_Assign;
    bool is_compound = clang_getCursorKind(cursor) == CXCursor_CompoundAssignOperator;
    ir_operator op = binary_operator(kind);
    if (parts.count != 2 || (op == IR_OP_NONE && !is_assignment))
        return opaque_expression(c, cursor, "binary operator");
    ir_node *node =
        convert_parts(c, cursor, is_assignment || is_compound ? IR_ASSIGN : IR_BINARY, &parts);
    node->op = op;
    if (node->kind == IR_BINARY && op >= IR_OP_LESS && op <= IR_OP_NOT_EQUAL)
        compare_as_integers(c, node);
    return node;
}

static ir_node *convert_conditional(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 3)
        return opaque_expression(c, cursor, "conditional");
    return convert_parts(c, cursor, IR_CONDITIONAL, &parts);
}

/* ---- access -------------------------------------------------------------------------------- */

/* Is the expression a pointer, or an array that becomes a pointer when its value is used? */
static bool is_pointer(CXCursor cursor) {
    enum CXTypeKind kind = clang_getCanonicalType(clang_getCursorType(cursor)).kind;
    return kind == CXType_Pointer || kind == CXType_ConstantArray ||
           kind == CXType_IncompleteArray || kind == CXType_VariableArray;
}

/* Converts a subscript. clang gives the parts in the order of the text, so for 3[a] they are
 * exchanged here. */
static ir_node *convert_subscript(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 2 || (!is_pointer(parts.items[0]) && !is_pointer(parts.items[1])))
        return opaque_expression(c, cursor, "subscript of a vector");
    unsigned array = is_pointer(parts.items[0]) ? 0 : 1;
    ir_node *first = convert_expression(c, parts.items[0]);
    ir_node *second = convert_expression(c, parts.items[1]);
    ir_node *node = new_expression(c, cursor, IR_INDEX, 2);
    node->children[0] = array == 0 ? first : second;
    node->children[1] = array == 0 ? second : first;
    return node;
}

/* Returns the record's field `wanted` if it is the record's own. Otherwise returns the record's
 * anonymous member that contains `wanted`; NULL if there is none. */
static const ir_field *field_containing(const ir_record *record, const ir_field *wanted) {
    for (unsigned i = 0; i < record->field_count; i++) {
        const ir_field *field = &record->fields[i];
        bool is_anonymous = field->name[0] == 0 && field->type->record != NULL;
        if (field == wanted ||
            (is_anonymous && field_containing(field->type->record, wanted) != NULL))
            return field;
    }
    return NULL;
}

static ir_node *member_node(converter *c, CXCursor cursor, ir_node *object, const ir_field *field) {
    ir_node *node = ir_new(c->arena, IR_MEMBER, field->type, 1);
    place_node(c, node, cursor);
    node->children[0] = object;
    node->field = field;
    return node;
}

/* Converts a member access. clang omits the anonymous members between the object and the named
 * member. Here each of them becomes a separate node. */
static ir_node *convert_member(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    CXCursor declaration = clang_getCursorReferenced(cursor);
    const ir_field *field = NULL;
    if (clang_getCursorKind(declaration) == CXCursor_FieldDecl)
        field = convert_field(c, declaration);
    if (parts.count != 1 || field == NULL)
        return opaque_expression(c, cursor, "member");
    bool is_arrow = is_pointer(parts.items[0]);
    const ir_type *object_type = type_of(c, parts.items[0]);
    const ir_record *record = is_arrow ? object_type->target->record : object_type->record;
    const ir_field *step = record != NULL ? field_containing(record, field) : NULL;
    if (step == NULL)
        return opaque_expression(c, cursor, "member");
    ir_node *node = member_node(c, cursor, convert_expression(c, parts.items[0]), step);
    if (is_arrow)
        node->flags |= IR_ARROW;
    while (step != field) {
        step = field_containing(step->type->record, field);
        assert(step);
        node = member_node(c, cursor, node, step);
    }
    node->type = type_of(c, cursor); /* includes the qualifiers of the object */
    return node;
}

/* Does the builtin only query its operands, without evaluating them? */
static bool evaluates_nothing(const ir_node *callee) {
    static const char *const names[] = {
        "__builtin_constant_p",     "__builtin_object_size", "__builtin_dynamic_object_size",
        "__builtin_classify_type",  "__builtin_assume",      "__builtin_nondeterministic_value",
        "__builtin_counted_by_ref",
    };
    for (size_t i = 0; callee->kind == IR_FUNCTION && i < sizeof names / sizeof *names; i++)
        if (strcmp(callee->function->name, names[i]) == 0)
            return true;
    return false;
}

static ir_node *convert_call(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    int count = clang_Cursor_getNumArguments(cursor);
    if (count < 0 || parts.count != (unsigned)count + 1)
        return opaque_expression(c, cursor, "call");
    ir_node *call = convert_parts(c, cursor, IR_CALL, &parts);
    const bool is_unevaluated = call->kind == IR_CALL && evaluates_nothing(call->children[0]);
    for (unsigned i = 1; is_unevaluated && i < call->child_count; i++)
        if (ir_has_effect(call->children[i]))
            return opaque_expression(c, cursor, "operand that is not evaluated");
    return call;
}

/* ---- casts, literals ----------------------------------------------------------------------- */

/* Converts a cast. Its operand is the last part. The parts before it are expressions in the type.
 * Some of these are lengths, as in double (*)[n], which the cast evaluates. Others, such as the
 * operand of a typeof, are not evaluated. */
static ir_node *convert_cast(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count == 0 || (parts.count > 1 && has_variable_length(type_of(c, cursor))))
        return opaque_expression(c, cursor, "cast to a type of variable length");
    cursor_list operand = {.items = &parts.items[parts.count - 1], .count = 1};
    return convert_parts(c, cursor, IR_CAST, &operand);
}

static bool is_braces(CXCursor cursor) {
    return clang_getCursorKind(cursor) == CXCursor_InitListExpr;
}

static ir_node *convert_compound_literal(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    unsigned last = parts.count - 1; /* the parts before the last are expressions in the type */
    if (parts.count == 0 || !is_braces(parts.items[last]) ||
        has_variable_length(type_of(c, cursor)))
        return opaque_expression(c, cursor, "compound literal");
    ir_node *node = convert_braces(c, parts.items[last]);
    node->type = type_of(c, cursor);
    node->flags |= IR_COMPOUND_LITERAL;
    place_node(c, node, cursor);
    return node;
}

/* Is the initialiser designated, as in `[3] = x` or `.a.b = x`? clang shows it as an expression of
 * type void whose last part is the value. */
static bool is_designated(CXCursor cursor) {
    return clang_getCursorKind(cursor) == CXCursor_UnexposedExpr &&
           clang_getCursorType(cursor).kind == CXType_Void;
}

ir_node *convert_braces(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    ir_node *node = new_expression(c, cursor, IR_INITIALIZERS, parts.count);
    for (unsigned i = 0; i < parts.count; i++) {
        CXCursor value = parts.items[i];
        if (is_designated(value)) {
            cursor_list inner = children_of(c, value);
            node->flags |= IR_DESIGNATED;
            if (inner.count > 0)
                value = inner.items[inner.count - 1];
        }
        node->children[i] = convert_expression(c, value);
    }
    return node;
}

/* Converts a generic selection to the chosen expression. clang does not show which association it
 * chose. It is the association whose type is the type of the whole, if there is only one. The first
 * part is normally the controlling expression, which is not evaluated. If a type replaces that
 * expression (clang's extension, C2y), the first part is an association instead. A choice of the
 * first part therefore becomes opaque. */
static ir_node *convert_generic(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    CXType type = clang_getCanonicalType(clang_getCursorType(cursor));
    unsigned chosen = parts.count;
    for (unsigned i = 0; i < parts.count; i++)
        if (clang_equalTypes(clang_getCanonicalType(clang_getCursorType(parts.items[i])), type)) {
            if (chosen != parts.count)
                return opaque_expression(c, cursor, "generic selection");
            chosen = i;
        }
    if (chosen == 0 || chosen == parts.count)
        return opaque_expression(c, cursor, "generic selection");
    return convert_expression(c, parts.items[chosen]);
}

/* ---- nodes that libclang does not expose ----------------------------------------------------- */

static bool has_same_extent(converter *c, CXCursor a, CXCursor b) {
    return clang_equalRanges(extent_of(c, a), extent_of(c, b)) != 0;
}

/* Converts an unexposed expression. An implicit conversion has one part, with the same extent, to
 * which it is converted. All other unexposed expressions become opaque: `a ?: b`, va_arg, offsetof,
 * atomic builtins and so on. */
static ir_node *convert_unexposed(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count == 1 && has_same_extent(c, cursor, parts.items[0]))
        return convert_expression(c, parts.items[0]);
    const char *text = plain_text(c, cursor);
    return opaque_expression(c, cursor, text != NULL ? text : "expression");
}

static ir_node *convert_parentheses(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 1)
        return opaque_expression(c, cursor, "parentheses");
    return convert_expression(c, parts.items[0]);
}

/* ---- all ----------------------------------------------------------------------------------- */

bool enter_level(converter *c, CXCursor cursor, ir_node **result) {
    assert(c->depth <= DEEPEST_NODE);
    if (c->depth < DEEPEST_NODE) {
        c->depth++;
        return true;
    }
    c->function->has_errors = true;
    const bool is_expression = clang_isExpression(clang_getCursorKind(cursor)) != 0;
    *result = ir_new(c->arena, IR_OPAQUE, is_expression ? type_of(c, cursor) : NULL, 0);
    (*result)->text = "nested too deeply";
    place_node(c, *result, cursor);
    return false;
}

static ir_node *convert_by_kind(converter *c, CXCursor cursor) {
    switch (clang_getCursorKind(cursor)) {
    case CXCursor_DeclRefExpr:
        return convert_name(c, cursor);
    case CXCursor_IntegerLiteral:
    case CXCursor_FloatingLiteral:
    case CXCursor_CharacterLiteral:
    case CXCursor_StringLiteral:
    case CXCursor_ImaginaryLiteral:
        return convert_literal(c, cursor);
    case CXCursor_ParenExpr:
        return convert_parentheses(c, cursor);
    case CXCursor_UnexposedExpr:
        return convert_unexposed(c, cursor);
    case CXCursor_UnaryOperator:
        return convert_unary(c, cursor);
    case CXCursor_BinaryOperator:
    case CXCursor_CompoundAssignOperator:
        return convert_binary(c, cursor);
    case CXCursor_ConditionalOperator:
        return convert_conditional(c, cursor);
    case CXCursor_ArraySubscriptExpr:
        return convert_subscript(c, cursor);
    case CXCursor_MemberRefExpr:
        return convert_member(c, cursor);
    case CXCursor_CallExpr:
        return convert_call(c, cursor);
    case CXCursor_CStyleCastExpr:
        return convert_cast(c, cursor);
    case CXCursor_CompoundLiteralExpr:
        return convert_compound_literal(c, cursor);
    case CXCursor_InitListExpr:
        return convert_braces(c, cursor);
    case CXCursor_GenericSelectionExpr:
        return convert_generic(c, cursor);
    case CXCursor_UnaryExpr:
        return convert_sizeof(c, cursor);
    case CXCursor_StmtExpr:
        return opaque_expression(c, cursor, "statement expression");
    case CXCursor_AddrLabelExpr:
        return opaque_expression(c, cursor, "address of a label");
    default:
        return opaque_expression(c, cursor, "expression");
    }
}

ir_node *convert_expression(converter *c, CXCursor cursor) {
    ir_node *node;
    if (!enter_level(c, cursor, &node))
        return node;
    node = convert_by_kind(c, cursor);
    assert(c->depth > 0);
    c->depth--;
    return node;
}
