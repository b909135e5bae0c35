/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_syntax.h"

#include <assert.h>
#include <string.h>

/* ---- equality ------------------------------------------------------------------------------ */

static bool is_dereference(const ir_node *node) {
    return node && node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE;
}

/** The pointer p of p->f or (*p).f; NULL for o.f. */
static const ir_node *pointer_of_member(const ir_node *member) {
    const ir_node *object = ir_child(member, 0);
    if (member->flags & IR_ARROW)
        return object;
    return is_dereference(object) ? ir_child(object, 0) : NULL;
}

static bool same_members(const ir_node *left, const ir_node *right) {
    if (left->field != right->field) {
        if (!left->field || !right->field || left->field->offset != right->field->offset ||
            strcmp(left->field->name, right->field->name) != 0)
            return false;
    }
    const ir_node *left_pointer = pointer_of_member(left);
    const ir_node *right_pointer = pointer_of_member(right);
    if (left_pointer && right_pointer)
        return syntax_same(left_pointer, right_pointer);
    return !left_pointer && !right_pointer && syntax_same(ir_child(left, 0), ir_child(right, 0));
}

/** The pointer p of *p or p[0]; otherwise NULL. */
static const ir_node *pointer_of_first(const ir_node *node) {
    if (is_dereference(node))
        return ir_child(node, 0);
    const ir_node *subscript = node->kind == IR_INDEX ? ir_child(node, 1) : NULL;
    return subscript && (subscript->flags & IR_HAS_VALUE) && subscript->value == 0
               ? ir_child(node, 0)
               : NULL;
}

bool syntax_same(const ir_node *left, const ir_node *right) {
    if (!left || !right)
        return left == right;
    const ir_node *left_pointer = pointer_of_first(left), *right_pointer = pointer_of_first(right);
    if (left_pointer && right_pointer)
        return syntax_same(left_pointer, right_pointer);
    if (left->kind != right->kind || left->op != right->op)
        return false;
    switch (left->kind) {
    case IR_OPAQUE:
    case IR_ASSIGN:
    case IR_CALL:
        return false;
    case IR_MEMBER:
        return same_members(left, right);
    case IR_VARIABLE:
        return left->variable == right->variable;
    case IR_FUNCTION:
        return left->function == right->function;
    case IR_NUMBER:
        if ((left->flags & IR_HAS_VALUE) && (right->flags & IR_HAS_VALUE))
            return left->value == right->value && ir_type_equal(left->type, right->type);
        return source_same_text(left->text, right->text);
    case IR_SIZEOF: /* elsewhere, the same text may denote another type */
        if (!(left->flags & IR_HAS_VALUE) || !(right->flags & IR_HAS_VALUE))
            return false;
        return left->value == right->value && ir_type_equal(left->type, right->type);
    case IR_STRING:
        return source_same_text(left->text, right->text);
    case IR_CAST:
        if (!ir_type_equal(left->type, right->type))
            return false;
        break;
    default:
        break;
    }
    if (left->child_count != right->child_count)
        return false;
    for (unsigned i = 0; i < left->child_count; i++)
        if (!syntax_same(left->children[i], right->children[i]))
            return false;
    return true;
}

/* ---- ends ---------------------------------------------------------------------------------- */

/** Returns the offset after the `;` that follows `at`. If no `;` follows, because it is in a
 *  macro's body, returns `at`. */
static uint32_t after_semicolon(const source *s, uint32_t at) {
    assert(at <= s->length);
    const uint32_t next = source_skip_blanks(s, at, (uint32_t)s->length);
    return next < s->length && s->text[next] == ';' ? next + 1 : at;
}

uint32_t syntax_statement_end(const source *text, const ir_node *statement) {
    const uint32_t end = statement->range.end;
    assert(end <= text->length);
    switch (statement->kind) {
    case IR_IF:
    case IR_FOR:
    case IR_WHILE:
    case IR_SWITCH:
    case IR_CASE:
    case IR_DEFAULT:
    case IR_LABEL: {
        const ir_node *last =
            statement->child_count > 0 ? statement->children[statement->child_count - 1] : NULL;
        if (!last || last->range.begin == last->range.end)
            return after_semicolon(text, end); /* an empty statement at an unknown offset */
        const uint32_t last_end = syntax_statement_end(text, last);
        return last_end > end ? last_end : end;
    }
    case IR_BLOCK:
        return statement->flags & IR_SEQUENCE ? after_semicolon(text, end) : end;
    case IR_DECLARATION:
        return end;
    case IR_EMPTY:
        return end > 0 && text->text[end - 1] == ';' ? end : after_semicolon(text, end);
    default:
        return after_semicolon(text, end);
    }
}

/* ---- statements ---------------------------------------------------------------------------- */

static bool syntax_is_statement(const ir_node *node) {
    return node->kind >= IR_BLOCK && node->kind != IR_DECLARATOR;
}

const ir_node *syntax_enclosing_statement(const ir_node *node, const ir_node *outer) {
    while (node && node != outer && !syntax_is_statement(node))
        node = node->parent;
    return node;
}

static bool overlap(const ir_node *left, const ir_node *right) {
    return left->range.begin < right->range.end && right->range.begin < left->range.end;
}

static bool shares_text_with_sibling(const ir_node *statement) {
    const ir_node *parent = statement->parent;
    if (!parent)
        return false;
    for (unsigned i = 0; i < parent->child_count; i++) {
        const ir_node *sibling = parent->children[i];
        if (sibling != statement && overlap(sibling, statement))
            return true;
    }
    return false;
}

const ir_node *syntax_editable_statement(const ir_node *statement, const ir_node *outer) {
    if (statement->range.begin == statement->range.end)
        return NULL;
    const ir_node *outermost = statement;
    for (const ir_node *node = statement; node; node = node->parent) {
        if (node->range.begin == statement->range.begin && syntax_is_statement(node))
            outermost = node;
        if (node == outer)
            break;
    }
    return shares_text_with_sibling(outermost) ? NULL : outermost;
}
