/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/expanded_call.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/expandable_call.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/returns.h"
#include "ir/ir_accessors.h"
#include "support/vector.h"

/* ---- arguments ------------------------------------------------------------------------------- */

static bool is_null(const ir_node *node) {
    int64_t value;
    while (node->kind == IR_CAST)
        node = node->children[0];
    return expression_constant(node, &value) && value == 0;
}

/* The operand p if the node is p == NULL, p != NULL or !p; otherwise NULL. */
static const ir_node *compared_with_null(const ir_node *node) {
    const bool is_not = node->kind == IR_UNARY && node->op == IR_OP_NOT;
    const bool compares = node->kind == IR_BINARY &&
                          (node->op == IR_OP_EQUAL || node->op == IR_OP_NOT_EQUAL) &&
                          is_null(node->children[1]);
    const ir_node *operand = is_not || compares ? node->children[0] : NULL;
    while (operand && operand->kind == IR_CAST && ir_is_pointer(operand))
        operand = operand->children[0];
    return operand;
}

/* Is the argument the address of an object, not reached through a pointer, which is never NULL? */
static bool is_object_address(const ir_node *argument) {
    if (!ir_is_address_of(argument) && argument->type->kind != IR_ARRAY)
        return false;
    const ir_node *object = ir_is_address_of(argument) ? argument->children[0] : argument;
    while ((object->kind == IR_MEMBER && !(object->flags & IR_ARROW)) ||
           (object->kind == IR_INDEX && ir_is_array(object->children[0])))
        object = object->children[0];
    return object->kind == IR_VARIABLE && !object->variable->has_other_name &&
           (variable_is_automatic(object->variable) || object->variable->storage == IR_STATIC ||
            object->variable->storage == IR_STATIC_LOCAL);
}

/* Does the function test whether the parameter is NULL? Compilers warn of such tests of arrays. If
 * `is_object` is set, comparisons do not count, since their results replace them. */
static bool is_tested(const ir_node *node, const ir_variable *parameter, bool is_object) {
    const ir_node *compared = compared_with_null(node);
    if (compared && expression_is_variable(compared, parameter))
        return !is_object;
    const bool is_truth =
        node->kind == IR_BINARY && (node->op == IR_OP_AND || node->op == IR_OP_OR);
    const bool is_condition = node->kind == IR_IF || node->kind == IR_CONDITIONAL ||
                              node->kind == IR_WHILE || node->kind == IR_FOR ||
                              node->kind == IR_DO || is_truth;
    for (unsigned i = 0; i < node->child_count; i++)
        if ((is_condition && expression_is_variable(node->children[i], parameter)) ||
            is_tested(node->children[i], parameter, is_object))
            return true;
    return false;
}

/* Does the function use the parameter p only as *p or p->m, as an argument of another call, where
 * the program ends, or, if the argument is_object_address, in comparisons with NULL? */
static bool is_only_followed(const ir_node *node, const ir_variable *parameter, bool is_object) {
    const ir_node *compared = is_object ? compared_with_null(node) : NULL;
    if (compared && expression_is_variable(compared, parameter))
        return true;
    for (unsigned i = 0; i < node->child_count; i++) {
        if (i == 1 && loop_exits_ends_program(node))
            continue;
        if (!expression_is_variable(node->children[i], parameter)) {
            if (!is_only_followed(node->children[i], parameter, is_object))
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
        variable_is_written_in(body, parameter) || !stays(argument, false) ||
        (argument->type->kind == IR_ARRAY &&
         is_tested(body, parameter, is_object_address(argument))))
        return false;
    if (points_alike(argument->type, parameter->type))
        return argument->kind == IR_VARIABLE ||
               is_only_followed(body, parameter, is_object_address(argument)) ||
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
    const ir_node *assigned; /* the assignment of the result in an `if` statement's condition, once
                              * it has been copied */
    ir_node **arguments;     /* indexed by parameter; NULL if a variable replaces the parameter */
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

/* The result of comparing the address of an object with NULL; NULL if the node does not. */
static ir_node *null_comparison(copying *c, const ir_node *node) {
    const ir_node *compared = compared_with_null(node);
    const ir_node *argument = compared ? argument_for(c, compared) : NULL;
    if (!argument || !is_object_address(argument))
        return NULL;
    ir_node *result = new_node(c, IR_NUMBER, node->type, 0);
    result->flags |= IR_HAS_VALUE;
    result->value = node->op == IR_OP_NOT_EQUAL;
    result->text = result->value ? "1" : "0";
    return result;
}

/* The statement that ends the program. The messages before it may name the caller's variables by
 * address. They are not needed, since no iteration executes this exit of the loop (loop_exits.h).
 */
static const ir_node *last_of(const ir_node *branch) {
    return branch->kind == IR_BLOCK ? last_of(branch->children[branch->child_count - 1]) : branch;
}

static ir_node *copied(copying *c, const ir_node *node) {
    const ir_node *argument = argument_for(c, node);
    ir_node *comparison = null_comparison(c, node);
    if (comparison)
        return comparison;
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
        const bool is_end = i == 1 && loop_exits_ends_program(node);
        copy->children[i] = copied(c, is_end ? last_of(node->children[i]) : node->children[i]);
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

/* The caller's statement with `result` in place of the call. It keeps the branches of an `if`. */
static ir_node *with_result(copying *c, const ir_node *node, ir_variable *result) {
    ir_node *copy;
    if (node == c->call) {
        copy = new_node(c, IR_VARIABLE, result->type, 0);
        copy->variable = result;
        return copy;
    }
    if (node == c->assigned)
        return own_copy(c, node->children[0]);
    if (!ir_contains(node, c->call))
        return ir_is_expression(node) ? own_copy(c, node) : (ir_node *)node;
    copy = new_node(c, node->kind, node->type, node->child_count);
    copy->op = node->op;
    copy->variable = node->variable;
    for (unsigned i = 0; i < node->child_count; i++)
        copy->children[i] = with_result(c, node->children[i], result);
    return copy;
}

/* Copies `x = f()` of if ((x = f()) < 0) to a statement of its own; NULL if the condition has
 * another form. The copy of the condition then reads x. */
static ir_node *assignment_before(copying *c, ir_variable *result) {
    const ir_node *node = c->call;
    while (node != c->statement && node->kind != IR_ASSIGN)
        node = node->parent;
    if (c->statement->kind != IR_IF || node == c->statement)
        return NULL;
    ir_node *statement = new_node(c, IR_EXPRESSION, NULL, 1);
    statement->children[0] = with_result(c, node, result);
    c->assigned = node;
    return statement;
}

/* The variables for parameters, the body's statements, and the caller's use of the result, except a
 * declaration. */
static ir_node *block_of(copying *c, ir_variable *result) {
    const ir_function *f = c->function;
    ir_node *body = copied(c, f->body);
    returns_take_out(c->unit->arena, body, result);
    ir_node *block = new_node(c, IR_BLOCK, NULL, f->parameter_count + body->child_count + 3);
    block->function = (ir_function *)f;
    block->flags = IR_SEQUENCE | IR_FROM_CALL | (c->statement->flags & IR_FROM_MACRO);
    block->child_count = 0;
    for (unsigned i = 0; i < f->parameter_count; i++)
        if (!c->arguments[i])
            block->children[block->child_count++] = declaration_of(
                c, variable_for(c, f->parameters[i]), own_copy(c, c->call->children[i + 1]));
    const bool is_declaration = c->statement->kind == IR_DECLARATION;
    if (result && !is_declaration)
        block->children[block->child_count++] = declaration_of(c, result, NULL);
    for (unsigned i = 0; i < body->child_count; i++)
        block->children[block->child_count++] = body->children[i];
    ir_node *assignment = result ? assignment_before(c, result) : NULL;
    if (assignment)
        block->children[block->child_count++] = assignment;
    if (result && !is_declaration)
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

/* Updates address_taken of the variables whose addresses are arguments of the call. If the caller
 * takes such an address nowhere else, no called function can change the variable. */
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

static unsigned number_in(const ir_node *parent, const ir_node *child) {
    unsigned number = 0;
    while (number + 1 < parent->child_count && parent->children[number] != child)
        number++;
    assert(parent->children[number] == child);
    return number;
}

static void finish(const expanded_call *it) {
    ir_finish_function(it->caller);
    count_addresses(it->caller, call_in_statement(it->statement));
}

/* Puts three statements in the place of `int x = f();`: a declaration of the result, the block, and
 * the declaration of x, which stays visible to the statements behind it. */
static void insert(const copying *c, const expanded_call *it, ir_node *first, ir_node *last) {
    ir_node *parent = it->statement->parent;
    const unsigned at = number_in(parent, it->statement), count = parent->child_count;
    ir_node **all = ARENA_ARRAY(c->unit->arena, ir_node *, count + 2);
    for (unsigned i = 0; i < count; i++)
        all[i < at ? i : i + 2] = parent->children[i];
    all[at] = first;
    all[at + 1] = it->block;
    all[at + 2] = last;
    parent->children = all;
    parent->child_count = count + 2;
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
    const bool is_declaration = statement->kind == IR_DECLARATION;
    const bool is_used =
        statement->kind != IR_EXPRESSION || statement->children[0]->kind == IR_ASSIGN;
    ir_variable *result = is_used ? add_variable(&c, "result", function->type->target, NULL) : NULL;
    ir_node *parent = statement->parent;
    expanded_call done = {.caller = caller,
                          .statement = statement,
                          .block = block_of(&c, result),
                          .siblings = is_declaration ? parent->children : NULL};
    if (is_declaration)
        insert(&c, &done, declaration_of(&c, result, NULL), with_result(&c, statement, result));
    else
        parent->children[number_in(parent, statement)] = done.block;
    add_variables(&c);
    finish(&done);
    return done;
}

void expanded_call_put_back(const expanded_call *call) {
    ir_node *parent = call->siblings ? call->statement->parent : call->block->parent;
    if (call->siblings) {
        parent->children = call->siblings;
        parent->child_count -= 2;
    } else {
        parent->children[number_in(parent, call->block)] = call->statement;
    }
    finish(call);
}
