/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A condition is constant if it consists of numbers, of calls of functions that return a single
 * constant, and of local variables with a known value.
 * To find a variable's value, the search goes backwards from the `if` through the enclosing blocks,
 * up to the innermost loop or switch. The first statement found that may change the variable must
 * assign it, and no label may be passed.
 * Only values from -128 to 127 are considered: every signed type can represent them, and every
 * unsigned type those that are not negative. */
#include "analysis/base/dead_branches.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"

typedef struct result_of {
    enum { UNSEEN, BEGUN, CONSTANT, VARIES } state;
    int64_t value;
    bool is_external; /* the result depends on a function that another file defines */
} result_of;

typedef struct search {
    ir_unit *unit;
    result_of *results; /* indexed by function id */
    bool is_external;   /* the value being computed depends on a function that another file
                         * defines */
} search;

static bool constant_of(search *s, const ir_node *node, int64_t *value);

static bool holds(const ir_type *type, int64_t value) {
    if (!type || type->is_volatile || type->is_atomic)
        return false;
    if (type->kind == IR_BOOLEAN)
        return value == 0 || value == 1;
    return type->kind == IR_INTEGER && value <= 127 && value >= (type->is_signed ? -128 : 0);
}

/* ---- results of functions -------------------------------------------------------------------- */

/* Does every `return` below the node return the same value? Stores it in *found. If *found already
 * has a value, compares with that. */
static bool returns_one(search *s, const ir_node *node, const ir_type *type, result_of *found) {
    if (node->kind == IR_OPAQUE)
        return false;
    if (node->kind == IR_RETURN) {
        int64_t value;
        if (!node->child_count || !constant_of(s, node->children[0], &value) ||
            !holds(type, value) || (found->state == CONSTANT && found->value != value))
            return false;
        *found = (result_of){CONSTANT, value, false};
        return true;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (!returns_one(s, node->children[i], type, found))
            return false;
    return true;
}

static void take_out_below(search *s, ir_node *node);

static bool constant_result(search *s, const ir_function *function, int64_t *value) {
    assert(function->id < s->unit->function_count);
    result_of *known = &s->results[function->id];
    if (known->state == UNSEEN && function->body && !function->has_errors) {
        const bool was_external = s->is_external;
        result_of found = {VARIES, 0, false};
        known->state = BEGUN;
        take_out_below(s, function->body);
        s->is_external = function->linkage.import != NULL;
        if (function->linkage.is_weak || function->linkage.is_renamed ||
            function->has_other_attributes ||
            !returns_one(s, function->body, function->type->target, &found))
            found.state = VARIES;
        found.is_external = s->is_external;
        s->is_external = was_external;
        *known = found;
    }
    *value = known->value;
    s->is_external |= known->is_external;
    assert(known->state != CONSTANT || (known->value >= -128 && known->value <= 127));
    return known->state == CONSTANT;
}

/* ---- variables ------------------------------------------------------------------------------- */

static bool is_followed(const ir_variable *variable) {
    return variable->storage == IR_LOCAL && !variable->address_taken &&
           variable->type->kind == IR_INTEGER && !variable->type->is_volatile &&
           !variable->type->is_atomic;
}

/* May the node change the variable, or may a jump enter it? */
static bool may_interfere(const ir_node *node, const ir_variable *variable) {
    const ir_node *written = expression_written(node);
    if (node->kind == IR_LABEL || node->kind == IR_CASE || node->kind == IR_DEFAULT ||
        node->kind == IR_OPAQUE || (written && expression_is_variable(written, variable)) ||
        (node->kind == IR_DECLARATOR && node->variable == variable))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (may_interfere(node->children[i], variable))
            return true;
    return false;
}

/* The e of v = e, (v = e) < 0 or !(v = e); NULL if the node has none of these forms. */
static const ir_node *assigned_in(const ir_node *node, const ir_variable *variable) {
    while (node->kind == IR_UNARY && node->op == IR_OP_NOT)
        node = node->children[0];
    if (node->kind == IR_BINARY && node->op >= IR_OP_LESS && node->op <= IR_OP_NOT_EQUAL &&
        !may_interfere(node->children[1], variable))
        node = node->children[0];
    return node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
                   expression_is_variable(node->children[0], variable)
               ? node->children[1]
               : NULL;
}

static const ir_node *declared_value(const ir_node *declaration, const ir_variable *variable) {
    const ir_node *value = NULL;
    for (unsigned i = 0; i < declaration->child_count; i++) {
        const ir_node *declarator = declaration->children[i];
        if (declarator->variable == variable && declarator->child_count)
            value = declarator->children[0];
        else if (may_interfere(declarator, variable))
            return NULL;
    }
    return value;
}

/* The value that the statement always assigns to the variable; NULL if it assigns none, or not
 * always. */
static const ir_node *assigned_by(const ir_node *statement, const ir_variable *variable) {
    const ir_node *first = statement->child_count ? statement->children[0] : NULL;
    if (statement->kind == IR_EXPRESSION)
        return assigned_in(first, variable);
    if (statement->kind == IR_DECLARATION)
        return declared_value(statement, variable);
    if (statement->kind != IR_IF)
        return NULL;
    for (unsigned i = 1; i < statement->child_count; i++)
        if (may_interfere(statement->children[i], variable))
            return NULL;
    return assigned_in(first, variable);
}

/* The value that the block's statements before `child` give the variable. If NULL, *is_open says
 * whether these statements leave the variable unchanged (true) or make its value unknown
 * (false). */
static const ir_node *value_before(const ir_node *block, const ir_node *child,
                                   const ir_variable *variable, bool *is_open) {
    assert(child->parent == block);
    unsigned at = 0;
    while (block->children[at] != child)
        at++;
    while (at-- > 0) {
        const ir_node *value = assigned_by(block->children[at], variable);
        *is_open = !value && !may_interfere(block->children[at], variable);
        if (!*is_open)
            return value;
    }
    return NULL;
}

/* The value that the variable has where `use` is evaluated, in the condition of an `if` or in a
 * `return`. NULL if it is unknown. */
static const ir_node *reaching_value(const ir_node *use, const ir_variable *variable) {
    bool is_open = true;
    const ir_node *value = NULL, *inner = use;
    for (const ir_node *outer = use->parent; outer && is_open;
         inner = outer, outer = outer->parent) {
        if (outer->kind == IR_BLOCK) {
            value = value_before(outer, inner, variable, &is_open);
        } else if (outer->kind == IR_IF && inner != outer->children[0]) {
            value = assigned_in(outer->children[0], variable);
            is_open = !value && !may_interfere(outer->children[0], variable);
        } else {
            is_open = outer->kind == IR_IF || outer->kind == IR_RETURN ||
                      (ir_is_expression(outer) && !may_interfere(outer, variable));
        }
    }
    return value;
}

/* ---- expressions ----------------------------------------------------------------------------- */

static bool is_signed(const ir_node *node) {
    return node->type && (node->type->kind == IR_BOOLEAN || node->type->is_signed);
}

static bool compared(search *s, const ir_node *node, int64_t *value) {
    int64_t a, b;
    if (!constant_of(s, node->children[0], &a) || !constant_of(s, node->children[1], &b) ||
        ((a < 0 || b < 0) && !(is_signed(node->children[0]) && is_signed(node->children[1]))))
        return false;
    *value = node->op == IR_OP_LESS            ? a < b
             : node->op == IR_OP_GREATER       ? a > b
             : node->op == IR_OP_LESS_EQUAL    ? a <= b
             : node->op == IR_OP_GREATER_EQUAL ? a >= b
             : node->op == IR_OP_EQUAL         ? a == b
                                               : a != b;
    return true;
}

static bool combined(search *s, const ir_node *node, int64_t *value) {
    int64_t other;
    if (node->op >= IR_OP_LESS && node->op <= IR_OP_NOT_EQUAL)
        return compared(s, node, value);
    if (node->op == IR_OP_COMMA)
        return constant_of(s, node->children[1], value);
    if (node->op != IR_OP_AND && node->op != IR_OP_OR)
        return false;
    const bool decisive = node->op == IR_OP_OR;
    const bool is_known = constant_of(s, node->children[0], &other);
    if (is_known && (other != 0) == decisive) {
        *value = decisive;
        return true;
    }
    if (!constant_of(s, node->children[1], value) || (!is_known && (*value != 0) != decisive))
        return false;
    *value = *value != 0;
    return true;
}

static bool chosen(search *s, const ir_node *node, int64_t *value) {
    int64_t condition, other;
    if (constant_of(s, node->children[0], &condition))
        return constant_of(s, node->children[condition ? 1 : 2], value);
    return constant_of(s, node->children[1], value) && constant_of(s, node->children[2], &other) &&
           *value == other;
}

static bool constant_of(search *s, const ir_node *node, int64_t *value) {
    switch (node->kind) {
    case IR_NUMBER:
    case IR_SIZEOF:
        *value = node->value;
        return (node->flags & IR_HAS_VALUE) && holds(node->type, node->value);
    case IR_VARIABLE: {
        const ir_node *from =
            is_followed(node->variable) ? reaching_value(node, node->variable) : NULL;
        return from && constant_of(s, from, value) && holds(node->variable->type, *value);
    }
    case IR_CALL:
        return node->children[0]->kind == IR_FUNCTION &&
               constant_result(s, node->children[0]->function, value);
    case IR_CAST:
        return constant_of(s, node->children[0], value) && holds(node->type, *value);
    case IR_ASSIGN:
        return node->op == IR_OP_NONE && constant_of(s, node->children[1], value) &&
               holds(node->children[0]->type, *value);
    case IR_UNARY:
        if ((node->op != IR_OP_NOT && node->op != IR_OP_MINUS) ||
            !constant_of(s, node->children[0], value))
            return false;
        *value = node->op == IR_OP_NOT ? *value == 0 : -*value;
        return holds(node->type, *value);
    case IR_BINARY:
        return combined(s, node, value);
    case IR_CONDITIONAL:
        return chosen(s, node, value);
    default:
        return false;
    }
}

/* ---- branches -------------------------------------------------------------------------------- */

/* May the branch change file-scope variables, or pass on their addresses? If a function of another
 * file makes the condition constant, the branch is dead only while that function's definition is
 * linked. Functions with translated loops, and the functions that these call, check this at run
 * time (imports.c). Any other function may execute the branch after all, so the analysis must see
 * the branch's effects on file-scope variables. */
static bool concerns_others(const ir_node *node) {
    const ir_node *written = expression_written(node);
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS)
        written = node->children[0];
    const ir_variable *variable = node->kind == IR_VARIABLE ? node->variable
                                  : written                 ? ir_root_variable(written)
                                                            : NULL;
    if (variable && !variable_is_automatic(variable) &&
        (written || variable->type->kind == IR_ARRAY || variable->type->kind == IR_RECORD))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (concerns_others(node->children[i]))
            return true;
    return false;
}

static void take_out(search *s, ir_node *statement, unsigned number) {
    assert(statement->kind == IR_IF && number > 0 && number < statement->child_count);
    ir_node *branch = statement->children[number];
    if (branch->flags & IR_DEAD || ir_may_be_entered(branch) || ir_has_kind(branch, IR_OPAQUE) ||
        (s->is_external && concerns_others(branch)))
        return;
    ir_node *rest = ir_new(s->unit->arena, IR_BLOCK, NULL, 1);
    rest->children[0] = branch;
    rest->child_count = 0;
    rest->flags = IR_DEAD | (branch->flags & IR_FROM_MACRO);
    rest->id = branch->id;
    rest->parent = statement;
    rest->range = branch->range;
    if (branch->range.begin < branch->range.end && !(branch->flags & IR_FROM_MACRO))
        rest->range.end = syntax_statement_end(s->unit->source, branch);
    statement->children[number] = rest;
}

static void take_out_below(search *s, ir_node *node) {
    int64_t value;
    s->is_external = false;
    if (node->kind == IR_IF && constant_of(s, node->children[0], &value)) {
        if (value == 0)
            take_out(s, node, 1);
        else if (node->child_count > 2)
            take_out(s, node, 2);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        take_out_below(s, node->children[i]);
}

void dead_branches_take_out(ir_unit *unit) {
    search s = {.unit = unit,
                .results = ARENA_ARRAY(unit->arena, result_of, unit->function_count + 1u)};
    int64_t value;
    for (unsigned i = 0; i < unit->function_count; i++)
        constant_result(&s, unit->functions[i], &value);
    for (unsigned i = 0; i < unit->function_count; i++)
        ir_finish_function(unit->functions[i]);
}
