/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/lanes.h"

#include <assert.h>

#include "plan/inner_iterations.h"
#include "plan/lane_calls.h"
#include "plan/lookup.h"
#include "plan/work.h"

/* ---- the loop itself ------------------------------------------------------------------------- */

/** Does the loop update an array whose rows are reached through pointers in memory? */
static bool has_unnamed_array(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].is_scattered)
            return true;
    return false;
}

lane_reason plan_lanes(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const bool is_asked =
        plan->options->lanes == LANES_OF_ALL ||
        (plan->options->lanes == LANES_OF_HEAVY && plan->execution.work >= WORK_HEAVY);
    if (!is_asked)
        return LANES_NOT_ASKED;
    if (!facts->inspector.exists)
        return NO_LANES_INSPECTOR;
    if (leaves_values(facts) || facts->forward_count > 0 || facts->slice.exits ||
        plan_has_leaders(plan)) /* a leader is needed, for example, if skipped code may set errno */
        return NO_LANES_OTHER_VALUES;
    if (plan->options->order == ORDER_ANY)
        return NO_LANES_ANY_ORDER;
    if (facts->counted.counter->type->kind == IR_POINTER || facts->counted.stride)
        return NO_LANES_COUNTER;
    if (facts->counted.body->kind != IR_BLOCK)
        return NO_LANES_BODY;
    return has_unnamed_array(facts) ? NO_LANES_SCATTERED : LANES_WRITTEN;
}

/* ---- updates --------------------------------------------------------------------------------- */

bool lane_has_update(const loop_facts *facts, const ir_node *statement) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(statement, facts->updates[i].statement))
            return true;
    return false;
}

bool lane_mentions(const ir_node *node, const ir_variable *variable) {
    if (node->variable == variable && (node->kind == IR_VARIABLE || node->kind == IR_DECLARATOR))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (lane_mentions(node->children[i], variable))
            return true;
    return false;
}

/** Returns the variable that this node declares, assigns or steps; NULL if there is none. Sets
 * *other if only a part of the variable, or the target of a pointer, is assigned. */
static const ir_variable *assigned_by(const ir_node *node, bool *other) {
    if (node->kind == IR_DECLARATOR)
        return node->variable;
    if (node->kind != IR_ASSIGN && !ir_is_increment(node))
        return NULL;
    const ir_variable *root = ir_root_variable(node->children[0]);
    *other |= node->children[0]->kind != IR_VARIABLE;
    return root;
}

bool lane_begins_with(const ir_node *loop, const ir_variable *variable) {
    assert(loop->kind == IR_FOR);
    bool other = false;
    const ir_node *first = loop->children[0];
    if (first->kind == IR_DECLARATION) {
        for (unsigned i = 0; i < first->child_count; i++)
            if (first->children[i]->variable == variable && first->children[i]->child_count > 0)
                return true;
        return false;
    }
    return first->kind == IR_ASSIGN && first->op == IR_OP_NONE &&
           assigned_by(first, &other) == variable;
}

bool lane_is_counter_only(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_FOR && lane_begins_with(node, variable))
        return true;
    if (node->kind == IR_DECLARATOR && node->variable == variable)
        return node->child_count == 0;
    if (node->kind == IR_VARIABLE && node->variable == variable)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!lane_is_counter_only(node->children[i], variable))
            return false;
    return true;
}

const ir_node *lane_updating(const lane_scope *l, const ir_node *node) {
    const loop_facts *facts = l->plan->facts;
    const ir_node *block = l->body;
    assert(block->kind == IR_BLOCK);
    bool is_pending = false;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *statement = block->children[i];
        const bool updates = lane_has_update(facts, statement);
        if (!ir_contains(statement, node)) {
            is_pending |= updates;
            continue;
        }
        if (!updates)
            return NULL;
        if (is_pending || i + 1 < block->child_count || !lane_is_part(facts, statement))
            return statement;
        if (!ir_contains(statement->children[1], node))
            return NULL; /* in the condition, which is computed for all lanes */
        block = statement->children[1];
        i = (unsigned)-1;
    }
    return NULL;
}

/** Work of statements with updates, which is executed lane by lane. */
typedef struct scalar_work {
    int64_t outside;    /* number of IR nodes outside of the updates themselves */
    int64_t operations; /* all operations of these statements, and calls made lane by lane */
} scalar_work;

static void add_scalar_work(const lane_scope *l, const ir_node *node, scalar_work *work) {
    if (!lane_has_update(l->plan->facts, node))
        return;
    if (node != l->body && lane_updating(l, node)) {
        work->outside += work_outside_updates(l->plan, node);
        work->operations += work_of_statement(l->plan, node);
        return;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        add_scalar_work(l, node->children[i], work);
}

void lane_check_worth(lane_scope *l) {
    scalar_work scalar = {0, 0};
    const int64_t all = l->plan->execution.work;
    if (l->plan->options->lanes == LANES_OF_ALL)
        return;
    add_scalar_work(l, l->body, &scalar);
    scalar.operations += LANE_CALL_WORK * lane_count_calls(l);
    if (scalar.operations > all / 4 || scalar.outside > all - scalar.operations)
        lane_problem(l, NO_LANES_SCALAR_UPDATES, l->body);
}

/** Does the node, in an expression, have an effect other than a call? */
static bool is_effect(const ir_node *node) {
    return node->kind == IR_ASSIGN || node->kind == IR_OPAQUE || node->kind == IR_STRING ||
           node->kind == IR_INITIALIZERS || ir_is_increment(node);
}

/** Checks an update, which is executed once for each lane and may change only the element. */
static void check_update(lane_scope *l, const ir_node *statement) {
    const ir_node *value = statement->kind == IR_EXPRESSION ? statement->children[0] : NULL;
    bool is_plain = value && (value->kind == IR_ASSIGN || value->kind == IR_UNARY);
    for (unsigned i = 0; is_plain && i < value->child_count; i++)
        is_plain =
            !ir_any(value->children[i], is_effect) && !lane_has_whole_vector(l, value->children[i]);
    if (!is_plain)
        lane_problem(l, NO_LANES_UPDATE, statement);
}

static bool leaves_updates(const ir_node *jump, const ir_node *updating) {
    assert(updating && ir_contains(updating, jump));
    for (const ir_node *at = jump->parent; at && at != updating->parent; at = at->parent)
        if (ir_is_loop(at))
            return false;
    return true;
}

/** May an update statement assign the variable or, if is_element, a part of it? True only if the
 * variable is private to the lane, or is a loop counter. */
static bool may_be_assigned_in_update(lane_scope *l, const ir_variable *variable, bool is_element) {
    if (!variable || !lane_is_own(l, variable))
        return false;
    switch (l->class_of[variable->id]) {
    case LANE_LOCAL:
        return !is_element || variable->type->kind == IR_ARRAY;
    case LANE_VARYING:
    case LANE_VECTOR:
        return !is_element && variable->type->kind != IR_ARRAY;
    case LANE_UNIFORM:
        return !is_element && lane_is_counter_only(l->body, variable);
    default:
        return false;
    }
}

static bool check_update_node(ir_node *node, void *context) {
    lane_scope *l = context;
    bool other = false;
    if (loop_update_at(l->plan->facts, node)) {
        check_update(l, node);
        return false;
    }
    if (lane_is_real(node->type) && lane_vector_element(l, node))
        return false;
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_VECTOR)
        lane_problem(l, NO_LANES_ARRAY_AS_POINTER, node);
    const ir_variable *variable = assigned_by(node, &other);
    const bool is_jump = node->kind == IR_CONTINUE || node->kind == IR_BREAK;
    const bool is_address = node->kind == IR_UNARY && node->op == IR_OP_ADDRESS;
    const ir_variable *pointed = is_address ? ir_root_variable(node->children[0]) : NULL;
    if (node->kind == IR_OPAQUE || node->kind == IR_GOTO || node->kind == IR_LABEL ||
        node->kind == IR_SWITCH || node->kind == IR_RETURN ||
        (is_jump && leaves_updates(node, lane_updating(l, node))) ||
        (pointed && lane_is_own(l, pointed) && l->class_of[pointed->id] != LANE_LOCAL))
        lane_problem(l, NO_LANES_BESIDE_UPDATE, node);
    if ((variable || other) && !may_be_assigned_in_update(l, variable, other))
        lane_problem(l, NO_LANES_BESIDE_UPDATE, node);
    return true;
}

/** May the node change the variable: assign it, declare it, take its address or, if it is an array,
 * name it? */
static bool may_change(const ir_node *node, const ir_variable *variable) {
    bool other = false;
    if (assigned_by(node, &other) == variable)
        return true;
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
        ir_root_variable(node->children[0]) == variable)
        return true;
    if (node->kind == IR_OPAQUE && lane_mentions(node, variable))
        return true;
    if (variable->type->kind == IR_ARRAY)
        return lane_mentions(node, variable);
    for (unsigned i = 0; i < node->child_count; i++)
        if (may_change(node->children[i], variable))
            return true;
    return false;
}

void lane_check_order(lane_scope *l, const ir_node *body) {
    assert(body->kind == IR_BLOCK);
    for (unsigned i = 0; i < l->plan->unit->variable_count; i++) {
        const ir_variable *variable = l->plan->unit->variables[i];
        if (!lane_is_own(l, variable) || lane_is_counter_only(l->body, variable))
            continue;
        bool is_read = false, is_changed = false;
        for (unsigned k = 0; k < body->child_count; k++) {
            const ir_node *statement = body->children[k];
            if (statement == body_increment(l->plan->facts))
                continue; /* lanes omit it */
            if (lane_has_update(l->plan->facts, statement)) {
                is_read |= lane_mentions(statement, variable);
                is_changed |= may_change(statement, variable);
            } else if ((is_read && may_change(statement, variable)) ||
                       (is_changed && lane_mentions(statement, variable)))
                lane_problem(l, NO_LANES_USED_BELOW, statement);
        }
    }
}

bool lane_is_exit(const ir_node *statement) {
    if (statement->kind != IR_IF || statement->child_count > 2)
        return false;
    const ir_node *branch = statement->children[1];
    if (branch->kind == IR_BLOCK && branch->child_count == 1)
        branch = branch->children[0];
    return branch->kind == IR_CONTINUE;
}

bool lane_is_part(const loop_facts *facts, const ir_node *statement) {
    if (statement->kind != IR_IF || statement->child_count > 2 ||
        statement->children[1]->kind != IR_BLOCK)
        return false;
    const ir_node *branch = statement->children[1];
    for (unsigned i = 0; i < branch->child_count; i++)
        if (!lane_has_update(facts, branch->children[i]))
            return true;
    return false;
}

void lane_check_updates(lane_scope *l, const ir_node *statement) {
    ir_walk((ir_node *)statement, check_update_node, l);
}

/* ---- loops inside, and calls ----------------------------------------------------------------- */

static bool is_uniform_step(lane_scope *l, const ir_node *node) {
    if (node->kind == IR_EMPTY)
        return true;
    if (node->kind == IR_BINARY && node->op == IR_OP_COMMA)
        return is_uniform_step(l, node->children[0]) && is_uniform_step(l, node->children[1]);
    return (ir_is_increment(node) || node->kind == IR_ASSIGN) &&
           node->children[0]->kind == IR_VARIABLE && lane_is_own(l, node->children[0]->variable) &&
           l->class_of[node->children[0]->variable->id] == LANE_UNIFORM &&
           (ir_is_increment(node) || lane_is_uniform(l, node->children[1]));
}

bool lane_loop_is_uniform(lane_scope *l, const ir_node *loop) {
    assert(loop->kind == IR_FOR);
    const ir_node *first = loop->children[0], *condition = loop->children[1];
    if (condition->kind == IR_EMPTY || !lane_is_uniform(l, condition) ||
        !is_uniform_step(l, loop->children[2]))
        return false;
    if (first->kind != IR_DECLARATION)
        return is_uniform_step(l, first);
    for (unsigned i = 0; i < first->child_count; i++)
        if (l->class_of[first->children[i]->variable->id] != LANE_UNIFORM)
            return false;
    return true;
}

enum { MOST_DEPTH = 8 /* nesting depth of calls */ };

const ir_type *lane_vector_type(const ir_variable *variable) {
    const ir_type *type = variable->type;
    return ir_type_innermost(type->kind == IR_POINTER ? type->target : type);
}

lane_class lane_parameter_class(lane_scope *l, const ir_variable *parameter, const ir_node *value) {
    assert(parameter->storage == IR_PARAMETER);
    const ir_type *type = parameter->type;
    if (type->is_volatile || type->is_atomic)
        lane_problem(l, NO_LANES_STORAGE, value);
    const ir_variable *root = lane_vector_root(l, value);
    if (lane_is_real(type))
        return LANE_VECTOR;
    if (type->kind == IR_POINTER && root) {
        const ir_type *element = ir_type_innermost(type->target);
        if (!lane_is_real(element) || element->size != lane_vector_type(root)->size)
            lane_problem(l, NO_LANES_ARRAY_AS_POINTER, value);
        return LANE_VECTOR;
    }
    if (type->kind != IR_POINTER && type->kind != IR_INTEGER && type->kind != IR_BOOLEAN)
        lane_problem(l, NO_LANES_OPERAND_TYPE, value);
    if (lane_mentions_vector(l, value))
        lane_problem(l, NO_LANES_FROM_DOUBLE, value);
    return lane_is_uniform(l, value) ? LANE_UNIFORM : LANE_VARYING;
}

bool lane_can_be_called(const ir_function *function, const ir_node *call, unsigned depth) {
    assert(function->body);
    const ir_type *result = function->type->target;
    const ir_node *body = function->body;
    if (function->is_variadic || function->is_noreturn || function->linkage.import ||
        depth >= MOST_DEPTH || call->child_count != function->parameter_count + 1 ||
        (result->kind != IR_VOID && !lane_is_real(result)))
        return false;
    return result->kind == IR_VOID ||
           (body->child_count > 0 && body->children[body->child_count - 1]->kind == IR_RETURN);
}

void lane_check_operand(lane_scope *l, const ir_node *value) {
    if (!lane_is_plain(value))
        lane_problem(l, lane_effect_of(value), value);
    if (lane_mentions_vector(l, value))
        lane_problem(l, NO_LANES_FROM_DOUBLE, value);
}
