/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Checks the rules that ir.h states for a unit's trees. */
#include "ir/ir_text.h"
#include "ir/ir_words.h"

typedef struct checker {
    arena *arena;
    const ir_unit *unit;
    const ir_function *function;
    unsigned next_id;
    bool nests_ranges;   /* whether each node must lie inside its parent's range */
    const char *problem; /* the first problem found; NULL if none */
} checker;

static bool complain(checker *c, const ir_node *node, const char *what) {
    if (c->problem == NULL) {
        char word[16];
        c->problem = arena_format(c->arena, "function %s: node %u (%s): %s", c->function->name,
                                  node->id, ir_node_word(node, word) ? word : "?", what);
    }
    return false;
}

/* ---- one node ------------------------------------------------------------------------------ */

static bool operator_fits(const ir_node *node) {
    ir_operator op = node->op;
    switch (node->kind) {
    case IR_UNARY:
        return op >= IR_OP_PLUS && op <= IR_OP_IMAG;
    case IR_BINARY:
        return op >= IR_OP_ADD && op <= IR_OP_COMMA;
    case IR_ASSIGN:
        return op <= IR_OP_BIT_XOR;
    default:
        return op == IR_OP_NONE;
    }
}

static bool needs_text(ir_kind kind) {
    return kind == IR_NUMBER || kind == IR_STRING || kind == IR_SIZEOF || kind == IR_OPAQUE ||
           kind == IR_LABEL;
}

static bool check_variable(checker *c, const ir_node *node) {
    const ir_variable *v = node->variable;
    if (v == NULL)
        return complain(c, node, "has no variable");
    if (v->id >= c->unit->variable_count || c->unit->variables[v->id] != v)
        return complain(c, node, "its variable is not the unit's");
    if (v->function != NULL && v->function != c->function)
        return complain(c, node, "its variable belongs to another function");
    return true;
}

static bool check_function(checker *c, const ir_node *node) {
    const ir_function *f = node->function;
    if (f == NULL)
        return complain(c, node, "has no function");
    if (f->id >= c->unit->function_count || c->unit->functions[f->id] != f)
        return complain(c, node, "its function is not the unit's");
    return true;
}

static bool check_member(checker *c, const ir_node *node) {
    const ir_type *type = node->children[0]->type;
    if (type != NULL && (node->flags & IR_ARROW))
        type = type->target;
    if (node->field == NULL || type == NULL || type->record == NULL)
        return complain(c, node, "has no field, or its object is no record");
    const ir_field *fields = type->record->fields;
    if (node->field < fields || node->field >= fields + type->record->field_count)
        return complain(c, node, "its field is not its object's");
    return true;
}

static bool check_reference(checker *c, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
    case IR_DECLARATOR:
        return check_variable(c, node);
    case IR_FUNCTION:
        return check_function(c, node);
    case IR_MEMBER:
        return check_member(c, node);
    default:
        return true;
    }
}

static bool check_range(checker *c, const ir_node *node) {
    if (node->range.begin > node->range.end || node->range.end > c->unit->source->length)
        return complain(c, node, "its range is not inside the file");
    const ir_node *parent = node->parent;
    if (!c->nests_ranges || parent == NULL || node->range.begin == node->range.end ||
        parent->range.begin == parent->range.end)
        return true;
    if (node->range.begin < parent->range.begin || node->range.end > parent->range.end)
        return complain(c, node, "its range is not inside its parent's");
    return true;
}

static bool check_child_kind(checker *c, const ir_node *node, unsigned index) {
    const ir_node *child = node->children[index];
    if (child == NULL)
        return complain(c, node, "a child is missing");
    bool is_expression = ir_is_expression(child);
    if (ir_is_statement_place(node->kind, index))
        return !is_expression || complain(c, child, "an expression where a statement belongs");
    if (node->kind == IR_FOR || child->kind == IR_OPAQUE || node->kind == IR_OPAQUE)
        return true;
    if (node->kind == IR_DECLARATION)
        return child->kind == IR_DECLARATOR || complain(c, child, "no declarator");
    return is_expression || complain(c, child, "a statement where an expression belongs");
}

/* ---- trees --------------------------------------------------------------------------------- */

static bool check_node(checker *c, const ir_node *node) {
    const ir_kind_word *words = ir_kind_words(node->kind);
    if (node->id != c->next_id++)
        return complain(c, node, "its id is not its place in preorder");
    if (node->child_count < words->min_children || node->child_count > words->max_children)
        return complain(c, node, "has too few or too many children");
    if (!operator_fits(node))
        return complain(c, node, "its operator does not fit its kind");
    if (node->type == NULL && node->kind != IR_OPAQUE && ir_is_expression(node))
        return complain(c, node, "an expression without a type");
    if (needs_text(node->kind) && node->text == NULL)
        return complain(c, node, "has no text");
    if (!check_range(c, node))
        return false;
    for (unsigned i = 0; i < node->child_count; i++) {
        if (!check_child_kind(c, node, i))
            return false;
        if (node->children[i]->parent != node)
            return complain(c, node->children[i], "its parent is not the node it stands in");
        if (!check_node(c, node->children[i]))
            return false;
    }
    return check_reference(c, node);
}

static const char *check_body(arena *a, const ir_unit *unit, const ir_function *function,
                              bool nests_ranges) {
    checker c = {.arena = a, .unit = unit, .function = function, .nests_ranges = nests_ranges};
    if (function->body->kind != IR_BLOCK || function->body->parent != NULL)
        return arena_format(a, "function %s: its body is no block, or has a parent",
                            function->name);
    if (check_node(&c, function->body) && c.next_id != function->node_count)
        return arena_format(a, "function %s: node_count is %u, but it has %u nodes", function->name,
                            function->node_count, c.next_id);
    return c.problem;
}

static const char *check_one_function(arena *a, const ir_unit *unit, unsigned index,
                                      bool nests_ranges) {
    const ir_function *f = unit->functions[index];
    if (f->id != index)
        return arena_format(a, "function %s: its id is not its place", f->name);
    if (f->type == NULL || f->type->kind != IR_FUNCTION_TYPE || f->type->target == NULL)
        return arena_format(a, "function %s: its type is no function type", f->name);
    for (unsigned i = 0; i < f->parameter_count; i++)
        if (f->parameters[i]->storage != IR_PARAMETER || f->parameters[i]->function != f)
            return arena_format(a, "function %s: parameter %u is none of its own", f->name, i);
    for (unsigned i = 0; i < f->parameter_count; i++)
        if (f->parameters[i]->type->kind == IR_ARRAY ||
            f->parameters[i]->type->kind == IR_FUNCTION_TYPE)
            return arena_format(a,
                                "function %s: parameter %u is an array or a function, which C "
                                "makes a pointer",
                                f->name, i);
    return f->body != NULL ? check_body(a, unit, f, nests_ranges) : NULL;
}

static const char *check_one_variable(arena *a, const ir_unit *unit, unsigned index) {
    const ir_variable *v = unit->variables[index];
    if (v->id != index)
        return arena_format(a, "variable %s: its id is not its place", v->name);
    if (v->type == NULL)
        return arena_format(a, "variable %s: has no type", v->name);
    bool is_local = v->storage == IR_LOCAL || v->storage == IR_PARAMETER;
    if (is_local && v->function == NULL)
        return arena_format(a, "variable %s: local, but of no function", v->name);
    if (v->range.begin > v->range.end || v->range.end > unit->source->length)
        return arena_format(a, "variable %s: its range is not inside the file", v->name);
    return NULL;
}

static const char *check_directives(arena *a, const ir_unit *unit) {
    uint32_t end = 0;
    for (unsigned i = 0; i < unit->directive_count; i++) {
        ir_range range = unit->directives[i].range;
        if (range.begin < end || range.begin > range.end || range.end > unit->source->length)
            return arena_format(a,
                                "directive %u: its range is not behind the one before, or not "
                                "inside the file",
                                i);
        end = range.end;
    }
    return NULL;
}

static const char *check(arena *a, const ir_unit *unit, bool nests_ranges) {
    const char *problem = check_directives(a, unit);
    for (unsigned i = 0; problem == NULL && i < unit->variable_count; i++)
        problem = check_one_variable(a, unit, i);
    for (unsigned i = 0; problem == NULL && i < unit->function_count; i++)
        problem = check_one_function(a, unit, i, nests_ranges);
    return problem;
}

const char *ir_check(arena *a, const ir_unit *unit) {
    return check(a, unit, true);
}

const char *ir_check_parsed(arena *a, const ir_unit *unit) {
    return check(a, unit, false);
}
