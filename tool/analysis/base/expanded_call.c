/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/expanded_call.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/expandable_call.h"
#include "analysis/base/expression.h"
#include "analysis/base/returns.h"
#include "ir/ir_accessors.h"
#include "support/vector.h"

/* ---- arguments ------------------------------------------------------------------------------- */

/* Does the function use the parameter p only as *p or p->m, or as an argument of another call? */
static bool is_only_followed(const ir_node *node, const ir_variable *parameter) {
    for (unsigned i = 0; i < node->child_count; i++) {
        if (!expression_is_variable(node->children[i], parameter)) {
            if (!is_only_followed(node->children[i], parameter))
                return false;
        } else if (!(node->kind == IR_MEMBER && (node->flags & IR_ARROW)) &&
                   !(node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE) &&
                   !(node->kind == IR_CALL && i > 0)) {
            return false;
        }
    }
    return true;
}

/* Does the function name the parameter only as p[k] with 0 <= k < count? For a row of a matrix with
 * `count` elements other subscripts would be undefined, although they may be defined for a pointer.
 */
static bool stays_inside(const ir_node *node, const ir_variable *parameter, int64_t count) {
    int64_t low, high;
    if (expression_is_variable(node, parameter))
        return false;
    const bool is_element =
        node->kind == IR_INDEX && expression_is_variable(node->children[0], parameter);
    if (is_element && (!counted_range(node->children[1], &low, &high) || low < 0 || high >= count))
        return false;
    for (unsigned i = is_element; i < node->child_count; i++)
        if (!stays_inside(node->children[i], parameter, count))
            return false;
    return true;
}

/* Has the expression, or the address of the lvalue, one value during the whole call? */
static bool stays(const ir_node *node, bool as_address) {
    switch (node->kind) {
    case IR_NUMBER:
        return true;
    case IR_VARIABLE:
        return (as_address && node->type->kind != IR_POINTER) || node->type->kind == IR_ARRAY ||
               is_own_scalar(node);
    case IR_CAST:
        return ir_type_is_scalar(node->type) && stays(node->children[0], false);
    case IR_UNARY:
        return node->op == IR_OP_ADDRESS
                   ? stays(node->children[0], true)
                   : node->op == IR_OP_MINUS && stays(node->children[0], false);
    case IR_BINARY:
        return (node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT ||
                node->op == IR_OP_MULTIPLY) &&
               stays(node->children[0], false) && stays(node->children[1], false);
    case IR_INDEX:
        return (as_address || node->type->kind == IR_ARRAY) &&
               stays(node->children[0], ir_is_array(node->children[0])) &&
               stays(node->children[1], false);
    case IR_MEMBER:
        return (as_address || node->type->kind == IR_ARRAY) &&
               stays(node->children[0], !(node->flags & IR_ARROW));
    default:
        return false;
    }
}

static bool points_alike(const ir_type *from, const ir_type *to) {
    const bool is_address = from->kind == IR_POINTER || from->kind == IR_ARRAY;
    return is_address && to->kind == IR_POINTER && ir_type_equal(from->target, to->target);
}

/* May the argument replace the parameter wherever the function names it? */
static bool can_replace(const ir_node *argument, const ir_variable *parameter,
                        const ir_node *body) {
    if (parameter->address_taken || parameter->type->is_volatile ||
        variable_is_written_in(body, parameter) || !stays(argument, false))
        return false;
    if (points_alike(argument->type, parameter->type))
        return argument->kind == IR_VARIABLE || is_only_followed(body, parameter) ||
               (argument->type->kind == IR_ARRAY &&
                stays_inside(body, parameter, argument->type->count));
    return (argument->kind == IR_VARIABLE || argument->kind == IR_NUMBER) &&
           ir_type_is_scalar(parameter->type) && ir_type_equal(argument->type, parameter->type);
}

/* ---- the block ------------------------------------------------------------------------------- */

typedef struct copying {
    ir_unit *unit;
    ir_function *caller;
    const ir_function *function;
    const ir_node *statement, *call;
    ir_node **arguments; /* indexed by parameter; NULL if a variable replaces the parameter */
    VECTOR(const ir_variable *) old;
    VECTOR(ir_variable *) added; /* added.items[i] replaces old.items[i] */
} copying;

static ir_node *new_node(copying *c, ir_kind kind, const ir_type *type, unsigned child_count) {
    ir_node *node = ir_new(c->unit->arena, kind, type, child_count);
    node->range = c->statement->range;
    node->flags = IR_FROM_MACRO | IR_FROM_CALL;
    return node;
}

static ir_variable *add_variable(copying *c, const char *name, const ir_type *type,
                                 const ir_variable *old) {
    arena *a = c->unit->arena;
    ir_declared *declared = ARENA_NEW(a, ir_declared);
    ir_variable *variable = ARENA_NEW(a, ir_variable);
    name = arena_format(a, "redcc__in_%s_%s", c->function->name, name);
    *declared = (ir_declared){.name = name, .offset = c->statement->range.begin};
    *variable = (ir_variable){.name = name,
                              .type = type,
                              .storage = IR_LOCAL,
                              .function = c->caller,
                              .id = c->unit->variable_count + c->added.count,
                              .range = c->statement->range,
                              .address_taken = old && old->address_taken,
                              .is_unnamed = true,
                              .declared = declared};
    VECTOR_PUSH(a, &c->old, old);
    VECTOR_PUSH(a, &c->added, variable);
    return variable;
}

static ir_variable *variable_for(copying *c, ir_variable *variable) {
    if (variable->function != c->function)
        return variable;
    for (unsigned i = 0; i < c->old.count; i++)
        if (c->old.items[i] == variable)
            return c->added.items[i];
    return add_variable(c, variable->name, variable->type, variable);
}

static const ir_node *argument_for(const copying *c, const ir_node *node) {
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < c->function->parameter_count; i++)
        if (c->function->parameters[i] == node->variable)
            return c->arguments[i];
    return NULL;
}

static void mark(ir_node *node, ir_range range) {
    node->range = range;
    node->flags |= IR_FROM_MACRO | IR_FROM_CALL;
    for (unsigned i = 0; i < node->child_count; i++)
        mark(node->children[i], range);
}

/* Replaces a constant's name, or a sizeof, by its value: in the caller the name may mean something
 * else. */
static void spell_value(copying *c, ir_node *node) {
    if ((node->kind != IR_SIZEOF && node->kind != IR_NUMBER) || !(node->flags & IR_HAS_VALUE) ||
        isdigit((unsigned char)node->text[0]))
        return;
    node->kind = IR_NUMBER;
    node->text =
        arena_format(c->unit->arena, "((%s)%lldLL)",
                     node->type->spelling ? node->type->spelling : "int", (long long)node->value);
}

static ir_node *copied(copying *c, const ir_node *node) {
    const ir_node *argument = argument_for(c, node);
    if (argument) {
        ir_node *copy = ir_substitute(c->unit->arena, argument, NULL, NULL);
        mark(copy, c->statement->range);
        return copy;
    }
    ir_node *copy = new_node(c, node->kind, node->type, node->child_count);
    bool is_replaced = false;
    copy->op = node->op;
    copy->flags |= node->flags & (IR_ARROW | IR_DESIGNATED | IR_HAS_VALUE | IR_COMPOUND_LITERAL);
    copy->variable = node->variable ? variable_for(c, node->variable) : NULL;
    copy->function = node->function;
    copy->field = node->field;
    copy->text = node->text;
    copy->value = node->value;
    for (unsigned i = 0; i < node->child_count; i++) {
        copy->children[i] = copied(c, node->children[i]);
        is_replaced |= argument_for(c, node->children[i]) != NULL;
    }
    spell_value(c, copy);
    ir_simplify_access(c->unit->arena, copy, is_replaced);
    return copy;
}

static ir_node *declaration_of(copying *c, ir_variable *variable, ir_node *value) {
    ir_node *declaration = new_node(c, IR_DECLARATION, NULL, 1);
    ir_node *declarator = new_node(c, IR_DECLARATOR, NULL, value ? 1 : 0);
    declarator->variable = variable;
    if (value)
        declarator->children[0] = value;
    declaration->children[0] = declarator;
    return declaration;
}

static ir_node *own_copy(copying *c, const ir_node *node) {
    ir_node *copy = ir_substitute(c->unit->arena, node, NULL, NULL);
    mark(copy, c->statement->range);
    return copy;
}

/* The caller's statement with `result` in place of the call. */
static ir_node *with_result(copying *c, const ir_node *node, ir_variable *result) {
    ir_node *copy;
    if (node == c->call) {
        copy = new_node(c, IR_VARIABLE, result->type, 0);
        copy->variable = result;
        return copy;
    }
    if (ir_is_expression(node) && !ir_contains(node, c->call))
        return own_copy(c, node);
    copy = new_node(c, node->kind, node->type, node->child_count);
    copy->op = node->op;
    for (unsigned i = 0; i < node->child_count; i++)
        copy->children[i] = with_result(c, node->children[i], result);
    return copy;
}

/* The variables for parameters, the body's statements, and the caller's use of the result. */
static ir_node *block_of(copying *c) {
    const ir_function *f = c->function;
    const bool is_used = c->statement->children[0]->kind == IR_ASSIGN;
    ir_variable *result = is_used ? add_variable(c, "result", f->type->target, NULL) : NULL;
    ir_node *body = copied(c, f->body);
    returns_take_out(c->unit->arena, body, result);
    ir_node *block = new_node(c, IR_BLOCK, NULL, f->parameter_count + body->child_count + 2);
    block->flags = IR_SEQUENCE | IR_FROM_CALL | (c->statement->flags & IR_FROM_MACRO);
    block->child_count = 0;
    for (unsigned i = 0; i < f->parameter_count; i++)
        if (!c->arguments[i])
            block->children[block->child_count++] = declaration_of(
                c, variable_for(c, f->parameters[i]), own_copy(c, c->call->children[i + 1]));
    if (result)
        block->children[block->child_count++] = declaration_of(c, result, NULL);
    for (unsigned i = 0; i < body->child_count; i++)
        block->children[block->child_count++] = body->children[i];
    if (result)
        block->children[block->child_count++] = with_result(c, c->statement, result);
    return block;
}

static void add_variables(const copying *c) {
    ir_unit *unit = c->unit;
    ir_variable **all =
        ARENA_ARRAY(unit->arena, ir_variable *, unit->variable_count + c->added.count + 1);
    memcpy(all, unit->variables, unit->variable_count * sizeof *all);
    for (unsigned i = 0; i < c->added.count; i++)
        all[unit->variable_count + i] = c->added.items[i];
    unit->variables = all;
    unit->variable_count += c->added.count;
}

/* ---- the exchange ---------------------------------------------------------------------------- */

/* Updates address_taken of the variables that the call gets by address: if no `&` of them is left
 * in the caller, they count as own scalars. */
static void count_addresses(const ir_function *caller, const ir_node *call) {
    for (unsigned i = 1; i < call->child_count; i++) {
        const ir_node *argument = call->children[i];
        ir_variable *variable =
            ir_is_address_of(argument) && argument->children[0]->kind == IR_VARIABLE
                ? argument->children[0]->variable
                : NULL;
        if (variable && variable->function == caller && ir_type_is_scalar(variable->type) &&
            !ir_has_kind(caller->body, IR_OPAQUE))
            variable->address_taken = takes_address_of(caller->body, variable);
    }
}

static void exchange(const expanded_call *it, ir_node *old, ir_node *new) {
    ir_node *parent = old->parent;
    bool is_found = false;
    for (unsigned i = 0; i < parent->child_count; i++)
        if (parent->children[i] == old) {
            parent->children[i] = new;
            is_found = true;
        }
    assert(is_found);
    (void)is_found;
    ir_finish_function(it->caller);
    count_addresses(it->caller, call_in_statement(it->statement));
}

expanded_call expanded_call_take_in(ir_unit *unit, ir_function *caller, ir_node *statement) {
    ir_node *call = expandable_call_of(unit, caller, statement);
    assert(call && ir_contains(caller->body, statement));
    const ir_function *function = ir_called_function(call);
    copying c = {.unit = unit,
                 .caller = caller,
                 .function = function,
                 .statement = statement,
                 .call = call,
                 .arguments = ARENA_ARRAY(unit->arena, ir_node *, function->parameter_count + 1)};
    for (unsigned i = 0; i < function->parameter_count; i++)
        if (can_replace(call->children[i + 1], function->parameters[i], function->body))
            c.arguments[i] = call->children[i + 1];
    expanded_call done = {.caller = caller, .statement = statement};
    done.block = block_of(&c);
    add_variables(&c);
    exchange(&done, statement, done.block);
    return done;
}

void expanded_call_put_back(const expanded_call *call) {
    exchange(call, call->block, call->statement);
}
