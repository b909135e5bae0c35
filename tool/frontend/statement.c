/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statements. */
#include <string.h>

#include "frontend/translation.h"

static ir_node *empty_node(translation *t) {
    return ir_new(t->arena, IR_EMPTY, NULL, 0);
}

static ir_node *simple(translation *t, CXCursor cursor, ir_kind kind) {
    return node_new(t, cursor, kind, 0);
}

/* An expression as a statement. */
static ir_node *expression_statement(translation *t, CXCursor cursor) {
    ir_node *expression = translate_expression(t, cursor);
    ir_node *node = ir_new(t->arena, IR_EXPRESSION, NULL, 1);
    node->children[0] = expression;
    node->range = place_range(t, cursor);
    if (!place_is_plain(t, cursor))
        node->flags |= IR_FROM_MACRO;
    return node;
}

static ir_node *declarator(translation *t, CXCursor cursor) {
    const CXCursor initializer = clang_Cursor_getVarDeclInitializer(cursor);
    const bool has_value = !clang_Cursor_isNull(initializer);
    ir_node *node = node_new(t, cursor, IR_DECLARATOR, has_value ? 1 : 0);
    node->variable = translate_variable(t, cursor);
    if (has_value)
        node->children[0] = translate_expression(t, initializer);
    return node;
}

static ir_node *declaration(translation *t, CXCursor cursor) {
    const cursor_list children = children_of(t, cursor);
    node_list declarators = {0};
    for (unsigned i = 0; i < children.count; i++)
        if (clang_getCursorKind(children.items[i]) == CXCursor_VarDecl)
            VECTOR_PUSH(t->arena, &declarators, declarator(t, children.items[i]));
    ir_node *node = node_new(t, cursor, IR_DECLARATION, declarators.count);
    if (declarators.count)
        memcpy(node->children, declarators.items, declarators.count * sizeof *declarators.items);
    return node;
}

/* ---- for: libclang keeps only the clauses that are there ----------------------------------- */

static const char *skip_quoted(const char *p, const char *end) {
    const char quote = *p++;
    while (p < end && *p != quote && *p != '\n')
        p += *p == '\\' && p + 1 < end ? 2 : 1;
    return p < end ? p + 1 : end;
}

static const char *skip_comment(const char *p, const char *end) {
    if (p[1] == '/') {
        while (p < end && *p != '\n')
            p++;
        return p;
    }
    for (p += 2; p + 1 < end; p++)
        if (p[0] == '*' && p[1] == '/')
            return p + 2;
    return end;
}

/* Offsets of the two semicolons of a for's header; false where they cannot be found. */
static bool find_semicolons(const source *s, ir_range range, uint32_t semicolon[2]) {
    const char *p = s->text + range.begin, *end = s->text + range.end;
    int depth = 0;
    unsigned found = 0;
    while (p < end) {
        if (*p == '"' || *p == '\'') {
            p = skip_quoted(p, end);
            continue;
        }
        if (*p == '/' && p + 1 < end && (p[1] == '/' || p[1] == '*')) {
            p = skip_comment(p, end);
            continue;
        }
        depth += *p == '(' || *p == '{' || *p == '[';
        depth -= *p == ')' || *p == '}' || *p == ']';
        if (*p == ';' && depth == 1) {
            semicolon[found++] = (uint32_t)(p - s->text);
            if (found == 2)
                return true;
        }
        if (*p == ')' && depth == 0)
            return false;
        p++;
    }
    return false;
}

static ir_node *header_part(translation *t, CXCursor cursor) {
    return clang_isExpression(clang_getCursorKind(cursor)) ? translate_expression(t, cursor)
                                                           : translate_statement(t, cursor);
}

static ir_node *for_loop(translation *t, CXCursor cursor) {
    const cursor_list children = children_of(t, cursor);
    ir_node *node = node_new(t, cursor, IR_FOR, 4);
    uint32_t semicolon[2];
    if (children.count == 0 || children.count > 4)
        return node_opaque(t, cursor, "for");
    for (unsigned i = 0; i < 3; i++)
        node->children[i] = empty_node(t);
    if (children.count < 4 && children.count > 1 &&
        ((node->flags & IR_FROM_MACRO) ||
         !find_semicolons(t->unit->source, node->range, semicolon)))
        return node_opaque(t, cursor, "for");
    for (unsigned i = 0; i + 1 < children.count; i++) {
        unsigned clause = i;
        if (children.count < 4) {
            const uint32_t at = place_range(t, children.items[i]).begin;
            clause = at < semicolon[0] ? 0 : at < semicolon[1] ? 1 : 2;
        }
        node->children[clause] = header_part(t, children.items[i]);
    }
    node->children[3] = translate_statement(t, children.items[children.count - 1]);
    return node;
}

/* ---- the others ---------------------------------------------------------------------------- */

/* A statement of which the first `expressions` children are expressions, the rest statements. */
static ir_node *control(translation *t, CXCursor cursor, ir_kind kind, unsigned least,
                        unsigned most) {
    const cursor_list children = children_of(t, cursor);
    if (children.count < least || children.count > most)
        return node_opaque(t, cursor, "statement");
    ir_node *node = node_new(t, cursor, kind, children.count);
    for (unsigned i = 0; i < children.count; i++) {
        const bool expression =
            kind == IR_DO ? i == 1
                          : i == 0 && kind != IR_DEFAULT && kind != IR_LABEL && kind != IR_BLOCK;
        node->children[i] = expression ? translate_expression(t, children.items[i])
                                       : translate_statement(t, children.items[i]);
    }
    return node;
}

static ir_node *label(translation *t, CXCursor cursor) {
    ir_node *node = control(t, cursor, IR_LABEL, 1, 1);
    if (node->kind == IR_LABEL)
        node->text = take_string(t, clang_getCursorSpelling(cursor));
    return node;
}

static ir_node *jump(translation *t, CXCursor cursor) {
    ir_node *node = simple(t, cursor, IR_GOTO);
    const cursor_list children = children_of(t, cursor);
    if (children.count)
        node->text = take_string(t, clang_getCursorSpelling(children.items[0]));
    return node;
}

static ir_node *by_kind(translation *t, CXCursor cursor) {
    const enum CXCursorKind kind = clang_getCursorKind(cursor);
    if (clang_isExpression(kind))
        return expression_statement(t, cursor);
    switch (kind) {
    case CXCursor_CompoundStmt:
        return control(t, cursor, IR_BLOCK, 0, UINT32_MAX);
    case CXCursor_DeclStmt:
        return declaration(t, cursor);
    case CXCursor_IfStmt:
        return control(t, cursor, IR_IF, 2, 3);
    case CXCursor_ForStmt:
        return for_loop(t, cursor);
    case CXCursor_WhileStmt:
        return control(t, cursor, IR_WHILE, 2, 2);
    case CXCursor_DoStmt:
        return control(t, cursor, IR_DO, 2, 2);
    case CXCursor_SwitchStmt:
        return control(t, cursor, IR_SWITCH, 2, 2);
    case CXCursor_CaseStmt: /* three children: a range, as GNU C has it */
        return control(t, cursor, IR_CASE, 2, 2);
    case CXCursor_DefaultStmt:
        return control(t, cursor, IR_DEFAULT, 1, 1);
    case CXCursor_LabelStmt:
        return label(t, cursor);
    case CXCursor_GotoStmt:
        return jump(t, cursor);
    case CXCursor_IndirectGotoStmt:
        return simple(t, cursor, IR_GOTO);
    case CXCursor_ReturnStmt: {
        const cursor_list children = children_of(t, cursor);
        return node_with_children(t, cursor, IR_RETURN, &children, 0);
    }
    case CXCursor_BreakStmt:
        return simple(t, cursor, IR_BREAK);
    case CXCursor_ContinueStmt:
        return simple(t, cursor, IR_CONTINUE);
    case CXCursor_NullStmt:
        return simple(t, cursor, IR_EMPTY);
    case CXCursor_AsmStmt:
    case CXCursor_MSAsmStmt:
        return node_opaque(t, cursor, "assembly");
    default:
        return node_opaque(t, cursor, "statement");
    }
}

ir_node *translate_statement(translation *t, CXCursor cursor) {
    if (t->depth >= DEEPEST_NESTING) {
        t->too_deep = true;
        ir_node *node = ir_new(t->arena, IR_OPAQUE, NULL, 0);
        node->text = "nested too deeply";
        return node;
    }
    t->depth++;
    ir_node *node = by_kind(t, cursor);
    t->depth--;
    return node;
}
