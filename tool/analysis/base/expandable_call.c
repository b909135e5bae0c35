/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/expandable_call.h"

#include <string.h>

#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/returns.h"

enum { MOST_NODES = 2000 }; /* greatest number of nodes in the function's body */

/* ---- functions whose bodies can replace a call ----------------------------------------------- */

static unsigned count_nodes(const ir_node *node) {
    unsigned count = 1;
    for (unsigned i = 0; i < node->child_count; i++)
        count += count_nodes(node->children[i]);
    return count;
}

bool takes_address_of(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
        expression_is_variable(node->children[0], variable))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (takes_address_of(node->children[i], variable))
            return true;
    return false;
}

/* Can the copied body use a variable with another name in place of this one? */
static bool can_be_renamed(const ir_variable *variable, const ir_node *body) {
    if (ir_type_is_variably_modified(variable->type) || variable->has_other_name)
        return false;
    if (variable->storage == IR_PARAMETER)
        return true;
    /* if `&` does not take its address, an attribute may: cleanup */
    return variable->storage == IR_LOCAL && variable->type->spelling &&
           (!variable->address_taken || !ir_type_is_scalar(variable->type) ||
            takes_address_of(body, variable));
}

static bool can_be_copied(const ir_node *node, const ir_function *function) {
    switch (node->kind) {
    case IR_OPAQUE:
        if (!assertion_condition(node))
            return false;
        break;
    case IR_LABEL:
    case IR_GOTO:
        return false;
    case IR_SIZEOF:
        if (!(node->flags & IR_HAS_VALUE))
            return false;
        break;
    case IR_VARIABLE:
    case IR_DECLARATOR:
        if (node->variable->storage == IR_THREAD_LOCAL)
            return false;
        if (node->variable->function && !can_be_renamed(node->variable, function->body))
            return false;
        break;
    default:
        break;
    }
    if (node->type && ir_type_is_variably_modified(node->type))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!can_be_copied(node->children[i], function))
            return false;
    return true;
}

/* Is there a preprocessor directive in the range? It may select other text when the output is
 * compiled, or may be a pragma. */
static bool holds_directive(const ir_unit *unit, ir_range range) {
    for (unsigned i = 0; i < unit->directive_count; i++)
        if (unit->directives[i].range.begin < range.end &&
            range.begin < unit->directives[i].range.end)
            return true;
    return false;
}

/* Is it not an old-style definition, f(a, b) double a, b; { ... }, whose arguments are converted
 * differently? */
static bool has_prototype(const ir_function *function) {
    return function->type->spelling && !strstr(function->type->spelling, "()");
}

static bool is_floating_operation(const ir_node *node) {
    const bool is_operator = node->kind == IR_BINARY || node->kind == IR_UNARY;
    return expression_is_floating_work(node) ||
           (is_operator && node->op >= IR_OP_LESS && node->op <= IR_OP_NOT &&
            node->children[0]->type && ir_type_is_floating(node->children[0]->type));
}

static unsigned count_floating(const ir_node *node) {
    unsigned count = is_floating_operation(node);
    for (unsigned i = 0; i < node->child_count; i++)
        count += count_floating(node->children[i]);
    return count;
}

static bool is_no_addition(const ir_node *node) {
    return is_floating_operation(node) && node->op != IR_OP_ADD && node->op != IR_OP_SUBTRACT;
}

static bool calls_known_function(const ir_node *node) {
    const ir_function *function = node->kind == IR_CALL ? ir_called_function(node) : NULL;
    return function && function->body && !function->is_noreturn;
}

/* Has the body these bits in another file, too, which may be compiled by other flags? They may
 * permit fused multiplications, other orders of additions, and comparisons that ignore NaN. All of
 * them concern several floating operations, also in inlined calls, or one that is no addition. */
static bool has_same_bits(const ir_node *body) {
    return count_floating(body) <= 1 && !ir_any(body, is_no_addition) &&
           !ir_any(body, calls_known_function);
}

static bool can_stand_in(const ir_unit *unit, const ir_function *function) {
    if (!function || !function->body || function->is_variadic ||
        (function->linkage.import && !has_same_bits(function->body)) || function->has_errors ||
        function->has_other_attributes || function->linkage.is_weak ||
        function->linkage.is_renamed || function->is_noreturn || function->is_from_system ||
        !has_prototype(function) || function->type->target->is_const ||
        (function->is_in_main_file && holds_directive(unit, function->body->range)))
        return false;
    for (unsigned i = 0; i < function->parameter_count; i++)
        if (!can_be_renamed(function->parameters[i], function->body))
            return false;
    return count_nodes(function->body) < MOST_NODES && returns_are_structured(function->body) &&
           can_be_copied(function->body, function);
}

/* ---- names ----------------------------------------------------------------------------------- */

static bool is_hidden(const ir_unit *unit, const ir_function *caller, const char *name) {
    if (unit->text.inner_names && map_get(unit->text.inner_names, name, strlen(name)))
        return true;
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->function == caller && strcmp(unit->variables[i]->name, name) == 0)
            return true;
    return false;
}

/* Is it declared before the caller's definition? Names of another file's functions and variables
 * without a declaration in this file (`declared` is NULL) are unknown here. */
static bool is_before(const ir_declared *declared, const ir_function *caller, bool is_imported) {
    if (!declared)
        return !is_imported;
    return declared->file || !caller->is_in_main_file || declared->offset < caller->range.begin;
}

/* Do the names of file-scope objects and functions in the body mean the same in the caller? */
static bool has_known_names(const ir_unit *unit, const ir_function *caller, const ir_node *node,
                            bool is_imported) {
    const ir_variable *variable = node->kind == IR_VARIABLE ? node->variable : NULL;
    const ir_function *called = node->kind == IR_FUNCTION ? node->function : NULL;
    if (variable && !variable->function &&
        (!is_before(variable->declared, caller, is_imported) ||
         is_hidden(unit, caller, variable->name)))
        return false;
    if (called && (!is_before(called->declared, caller, is_imported) ||
                   is_hidden(unit, caller, called->name)))
        return false;
    const bool skips_branch = is_imported && loop_exits_ends_program(node);
    for (unsigned i = 0; i < node->child_count; i++)
        if (!(skips_branch && i == 1) &&
            !has_known_names(unit, caller, node->children[i], is_imported))
            return false;
    return true;
}

/* ---- statements ------------------------------------------------------------------------------ */

bool is_own_scalar(const ir_node *node) {
    return node->kind == IR_VARIABLE && variable_is_automatic(node->variable) &&
           !node->variable->address_taken && node->type && ir_type_is_scalar(node->type) &&
           !node->type->is_volatile && !node->type->is_atomic;
}

/* Is it an assignment to an own scalar, as in `if ((error = add(p, i)) != 0)`? */
static bool assigns_own_scalar(const ir_node *node) {
    return node->kind == IR_ASSIGN && node->op == IR_OP_NONE && is_own_scalar(node->children[0]);
}

/* The only call in an arithmetic expression of numbers and own scalars. If the expression has
 * another form, clears *is_plain; the result is then NULL. */
static ir_node *call_among(const ir_node *node, bool *is_plain) {
    if (node->kind == IR_CALL)
        return (ir_node *)node;
    *is_plain &= node->kind == IR_NUMBER || node->kind == IR_CAST || is_own_scalar(node) ||
                 assigns_own_scalar(node) ||
                 (node->kind == IR_UNARY && node->op >= IR_OP_PLUS && node->op <= IR_OP_BIT_NOT) ||
                 (node->kind == IR_BINARY && node->op <= IR_OP_NOT_EQUAL);
    ir_node *found = NULL;
    for (unsigned i = 0; i < node->child_count && *is_plain; i++) {
        ir_node *call = call_among(node->children[i], is_plain);
        *is_plain &= !call || !found;
        found = call ? call : found;
    }
    return *is_plain ? found : NULL;
}

/* Is it `x = ...` with a variable that the called function may know? It is stored after the call.
 */
static bool stores_variable(const ir_node *node) {
    const ir_type *type = node->children[0]->type;
    return node->op == IR_OP_NONE && node->children[0]->kind == IR_VARIABLE && type &&
           ir_type_is_scalar(type) && !type->is_volatile && !type->is_atomic &&
           node->children[0]->variable->storage != IR_THREAD_LOCAL;
}

/* The value of the only variable that the declaration declares, in a block; NULL if it has another
 * form. */
static const ir_node *only_value_declared(const ir_node *declaration) {
    const ir_node *declarator = declaration->children[0];
    return declaration->child_count == 1 && declaration->parent &&
                   declaration->parent->kind == IR_BLOCK && declarator->kind == IR_DECLARATOR &&
                   declarator->variable->storage == IR_LOCAL &&
                   ir_type_is_scalar(declarator->variable->type)
               ? ir_child(declarator, 0)
               : NULL;
}

ir_node *call_in_statement(const ir_node *statement) {
    bool is_plain = true;
    if (statement->kind == IR_IF)
        return call_among(statement->children[0], &is_plain);
    if (statement->kind == IR_DECLARATION) {
        const ir_node *value = only_value_declared(statement);
        return value ? call_among(value, &is_plain) : NULL;
    }
    ir_node *node = statement->kind == IR_EXPRESSION ? statement->children[0] : NULL;
    while (node && node->kind == IR_CAST && node->type && node->type->kind == IR_VOID)
        node = node->children[0];
    if (!node || node->kind == IR_CALL)
        return node;
    return node->kind == IR_ASSIGN && (is_own_scalar(node->children[0]) || stores_variable(node))
               ? call_among(node->children[1], &is_plain)
               : NULL;
}

static bool changes_something(const ir_node *node) {
    return node->kind == IR_OPAQUE || expression_written(node);
}

ir_node *expandable_call_of(const ir_unit *unit, const ir_function *caller,
                            const ir_node *statement) {
    ir_node *call = call_in_statement(statement);
    const ir_function *function = call ? ir_called_function(call) : NULL;
    if (!can_stand_in(unit, function) ||
        !has_known_names(unit, caller, function->body, function->linkage.import != NULL) ||
        call->child_count != function->parameter_count + 1 ||
        statement->range.begin >= statement->range.end)
        return NULL;
    for (unsigned i = 1; i < call->child_count; i++)
        if (ir_any(call->children[i], changes_something) || !call->children[i]->type)
            return NULL;
    return call;
}
