/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/rewritable.h"
#include "plan/continuation.h"

#include <ctype.h>
#include <string.h>

#include "ir/ir_syntax.h"
#include "plan/lookup.h"

/** Records an obstacle if the node is the address of the base itself: a pointer to the whole array,
 *  or the location of a pointer. The pointer that replaces the base has another address. */
static void check_address(loop_plan *plan, const ir_node *base, const ir_node *node) {
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS && syntax_same(base, node->children[0]))
        plan_obstacle(plan, node->range, "the address of its array as a whole is taken");
    for (unsigned i = 0; i < node->child_count; i++)
        check_address(plan, base, node->children[i]);
}

static bool is_constant_scalar(const ir_type *type) {
    const ir_type *inner = ir_type_innermost(type);
    return (type->is_const || inner->is_const) && !inner->is_volatile && !inner->is_atomic &&
           ir_type_is_scalar(inner) && inner->kind != IR_POINTER;
}

/** Is the variable used in another way than by reading it or its elements? If so, its address
 *  matters, and that differs between the copies of the body. */
static bool goes_by_address(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_VARIABLE && node->variable == variable) {
        const ir_node *whole = node;
        while (whole->type->kind == IR_ARRAY && whole->parent->kind == IR_INDEX &&
               whole->parent->children[0] == whole)
            whole = whole->parent;
        return whole->type->kind == IR_ARRAY ||
               (whole->parent->kind == IR_UNARY && whole->parent->op == IR_OP_ADDRESS);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (goes_by_address(node->children[i], variable))
            return true;
    return false;
}

static void check_statement(loop_plan *plan, const ir_node *node) {
    if (node->kind == IR_LABEL)
        plan_obstacle(plan, node->range, "its body contains a label, which cannot be duplicated");
    if (node->kind == IR_DECLARATOR && node->variable->storage == IR_GLOBAL)
        plan_obstacle(plan, node->range, "its body declares '%s' extern", node->variable->name);
    if (node->kind == IR_DECLARATOR && node->variable->storage == IR_STATIC_LOCAL &&
        (!is_constant_scalar(node->variable->type) ||
         goes_by_address(plan->facts->counted.body, node->variable)))
        plan_obstacle(plan, node->range, "its body declares '%s' static", node->variable->name);
    if (node->kind == IR_VARIABLE && node->variable->storage == IR_THREAD_LOCAL &&
        !ir_type_is_scalar(node->variable->type))
        plan_obstacle(plan, node->range, "'%s' is another object in each thread",
                      node->variable->name);
    for (unsigned i = 0; i < node->child_count; i++)
        check_statement(plan, node->children[i]);
}

/** Does the function's text have `inline` before its body, and not `static`? If so, C forbids
 *  static objects in it (C17 6.7.4p3). */
static bool is_shared_inline(const ir_unit *unit, const ir_function *function) {
    if (function->linkage.is_static || !function->body)
        return false;
    const char *text = unit->source->text;
    for (uint32_t i = function->range.begin; i + 6 <= function->body->range.begin; i++)
        if (strncmp(text + i, "inline", 6) == 0 && !(i > 0 && isalnum((unsigned char)text[i - 1])))
            return true; /* not a part of another word, such as `noinline` */
    return false;
}

static void check_loop(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    if (is_shared_inline(plan->unit, facts->function))
        plan_obstacle(plan, facts->loop->range,
                      "'%s' is inline but not static: it cannot hold static data",
                      facts->function->name);
    const uint32_t end = syntax_statement_end(plan->unit->source, facts->loop);
    if (facts->loop->kind == IR_DO && end == facts->loop->range.end)
        plan_obstacle(plan, facts->loop->range, "its semicolon comes from a macro");
    if (syntax_editable_statement(facts->loop, facts->function->body) != facts->loop)
        plan_obstacle(plan, facts->loop->range, "one macro call expands to it and more");
    for (unsigned i = 0; i < facts->array_count; i++) {
        const ir_variable *root = ir_root_variable(facts->arrays[i].base);
        if (root && root->storage == IR_THREAD_LOCAL)
            plan_obstacle(plan, facts->loop->range, "'%s' is another object in each thread",
                          root->name);
    }
    check_statement(plan, facts->loop);
}

/* ---- the counter --------------------------------------------------------------------------- */

enum {
    WIDE_SIZE = 8, /* size of redcc_int, the type of iteration numbers */
    STEP_BITS = 40 /* a loop whose step needs more bits is not written */
};

static bool is_integer(const ir_type *type) {
    return (type->kind == IR_INTEGER && type->size <= WIDE_SIZE) || type->kind == IR_BOOLEAN;
}

/** Records an obstacle unless counter and bound are integers of at most 64 bits, the first value
 * can be converted to such an integer, and the step is small. */
static void check_counter(loop_plan *plan) {
    const counted_loop *counted = &plan->facts->counted;
    const ir_type *counter = counted->counter->type;
    if (counter->kind == IR_POINTER)
        return; /* lower and bound are addresses */
    if (counter->kind != IR_INTEGER || counter->size > WIDE_SIZE ||
        !is_integer(counted->bound->type))
        plan_obstacle(plan, plan->facts->loop->range, "its counter or bound is not an integer");
    else if (counted->lower && !is_integer(counted->lower->type) &&
             counted->lower->type->kind != IR_FLOATING)
        plan_obstacle(plan, counted->lower->range, "the counter's first value is not an integer");
    else if (counted->step >> STEP_BITS != (counted->step > 0 ? 0 : -1))
        plan_obstacle(plan, plan->facts->loop->range, "its step is too large");
}

/* ---- updates ------------------------------------------------------------------------------- */

static bool contains_base(const loop_facts *facts, const ir_node *node, unsigned array) {
    if (loop_array_of_base(facts, node) == (int)array)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (contains_base(facts, node->children[i], array))
            return true;
    return false;
}

/** Records an obstacle if two updates are in one statement, or if an update that may be made in a
 * private copy does not name its array. In the body the array's name stands for the private
 * copy. */
static void check_updates(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    for (unsigned i = 0; i < facts->update_count; i++) {
        const reduction_update *update = &facts->updates[i];
        if (!facts->arrays[update->array].order_is_kept &&
            !contains_base(facts, update->statement, update->array))
            plan_obstacle(plan, update->statement->range,
                          "an update does not name '%s', the array that it changes",
                          facts->arrays[update->array].name);
        for (unsigned other = 0; other < i; other++)
            if (facts->updates[other].statement == update->statement)
                plan_obstacle(plan, update->statement->range, "one statement makes two updates");
    }
}

/* ---- all of it ----------------------------------------------------------------------------- */

void check_place(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    check_loop(plan);
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!facts->arrays[i].is_scattered)
            check_address(plan, facts->arrays[i].base, facts->counted.body);
}

void check_iterations(loop_plan *plan) {
    const loop_exits *exits = plan->facts->slice.exits;
    if (exits && exits->open && !may_continue_at_exits(plan->facts))
        plan_obstacle(plan, plan->facts->loop->range, "it has no bound, and cannot continue");
    if (exits && exits->open && plan->facts->scalar_count)
        plan_obstacle(plan, plan->facts->loop->range, "it has no bound, and a sum needs one");
    check_counter(plan);
    check_updates(plan);
}
