/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Backward liveness of one variable, computed forward: the possible first uses of it on the paths
 * from the end of the loop. Structured control only; a label anywhere in the function makes every
 * other occurrence count. So does a compiled OpenMP directive: its clauses read variables and
 * privatise them, which the tree does not show.
 */
#include "analysis/private/live.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/loop_text.h"

/* Paths of control through a piece of the program up to the first use of the variable. A path that
 * first writes all of it, or ends the function, does not count. */
typedef enum way {
    WAY_READS = 1,    /* reads it first */
    WAY_PASSES = 2,   /* reaches the following code without a use */
    WAY_BREAKS = 4,   /* the same: reaches a break out of the piece */
    WAY_CONTINUES = 8 /* the same: reaches a continue */
} way;
typedef unsigned ways; /* of enum way */

typedef struct search {
    const ir_variable *variable;
    const ir_node *loop; /* the analysed one: its body reads no earlier value */
} search;

static ways ways_of(const search *s, const ir_node *node);

static ways then(ways first, ways second) {
    return first & WAY_PASSES ? (first & ~(ways)WAY_PASSES) | second : first;
}

/* The paths after such jumps. */
static ways landed(ways all, ways jumps) {
    return all & jumps ? (all & ~jumps) | WAY_PASSES : all;
}

static ways jumps_in(const ir_node *node) {
    ways jumps = node->kind == IR_BREAK      ? WAY_BREAKS
                 : node->kind == IR_CONTINUE ? WAY_CONTINUES
                                             : 0;
    for (unsigned i = 0; i < node->child_count; i++)
        jumps |= jumps_in(node->children[i]);
    return jumps;
}

/* Paths through code that is executed in an unknown order, if at all. */
static ways any_ways(const search *s, const ir_node *node) {
    return WAY_PASSES | jumps_in(node) |
           (expression_mentions(node, s->variable) ? (ways)WAY_READS : 0);
}

/* Does it contain a case of an enclosing switch? */
static bool holds_case(const ir_node *node) {
    if (node->kind == IR_CASE || node->kind == IR_DEFAULT)
        return true;
    for (unsigned i = 0; i < node->child_count && node->kind != IR_SWITCH; i++)
        if (holds_case(node->children[i]))
            return true;
    return false;
}

/* Statements one after another; a switch may enter at its cases. */
static ways ways_in_order(const search *s, const ir_node *node) {
    ways all = WAY_PASSES;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        all = then(holds_case(child) ? all | WAY_PASSES : all, ways_of(s, child));
    }
    return all;
}

/* Operands and initialisers, in any order. */
static ways ways_in_any_order(const search *s, const ir_node *node) {
    ways all = WAY_PASSES;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ways one = ways_of(s, node->children[i]);
        all = one & all & WAY_PASSES ? all | one : (all | one) & ~(ways)WAY_PASSES;
    }
    return all;
}

static ways ways_of_assignment(const search *s, const ir_node *node) {
    const ir_node *target = node->children[0];
    const bool is_whole =
        node->op == IR_OP_NONE && target->kind == IR_VARIABLE && target->variable == s->variable;
    return is_whole ? then(ways_of(s, node->children[1]), 0) : ways_in_any_order(s, node);
}

static ways ways_of_choice(const search *s, const ir_node *node) {
    const ways last = node->child_count > 2 ? ways_of(s, node->children[2]) : WAY_PASSES;
    return then(ways_of(s, node->children[0]), ways_of(s, node->children[1]) | last);
}

/* ---- loops --------------------------------------------------------------------------------- */

/* From the end of the body until the loop ends or the body begins again. */
static ways ways_of_step(const search *s, const ir_node *loop) {
    if (loop->kind == IR_FOR)
        return then(ways_of(s, loop->children[2]), ways_of(s, loop->children[1]));
    return ways_of(s, loop->children[loop->kind == IR_WHILE ? 0 : 1]);
}

/* From a point in the body until the loop ends; `all`: the paths from there to the body's end. */
static ways ways_out(const search *s, const ir_node *loop, ways all) {
    const ways step = ways_of_step(s, loop);
    all = then(landed(all, WAY_CONTINUES), step);
    if (all & WAY_PASSES)
        all |= then(landed(ways_of(s, ir_loop_body(loop)), WAY_CONTINUES), step);
    return landed(all, WAY_BREAKS);
}

static ways ways_of_loop(const search *s, const ir_node *loop) {
    if (loop->kind == IR_DO)
        return ways_out(s, loop, ways_of(s, ir_loop_body(loop)));
    const ways head = loop->kind == IR_FOR
                          ? then(ways_of(s, loop->children[0]), ways_of(s, loop->children[1]))
                          : ways_of(s, loop->children[0]);
    if (loop == s->loop && loop->kind == IR_FOR)
        return head;
    return then(head, WAY_PASSES | ways_out(s, loop, ways_of(s, ir_loop_body(loop))));
}

static ways ways_of_switch(const search *s, const ir_node *node) {
    return then(ways_of(s, node->children[0]),
                WAY_PASSES | landed(ways_of(s, node->children[1]), WAY_BREAKS));
}

/* ---- all kinds ----------------------------------------------------------------------------- */

static ways ways_of_statement(const search *s, const ir_node *node) {
    switch (node->kind) {
    case IR_IF:
        return holds_case(node) ? any_ways(s, node) : ways_of_choice(s, node);
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
        return holds_case(node) ? any_ways(s, node) : ways_of_loop(s, node);
    case IR_SWITCH:
        return ways_of_switch(s, node);
    case IR_BREAK:
        return WAY_BREAKS;
    case IR_CONTINUE:
        return WAY_CONTINUES;
    case IR_RETURN:
        return then(ways_in_order(s, node), 0);
    default:
        return ways_in_order(s, node);
    }
}

static ways ways_of(const search *s, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        return node->variable == s->variable ? WAY_READS : WAY_PASSES;
    case IR_DECLARATOR:
        return then(ways_in_order(s, node),
                    node->variable == s->variable && node->child_count ? 0 : WAY_PASSES);
    case IR_ASSIGN:
        return ways_of_assignment(s, node);
    case IR_CONDITIONAL:
        return ways_of_choice(s, node);
    case IR_BINARY:
        if (node->op == IR_OP_AND || node->op == IR_OP_OR)
            return then(ways_of(s, node->children[0]), WAY_PASSES | ways_of(s, node->children[1]));
        return node->op == IR_OP_COMMA ? ways_in_order(s, node) : ways_in_any_order(s, node);
    case IR_OPAQUE:
        return any_ways(s, node);
    default:
        return node->kind < IR_BLOCK ? ways_in_any_order(s, node) : ways_of_statement(s, node);
    }
}

/* ---- after the loop -------------------------------------------------------------------------- */

static bool is_label(const ir_node *node) {
    return node->kind == IR_LABEL || node->kind == IR_GOTO;
}

static bool occurs_elsewhere(variable_facts *facts, const ir_node *loop,
                             const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++)
        if (!ir_contains(loop, fact->occurrences.items[i]))
            return true;
    return false;
}

/* The paths from the end of `node` to the end of its enclosing statement. */
static ways ways_behind(const search *s, const ir_node *node, ways all) {
    const ir_node *parent = node->parent;
    if (ir_is_loop(parent) && node == ir_loop_body(parent))
        return ways_out(s, parent, all);
    const bool is_in_order = parent->kind == IR_BLOCK || parent->kind == IR_DECLARATION;
    const bool is_chosen = parent->kind == IR_IF || parent->kind == IR_SWITCH;
    if (is_chosen && node != parent->children[0])
        return parent->kind == IR_SWITCH ? landed(all, WAY_BREAKS) : all;
    for (unsigned i = 0; i < parent->child_count; i++) {
        const ir_node *child = parent->children[i];
        if (is_in_order ? child->id > node->id : child != node)
            all = then(all, is_in_order ? ways_of(s, child) : any_ways(s, child));
    }
    return all;
}

bool variable_is_live_after(variable_facts *facts, const openmp_loop *openmp, const ir_node *loop,
                            const ir_variable *variable) {
    assert(ir_is_loop(loop));
    const search s = {variable, loop};
    const ir_unit *unit = variable_facts_unit(facts);
    if (variable->function && openmp_keeps_value(unit, openmp, loop, variable))
        return false;
    if (!variable->function || (text_openmp_in(unit->arena, unit, variable->function) &&
                                !function_has_ignored_openmp(unit, variable->function)))
        return true;
    /* The loop itself may be reached again, by a jump or in a loop around it. */
    if (!occurs_elsewhere(facts, loop, variable) && !(ways_of(&s, loop) & WAY_READS))
        return false;
    const ir_node *body = loop;
    while (body->parent)
        body = body->parent;
    if (ir_any(body, is_label))
        return true;
    ways all = WAY_PASSES;
    for (const ir_node *node = loop; node->parent && !(all & WAY_READS); node = node->parent)
        all = ways_behind(&s, node, all);
    return all & WAY_READS;
}
