/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts literals and sizeof: their text (even if it is in a macro's body) and their value. */
#include <assert.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"
#include "ir/ir_words.h"
#include "support/buffer.h"

/* ---- values -------------------------------------------------------------------------------- */

/* Evaluates an expression by clang_Cursor_Evaluate. The expression must be scalar, because libclang
 * crashes on other expressions. */
static bool evaluate_integer(CXCursor cursor, int64_t *value) {
    CXEvalResult result = clang_Cursor_Evaluate(cursor);
    if (result == NULL)
        return false;
    bool is_known = clang_EvalResult_getKind(result) == CXEval_Int;
    if (is_known && clang_EvalResult_isUnsignedInt(result)) {
        unsigned long long number = clang_EvalResult_getAsUnsigned(result);
        is_known = number <= INT64_MAX;
        *value = (int64_t)number;
    } else if (is_known) {
        *value = clang_EvalResult_getAsLongLong(result);
    }
    clang_EvalResult_dispose(result);
    return is_known;
}

static bool evaluate_double(CXCursor cursor, double *value) {
    CXEvalResult result = clang_Cursor_Evaluate(cursor);
    if (result == NULL)
        return false;
    bool is_known = clang_EvalResult_getKind(result) == CXEval_Float;
    *value = is_known ? clang_EvalResult_getAsDouble(result) : 0;
    clang_EvalResult_dispose(result);
    return is_known;
}

/* ---- texts --------------------------------------------------------------------------------- */

static bool is_number_byte(const char *p, char before) {
    if ((*p == '+' || *p == '-') && before != 0)
        return strchr("eEpP", before) != NULL;
    return isalnum((unsigned char)*p) || *p == '.' || *p == '_';
}

/* Reads a preprocessing number (C17 6.4.8) without its line splices. NULL if there is none. In a
 * hexadecimal number a sign after "e" is not part of the number, because "e" is a digit there. */
static const char *number_text(converter *c, file_text at) {
    char text[256];
    size_t length = 0;
    const char *p = at.text, *end = at.text + at.length;
    while (p < end && length < sizeof text - 1) {
        unsigned splice = splice_length(p, end);
        char before = length > 0 ? text[length - 1] : 0;
        bool is_hexadecimal = length > 1 && (text[1] == 'x' || text[1] == 'X');
        if (is_hexadecimal && (before == 'e' || before == 'E'))
            before = 0;
        if (splice > 0) {
            p += splice;
        } else if (is_number_byte(p, before)) {
            text[length++] = *p++;
        } else {
            break;
        }
    }
    bool is_number = length > 0 && (isdigit((unsigned char)text[0]) || text[0] == '.');
    return is_number && length < sizeof text - 1 ? arena_copy(c->arena, text, length) : NULL;
}

/* The text of 'a', L'\n' or u8'x', with prefix and quotes; NULL if it has another form. */
static const char *character_text(converter *c, file_text at) {
    size_t i = 0;
    while (i < at.length && (isalnum((unsigned char)at.text[i])))
        i++;
    if (i == at.length || at.text[i] != '\'')
        return NULL;
    for (i++; i < at.length && at.text[i] != '\'' && at.text[i] != '\n'; i++)
        if (at.text[i] == '\\' && i + 1 < at.length && at.text[i + 1] != '\n')
            i++;
    return i < at.length && at.text[i] == '\'' ? arena_copy(c->arena, at.text, i + 1) : NULL;
}

/* The value as a literal such as "97", with the suffix that its type requires. */
static const char *value_text(converter *c, int64_t value, const ir_type *type) {
    const char *suffix = type->size > 4 ? "L" : "";
    if (!type->is_signed && type->size >= 4)
        suffix = type->size > 4 ? "UL" : "U";
    return arena_format(c->arena, "%lld%s", (long long)value, suffix);
}

/* ---- nodes --------------------------------------------------------------------------------- */

static ir_node *new_number(converter *c, CXCursor cursor, const char *text) {
    ir_node *node = ir_new(c->arena, IR_NUMBER, convert_type(c, clang_getCursorType(cursor)), 0);
    node->text = text;
    place_node(c, node, cursor);
    return node;
}

static void set_value(ir_node *node, int64_t value) {
    node->value = value;
    node->flags |= IR_HAS_VALUE;
}

static ir_node *convert_integer(converter *c, CXCursor cursor) {
    file_text at = text_at(c, clang_getCursorLocation(cursor));
    ir_node *node = new_number(c, cursor, number_text(c, at));
    int64_t value;
    if (ir_literal_value(node->text, &value)) {
        set_value(node, value);
    } else if (evaluate_integer(cursor, &value)) {
        set_value(node, value);
        node->text = value_text(c, value, node->type);
    } else if (node->text == NULL) {
        return convert_opaque(c, cursor, node->type, "integer literal");
    }
    return node;
}

static ir_node *convert_floating(converter *c, CXCursor cursor) {
    file_text at = text_at(c, clang_getCursorLocation(cursor));
    ir_node *node = new_number(c, cursor, number_text(c, at));
    double value;
    if (node->text == NULL) {
        if (node->type->size > 8 || !evaluate_double(cursor, &value))
            return convert_opaque(c, cursor, node->type, "floating literal");
        const char *text = arena_format(c->arena, "%.17g", value);
        const char *point = strpbrk(text, ".en") != NULL ? "" : ".0";
        const char *suffix = node->type->size == 4 ? "f" : "";
        node->text = arena_format(c->arena, "%s%s%s", text, point, suffix);
    }
    return node;
}

/* Stores the floating literal's value as an integer. Returns false if the value is no integer, or
 * is so large that the literal's type cannot represent all neighbouring integers. */
static bool whole_value(const ir_node *literal, int64_t *value) {
    const ir_type *type = literal->type;
    if (literal->kind != IR_NUMBER || type->kind != IR_FLOATING || type->size > 8)
        return false;
    char *end;
    const double number = strtod(literal->text, &end);
    const double most = type->size == 4 ? 1 << 24 : (double)(1LL << 53);
    const char *suffix = type->size == 4 ? "fF" : "";
    if (!(number > -most && number < most) || end[strspn(end, suffix)] != '\0')
        return false;
    *value = (int64_t)number;
    return number == (double)*value;
}

static bool type_holds(const ir_type *type, int64_t value) {
    return ir_type_is_plain_integer(type) && !type->is_const && type->size >= 4 &&
           (type->is_signed || value >= 0) && (type->size > 4 || value == (int32_t)value);
}

/* Makes a floating literal an integer literal of the other operand's type, as in i < 1e6. C would
 * convert the integer operand to the floating type. That conversion preserves order and is exact
 * near the literal, so comparing integers gives the same result. */
void compare_as_integers(converter *c, ir_node *comparison) {
    assert(comparison->kind == IR_BINARY && comparison->child_count == 2);
    for (unsigned side = 0; side < 2; side++) {
        ir_node *literal = comparison->children[side];
        const ir_type *type = comparison->children[1 - side]->type;
        int64_t value;
        if (!whole_value(literal, &value) || !type_holds(type, value))
            continue;
        literal->type = type;
        literal->text = value_text(c, value, type);
        set_value(literal, value);
    }
}

static ir_node *convert_character(converter *c, CXCursor cursor) {
    file_text at = text_at(c, clang_getCursorLocation(cursor));
    ir_node *node = new_number(c, cursor, character_text(c, at));
    int64_t value;
    if (!evaluate_integer(cursor, &value))
        return convert_opaque(c, cursor, node->type, "character literal");
    set_value(node, value);
    if (node->text == NULL)
        node->text = value_text(c, value, node->type);
    return node;
}

/* Separates adjacent question marks by a backslash, because some compilers would read them, with
 * the next byte, as a trigraph. */
static const char *without_trigraphs(converter *c, const char *literal) {
    if (strstr(literal, "??") == NULL)
        return literal;
    buffer out = {0};
    for (const char *at = literal; *at; at++)
        buffer_format(&out, at > literal && at[0] == '?' && at[-1] == '?' ? "\\%c" : "%c", *at);
    return buffer_take(c->arena, &out);
}

static ir_node *convert_string(converter *c, CXCursor cursor) {
    const char *literal = take_string(c, clang_getCursorSpelling(cursor));
    ir_node *node = new_number(c, cursor, without_trigraphs(c, literal));
    node->kind = IR_STRING;
    if (strchr(node->text, '"') == NULL)
        return convert_opaque(c, cursor, node->type, "string literal");
    return node;
}

/* Converts a literal such as 1.0iF, which complex.h uses to define I. Such a literal is a GNU
 * extension, so __extension__ is written before it. */
static ir_node *convert_imaginary(converter *c, CXCursor cursor) {
    file_text at = text_at(c, clang_getCursorLocation(cursor));
    const char *literal = number_text(c, at);
    ir_node *node =
        new_number(c, cursor, literal ? arena_format(c->arena, "(__extension__ %s)", literal) : "");
    if (!literal || node->type->kind != IR_COMPLEX)
        return convert_opaque(c, cursor, node->type, "imaginary literal");
    return node;
}

ir_node *convert_literal(converter *c, CXCursor cursor) {
    switch (clang_getCursorKind(cursor)) {
    case CXCursor_IntegerLiteral:
        return convert_integer(c, cursor);
    case CXCursor_FloatingLiteral:
        return convert_floating(c, cursor);
    case CXCursor_CharacterLiteral:
        return convert_character(c, cursor);
    case CXCursor_StringLiteral:
        return convert_string(c, cursor);
    default:
        return convert_imaginary(c, cursor);
    }
}

/* Converts sizeof. In a function with errors the operator is not evaluated, because libclang may
 * crash on ill-formed code. */
ir_node *convert_sizeof(converter *c, CXCursor cursor) {
    const ir_type *type = convert_type(c, clang_getCursorType(cursor));
    int64_t value;
    if (c->function->has_errors || type->kind != IR_INTEGER || !evaluate_integer(cursor, &value))
        return convert_opaque(c, cursor, type, "sizeof of a variable length");
    ir_node *node = ir_new(c->arena, IR_SIZEOF, type, 0);
    place_node(c, node, cursor);
    set_value(node, value);
    node->text = plain_text(c, cursor);
    if (node->text == NULL)
        node->text = value_text(c, value, type);
    return node;
}
