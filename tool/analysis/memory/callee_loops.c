/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/callee_loops.h"

#include <assert.h>

#include "analysis/base/expression.h"

/* ---- leaving a loop -------------------------------------------------------------------------- */

/* Does `part` contain a `continue` before `node`, which may skip it? */
static bool continues_before(const ir_node *part, const ir_node *node) {
    if (part->kind == IR_CONTINUE)
        return part->id < node->id;
    if (ir_is_loop(part))
        return false;
    for (unsigned i = 0; i < part->child_count; i++)
        if (continues_before(part->children[i], node))
            return true;
    return false;
}

static bool returns_before(const ir_node *part, const ir_node *node) {
    if (part->id >= node->id)
        return false;
    if (part->kind == IR_RETURN)
        return !ir_contains(part, node);
    for (unsigned i = 0; i < part->child_count; i++)
        if (returns_before(part->children[i], node))
            return true;
    return false;
}

/* ---- the loops ------------------------------------------------------------------------------- */

static void take_loop(callee_loops *loops, ir_node *loop) {
    const counted_result found = counted_recognise(loop);
    const ir_variable *counter;
    int64_t first, last;
    if (!found.is_counted || !found.loop.lower || ir_holds_case(ir_loop_body(loop)))
        return;
    if (loops->count == CALLEE_MOST_LOOPS) {
        loops->are_known = false;
        return;
    }
    for (unsigned i = loops->count++; i > 0; i--)
        loops->items[i] = loops->items[i - 1];
    loops->items[0] = (callee_loop){.loop = loop,
                                    .counted = found.loop,
                                    .is_constant = counted_constant(loop, &counter, &first, &last),
                                    .may_end_early = ir_leaves_loop(ir_loop_body(loop))};
}

/* The innermost loop whose body contains the node, or the function's body. */
static const ir_node *innermost(const ir_node *node) {
    while (node->parent && !(node->parent->kind == IR_FOR && ir_loop_body(node->parent) == node))
        node = node->parent;
    return node;
}

static callee_loops find_loops(variable_facts *facts, const ir_function *function,
                               const ir_node *child) {
    callee_loops loops = {.body = function->body, .are_known = true};
    for (ir_node *outer = child->parent; outer; child = outer, outer = outer->parent)
        if (outer->kind == IR_FOR && ir_loop_body(outer) == child)
            take_loop(&loops, outer);
    /* a jump may lead into a loop, or skip an assignment */
    if (child != function->body || variable_facts_has_jump(facts, function))
        loops.are_known = false;
    return loops;
}

callee_loops callee_loops_around(arena *a, variable_facts *facts, map *found,
                                 const ir_function *function, const ir_node *node) {
    assert(function->body && ir_contains(function->body, node));
    const ir_node *body = innermost(node);
    void **known = map_at(found, &body, sizeof body);
    if (!*known) {
        callee_loops *loops = ARENA_NEW(a, callee_loops);
        *loops = find_loops(facts, function, body);
        *known = loops;
    }
    return *(const callee_loops *)*known;
}

bool callee_loops_counter(callee_loops *loops, const ir_variable *variable, const ir_node *site) {
    for (unsigned i = 0; loops->are_known && site && i < loops->count; i++) {
        callee_loop *item = &loops->items[i];
        if (item->counted.counter == variable && ir_contains(ir_loop_body(item->loop), site)) {
            item->is_used = true;
            return true;
        }
    }
    return false;
}

bool callee_loops_share(const callee_loops *loops, const ir_variable *variable,
                        const ir_node *first, const ir_node *second) {
    for (unsigned i = 0; i < loops->count; i++)
        if (loops->items[i].counted.counter == variable &&
            ir_contains(ir_loop_body(loops->items[i].loop), first) &&
            ir_contains(ir_loop_body(loops->items[i].loop), second))
            return true;
    return false;
}

/* ---- certain execution ----------------------------------------------------------------------- */

static bool is_one_of(const callee_loops *loops, const ir_node *loop) {
    for (unsigned i = 0; i < loops->count; i++)
        if (loops->items[i].loop == loop)
            return true;
    return false;
}

/* Does each counted iteration of the loop happen and reach `node`? */
static bool reaches_in_all_iterations(const callee_loops *loops, const ir_node *loop,
                                      const ir_node *node) {
    const ir_variable *counter;
    int64_t first, last;
    return (is_one_of(loops, loop) || counted_constant(loop, &counter, &first, &last)) &&
           !ir_leaves_loop(ir_loop_body(loop)) && !continues_before(ir_loop_body(loop), node);
}

/* Is this part evaluated whenever its parent is? */
static bool is_certain_part(const callee_loops *loops, const ir_node *parent, const ir_node *part,
                            const ir_node *node) {
    switch (parent->kind) {
    case IR_IF:
    case IR_CONDITIONAL:
    case IR_SWITCH:
    case IR_WHILE:
        return parent->children[0] == part;
    case IR_BINARY:
        return (parent->op != IR_OP_AND && parent->op != IR_OP_OR) || parent->children[0] == part;
    case IR_FOR:
        return parent->children[0] == part || parent->children[1] == part ||
               (ir_loop_body(parent) == part && reaches_in_all_iterations(loops, parent, node));
    case IR_BLOCK:
    case IR_EXPRESSION:
    case IR_DECLARATION:
    case IR_DECLARATOR:
    case IR_RETURN:
    case IR_INITIALIZERS:
    case IR_ASSIGN:
    case IR_UNARY:
    case IR_INDEX:
    case IR_MEMBER:
    case IR_CAST:
    case IR_CALL:
        return true;
    default:
        return false;
    }
}

bool callee_loops_is_certain(const callee_loops *loops, const ir_node *node) {
    if (!loops->are_known)
        return false;
    for (const ir_node *part = node; part != loops->body; part = part->parent)
        if (!part->parent || !is_certain_part(loops, part->parent, part, node))
            return false;
    return !returns_before(loops->body, node); /* last, because it walks the whole body */
}

/* ---- variables set once ---------------------------------------------------------------------- */

/* The statement or declaration that contains `place`, if it is directly in a block; otherwise
 * NULL. */
static const ir_node *statement_in_block(const ir_node *place) {
    const ir_node *statement = place->parent;
    return statement && (statement->kind == IR_EXPRESSION || statement->kind == IR_DECLARATION) &&
                   statement->parent && statement->parent->kind == IR_BLOCK
               ? statement
               : NULL;
}

bool callee_loops_is_set_before(const ir_node *place, const ir_node *site) {
    const ir_node *statement = place ? statement_in_block(place) : NULL;
    if (!statement)
        return false;
    const ir_node *block = statement->parent;
    const ir_node *later = site;
    while (later && later->parent != block)
        later = later->parent;
    if (!later || later->id < statement->id || (later == statement && site->id < place->id))
        return false;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *between = block->children[i];
        if (between->id > statement->id && between->id <= later->id && ir_holds_case(between))
            return false;
    }
    return true;
}
