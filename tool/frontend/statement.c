/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts statements, and declarations inside functions. */
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"

static ir_node *new_statement(converter *c, CXCursor cursor, ir_kind kind, unsigned child_count) {
    ir_node *node = ir_new(c->arena, kind, NULL, child_count);
    place_node(c, node, cursor);
    return node;
}

static ir_node *empty_statement(converter *c) {
    return ir_new(c->arena, IR_EMPTY, NULL, 0);
}

static ir_node *opaque_statement(converter *c, CXCursor cursor, const char *what) {
    return convert_opaque(c, cursor, NULL, what);
}

static unsigned count_parts(const ir_node *node) {
    return node->kind == IR_BINARY && node->op == IR_OP_COMMA
               ? count_parts(node->children[0]) + count_parts(node->children[1])
               : 1;
}

static void add_parts(converter *c, ir_node *node, ir_node *block) {
    if (node->kind == IR_BINARY && node->op == IR_OP_COMMA) {
        add_parts(c, node->children[0], block);
        add_parts(c, node->children[1], block);
        return;
    }
    ir_node *part = ir_new(c->arena, IR_EXPRESSION, NULL, 1);
    part->children[0] = node;
    part->range = block->range;
    part->flags = IR_FROM_MACRO;
    block->children[block->child_count++] = part;
}

/* Turns the statement `a += e, b -= e;` into a block { a += e; b -= e; }. All parts of the block
 * have the range of the statement, which can only be replaced as a whole. */
static ir_node *sequence(converter *c, ir_node *statement) {
    ir_node *all = statement->children[0];
    ir_node *block = ir_new(c->arena, IR_BLOCK, NULL, count_parts(all));
    block->range = statement->range;
    block->flags = statement->flags | IR_SEQUENCE;
    block->child_count = 0;
    add_parts(c, all, block);
    return block;
}

static ir_node *expression_statement(converter *c, CXCursor cursor) {
    ir_node *node = new_statement(c, cursor, IR_EXPRESSION, 1);
    node->children[0] = convert_expression(c, cursor);
    return count_parts(node->children[0]) > 1 ? sequence(c, node) : node;
}

static ir_node *convert_block(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    ir_node *node = new_statement(c, cursor, IR_BLOCK, parts.count);
    for (unsigned i = 0; i < parts.count; i++)
        node->children[i] = convert_statement(c, parts.items[i]);
    return node;
}

/* ---- declarations -------------------------------------------------------------------------- */

typedef struct declaration_list {
    converter *converter;
    cursor_list variables;
    bool computes_length; /* a typedef has a length that is evaluated when the declaration is
                           * executed */
} declaration_list;

static enum CXChildVisitResult collect_variable(CXCursor child, CXCursor parent,
                                                CXClientData data) {
    (void)parent;
    declaration_list *list = data;
    const enum CXCursorKind kind = clang_getCursorKind(child);
    if (kind == CXCursor_VarDecl)
        VECTOR_PUSH(list->converter->scratch, &list->variables, child);
    else
        note_name(list->converter, child);
    list->computes_length |= kind == CXCursor_TypedefDecl &&
                             has_variable_length(convert_type(
                                 list->converter, clang_getTypedefDeclUnderlyingType(child)));
    return CXChildVisit_Continue;
}

/* Creates an opaque node for effects of a declarator that are not its initialisation: the lengths
 * in its type are evaluated, or a function is called at the end of its scope. The written
 * initialiser, if any, is a child of the node. */
static ir_node *opaque_initialiser(converter *c, CXCursor declaration, const char *what) {
    const ir_type *type = convert_type(c, clang_getCursorType(declaration));
    return convert_opaque(c, declaration, type, what);
}

static ir_node *initialiser_of(converter *c, CXCursor declaration) {
    const ir_type *type = convert_type(c, clang_getCursorType(declaration));
    if (has_variable_length(type) && children_of(c, declaration).count > 0 &&
        clang_Cursor_hasVarDeclExternalStorage(declaration) != 1)
        return opaque_initialiser(c, declaration, "variable length");
    if (has_cleanup(declaration))
        return opaque_initialiser(c, declaration, "cleanup attribute");
    CXCursor initialiser = clang_Cursor_getVarDeclInitializer(declaration);
    if (clang_Cursor_isNull(initialiser) || !clang_isExpression(clang_getCursorKind(initialiser)))
        return NULL;
    return convert_expression(c, initialiser);
}

static ir_node *convert_declarator(converter *c, CXCursor declaration) {
    ir_node *node = ir_new(c->arena, IR_DECLARATOR, NULL, 0);
    bool is_from_macro;
    CXSourceRange extent = clang_getCursorExtent(declaration);
    CXSourceLocation name = clang_getCursorLocation(declaration);
    node->range = range_of(c, clang_getRange(name, clang_getRangeEnd(extent)), &is_from_macro);
    if (is_from_macro)
        node->flags |= IR_FROM_MACRO;
    node->variable = convert_variable(c, declaration);
    node->variable->address_taken |= has_cleanup(declaration);
    ir_node *initialiser = initialiser_of(c, declaration);
    if (initialiser == NULL)
        return node;
    node->child_count = 1;
    node->children = ARENA_ARRAY(c->arena, ir_node *, 1);
    node->children[0] = initialiser;
    if (initialiser->kind == IR_OPAQUE && initialiser->range.begin < node->range.begin)
        initialiser->range = node->range; /* clang's extent also includes the type before the
                                           * name */
    return node;
}

/* Collects the expressions in a declaration and its types. */
static enum CXChildVisitResult collect_expression(CXCursor child, CXCursor parent,
                                                  CXClientData data) {
    (void)parent;
    declaration_list *list = data;
    if (!clang_isExpression(clang_getCursorKind(child)))
        return CXChildVisit_Recurse;
    VECTOR_PUSH(list->converter->scratch, &list->variables, child);
    return CXChildVisit_Continue;
}

ir_node *convert_lengths(converter *c, CXCursor cursor, const char *what) {
    declaration_list list = {.converter = c};
    clang_visitChildren(cursor, collect_expression, &list);
    ir_node *node = new_statement(c, cursor, IR_OPAQUE, list.variables.count);
    node->text = what;
    for (unsigned i = 0; i < list.variables.count; i++)
        node->children[i] = convert_expression(c, list.variables.items[i]);
    return node;
}

/* Converts a declaration. Types and prototypes declared in a function produce no declarators. */
static ir_node *convert_declaration(converter *c, CXCursor cursor) {
    declaration_list list = {.converter = c};
    clang_visitChildren(cursor, collect_variable, &list);
    if (list.computes_length)
        return convert_lengths(c, cursor, "typedef of a variable length");
    ir_node *node = new_statement(c, cursor, IR_DECLARATION, list.variables.count);
    for (unsigned i = 0; i < list.variables.count; i++)
        node->children[i] = convert_declarator(c, list.variables.items[i]);
    return node;
}

/* ---- for ----------------------------------------------------------------------------------- */

/* The semicolons in a for's header, as offsets in a text that begins with the for. */
typedef struct for_header {
    size_t semicolons[2];
    unsigned count; /* number of semicolons found; may exceed 2 */
    bool is_closed;
} for_header;

static size_t skip_quoted(const char *text, size_t i, size_t length) {
    char close = text[i++];
    while (i < length && text[i] != close)
        i += text[i] == '\\' ? 2 : 1;
    return i + 1;
}

static size_t skip_comment(const char *text, size_t i, size_t length) {
    bool is_line = text[i + 1] == '/';
    for (i += 2; i < length; i++) {
        unsigned splice = splice_length(text + i, text + length);
        if (is_line && splice > 0)
            i += splice - 1;
        else if (is_line && text[i] == '\n')
            return i;
        else if (!is_line && text[i] == '/' && text[i - 1] == '*')
            return i + 1;
    }
    return length;
}

static for_header scan_header(const char *text, size_t length) {
    for_header header = {0};
    unsigned depth = 0;
    for (size_t i = 0; i < length && !header.is_closed;) {
        char at = text[i];
        if (at == '"' || at == '\'') {
            i = skip_quoted(text, i, length);
            continue;
        }
        if (at == '/' && i + 1 < length && (text[i + 1] == '/' || text[i + 1] == '*')) {
            i = skip_comment(text, i, length);
            continue;
        }
        if (at == '?' && i + 2 < length &&
            text[i + 1] == '?') { /* a trigraph; none of them means a parenthesis */
            i += 3;
            continue;
        }
        depth += at == '(' || at == '{';
        if (at == ')' || at == '}')
            header.is_closed = --depth == 0;
        if (at == ';' && depth == 1 && header.count++ < 2)
            header.semicolons[header.count - 1] = i;
        i++;
    }
    return header;
}

/* Stores in *place the offset of `part` from the beginning of the for. Returns false if the part is
 * in another file or before the for. */
static bool place_in_for(CXCursor loop, CXCursor part, size_t *place) {
    CXFile loop_file, part_file;
    unsigned loop_offset, part_offset;
    clang_getExpansionLocation(clang_getRangeStart(clang_getCursorExtent(loop)), &loop_file, NULL,
                               NULL, &loop_offset);
    clang_getExpansionLocation(clang_getRangeStart(clang_getCursorExtent(part)), &part_file, NULL,
                               NULL, &part_offset);
    *place = part_offset - loop_offset;
    return clang_File_isEqual(loop_file, part_file) && part_offset >= loop_offset;
}

/* Assigns each part to one of the header's three clauses, according to the semicolons before it,
 * because clang omits empty clauses. Returns false if the clauses cannot be determined. */
static bool assign_clauses(converter *c, CXCursor cursor, const cursor_list *parts,
                           CXCursor clauses[3], bool present[3]) {
    unsigned given = parts->count - 1;
    if (given == 3 || given == 0) {
        for (unsigned i = 0; i < given; i++) {
            clauses[i] = parts->items[i];
            present[i] = true;
        }
        return true;
    }
    CXSourceLocation start = clang_getRangeStart(clang_getCursorExtent(cursor));
    file_text text = text_at(c, start);
    if (text.length < 3 || strncmp(text.text, "for", 3) != 0)
        return false;
    for_header header = scan_header(text.text, text.length);
    if (!header.is_closed || header.count != 2)
        return false;
    for (unsigned i = 0; i < given; i++) {
        size_t place;
        if (!place_in_for(cursor, parts->items[i], &place))
            return false;
        unsigned clause = place > header.semicolons[1] ? 2 : place > header.semicolons[0] ? 1 : 0;
        if (present[clause])
            return false;
        clauses[clause] = parts->items[i];
        present[clause] = true;
    }
    return true;
}

static bool starts_outside_macro(CXCursor cursor) {
    CXFile file, spelled;
    unsigned offset, spelled_offset;
    CXSourceLocation start = clang_getRangeStart(clang_getCursorExtent(cursor));
    clang_getExpansionLocation(start, &file, NULL, NULL, &offset);
    clang_getSpellingLocation(start, &spelled, NULL, NULL, &spelled_offset);
    return offset == spelled_offset && clang_File_isEqual(file, spelled);
}

static ir_node *convert_for(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    CXCursor clauses[3];
    bool present[3] = {false, false, false};
    bool is_readable = parts.count == 1 || parts.count == 4 || starts_outside_macro(cursor);
    if (parts.count == 0 || parts.count > 4 || !is_readable ||
        !assign_clauses(c, cursor, &parts, clauses, present))
        return opaque_statement(c, cursor, "for with a header made by a macro");
    ir_node *node = new_statement(c, cursor, IR_FOR, 4);
    for (unsigned i = 0; i < 3; i++)
        node->children[i] = present[i] ? convert_any(c, clauses[i]) : empty_statement(c);
    node->children[3] = convert_statement(c, parts.items[parts.count - 1]);
    return node;
}

/* ---- other statements ---------------------------------------------------------------------- */

/* Converts a statement whose first part is a condition or value and whose other parts are
 * statements. */
static ir_node *convert_controlled(converter *c, CXCursor cursor, ir_kind kind, unsigned least,
                                   unsigned most) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count < least || parts.count > most)
        return opaque_statement(c, cursor, "statement");
    ir_node *node = new_statement(c, cursor, kind, parts.count);
    node->children[0] = convert_expression(c, parts.items[0]);
    for (unsigned i = 1; i < parts.count; i++)
        node->children[i] = convert_statement(c, parts.items[i]);
    return node;
}

static ir_node *convert_do(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 2)
        return opaque_statement(c, cursor, "do");
    ir_node *node = new_statement(c, cursor, IR_DO, 2);
    node->children[0] = convert_statement(c, parts.items[0]);
    node->children[1] = convert_expression(c, parts.items[1]);
    return node;
}

/* The range of `case 1 ... 3:` as an opaque node with both ends as its children. */
static ir_node *case_range(converter *c, const cursor_list *parts) {
    ir_node *first = convert_expression(c, parts->items[0]);
    ir_node *range = ir_new(c->arena, IR_OPAQUE, first->type, 2);
    range->text = "range of a case";
    range->children[0] = first;
    range->children[1] = convert_expression(c, parts->items[1]);
    range->flags = (first->flags | range->children[1]->flags) & IR_FROM_MACRO;
    range->range = (ir_range){.begin = first->range.begin, .end = range->children[1]->range.end};
    return range;
}

static ir_node *convert_case(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 3)
        return convert_controlled(c, cursor, IR_CASE, 2, 2);
    ir_node *node = new_statement(c, cursor, IR_CASE, 2);
    node->children[0] = case_range(c, &parts);
    node->children[1] = convert_statement(c, parts.items[2]);
    return node;
}

/* Converts a label or `default`, with its statement. */
static ir_node *convert_labelled(converter *c, CXCursor cursor, ir_kind kind) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 1)
        return opaque_statement(c, cursor, "label");
    ir_node *node = new_statement(c, cursor, kind, 1);
    if (kind == IR_LABEL)
        node->text = take_string(c, clang_getCursorSpelling(cursor));
    node->children[0] = convert_statement(c, parts.items[0]);
    return node;
}

static enum CXChildVisitResult find_label(CXCursor child, CXCursor parent, CXClientData data) {
    (void)parent;
    if (clang_getCursorKind(child) != CXCursor_LabelRef)
        return CXChildVisit_Continue;
    *(CXCursor *)data = child;
    return CXChildVisit_Break;
}

static ir_node *convert_goto(converter *c, CXCursor cursor) {
    CXCursor label = clang_getNullCursor();
    clang_visitChildren(cursor, find_label, &label);
    if (clang_Cursor_isNull(label))
        return opaque_statement(c, cursor, "goto");
    ir_node *node = new_statement(c, cursor, IR_GOTO, 0);
    node->text = take_string(c, clang_getCursorSpelling(label));
    return node;
}

/* Converts a return, or a goto to a computed address. */
static ir_node *convert_jump(converter *c, CXCursor cursor, ir_kind kind) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count > 1)
        return opaque_statement(c, cursor, "jump");
    ir_node *node = new_statement(c, cursor, kind, parts.count);
    if (parts.count == 1)
        node->children[0] = convert_expression(c, parts.items[0]);
    return node;
}

/* Does the statement's text begin with a pragma? clang represents a pragma such as `GCC unroll` as
 * an attribute of the loop after it. */
static bool begins_with_pragma(converter *c, CXCursor cursor) {
    bool is_from_macro;
    const ir_range range = range_of(c, extent_of(c, cursor), &is_from_macro);
    return range.begin < range.end && strchr("#%?", c->unit->source->text[range.begin]) != NULL;
}

/* Converts a statement with attributes, which are dropped. */
static ir_node *convert_unexposed_statement(converter *c, CXCursor cursor) {
    cursor_list parts = children_of(c, cursor);
    if (parts.count != 1)
        return opaque_statement(c, cursor, "statement");
    ir_node *node = convert_statement(c, parts.items[0]);
    if (!begins_with_pragma(c, cursor))
        place_node(c, node, cursor);
    return node;
}

/* ---- all ----------------------------------------------------------------------------------- */

static ir_node *convert_by_kind(converter *c, CXCursor cursor) {
    switch (clang_getCursorKind(cursor)) {
    case CXCursor_CompoundStmt:
        return convert_block(c, cursor);
    case CXCursor_DeclStmt:
        return convert_declaration(c, cursor);
    case CXCursor_IfStmt:
        return convert_controlled(c, cursor, IR_IF, 2, 3);
    case CXCursor_ForStmt:
        return convert_for(c, cursor);
    case CXCursor_WhileStmt:
        return convert_controlled(c, cursor, IR_WHILE, 2, 2);
    case CXCursor_DoStmt:
        return convert_do(c, cursor);
    case CXCursor_SwitchStmt:
        return convert_controlled(c, cursor, IR_SWITCH, 2, 2);
    case CXCursor_CaseStmt:
        return convert_case(c, cursor);
    case CXCursor_DefaultStmt:
        return convert_labelled(c, cursor, IR_DEFAULT);
    case CXCursor_LabelStmt:
        return convert_labelled(c, cursor, IR_LABEL);
    case CXCursor_GotoStmt:
        return convert_goto(c, cursor);
    case CXCursor_IndirectGotoStmt:
        return convert_jump(c, cursor, IR_GOTO);
    case CXCursor_ReturnStmt:
        return convert_jump(c, cursor, IR_RETURN);
    case CXCursor_BreakStmt:
        return new_statement(c, cursor, IR_BREAK, 0);
    case CXCursor_ContinueStmt:
        return new_statement(c, cursor, IR_CONTINUE, 0);
    case CXCursor_NullStmt:
        return new_statement(c, cursor, IR_EMPTY, 0);
    case CXCursor_GCCAsmStmt:
    case CXCursor_MSAsmStmt:
        return opaque_statement(c, cursor, "inline assembly");
    case CXCursor_UnexposedStmt:
        return convert_unexposed_statement(c, cursor);
    default:
        return opaque_statement(c, cursor, "statement");
    }
}

ir_node *convert_statement(converter *c, CXCursor cursor) {
    ir_node *node;
    if (!enter_level(c, cursor, &node))
        return node;
    bool is_expression = clang_isExpression(clang_getCursorKind(cursor)) != 0;
    node = is_expression ? expression_statement(c, cursor) : convert_by_kind(c, cursor);
    if (ir_is_loop(node))
        note_header_loop(c, node, cursor);
    c->depth--;
    return node;
}

ir_node *convert_any(converter *c, CXCursor cursor) {
    return clang_isExpression(clang_getCursorKind(cursor)) ? convert_expression(c, cursor)
                                                           : convert_statement(c, cursor);
}
