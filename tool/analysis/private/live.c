/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Determines the liveness of a variable after a loop, by finding its possible first uses on the
 * paths from the end of the loop. Only structured control flow is followed. If the function has a
 * label, every other occurrence counts as a use. If it has a compiled OpenMP directive, the
 * variable counts as live, because the tree does not show that clauses read variables and make them
 * private. */
#include "analysis/private/live.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/loop_text.h"

/* How control may pass through a piece of the program, up to the first use of the variable. A path
 * that first writes the whole variable, or that leaves the function, does not count. */
typedef enum path {
    PATH_READS = 1,    /* reads the variable first */
    PATH_PASSES = 2,   /* reaches the code after the piece without a use */
    PATH_BREAKS = 4,   /* reaches a break out of the piece without a use */
    PATH_CONTINUES = 8 /* reaches a continue out of the piece without a use */
} path;
typedef unsigned paths; /* a set of `path` values */

typedef struct search {
    const ir_variable *variable;
    const ir_node *loop; /* the analysed loop, whose body reads no value from before it */
} search;

static paths paths_of(const search *s, const ir_node *node);

static paths then(paths first, paths second) {
    return first & PATH_PASSES ? (first & ~(paths)PATH_PASSES) | second : first;
}

/* Paths that end in one of these jumps continue after the piece. */
static paths landed(paths all, paths jumps) {
    return all & jumps ? (all & ~jumps) | PATH_PASSES : all;
}

static paths jumps_in(const ir_node *node) {
    paths jumps = node->kind == IR_BREAK      ? PATH_BREAKS
                  : node->kind == IR_CONTINUE ? PATH_CONTINUES
                                              : 0;
    for (unsigned i = 0; i < node->child_count; i++)
        jumps |= jumps_in(node->children[i]);
    return jumps;
}

/* Paths through code that may be executed in any order, or not at all. */
static paths any_paths(const search *s, const ir_node *node) {
    return PATH_PASSES | jumps_in(node) |
           (expression_mentions(node, s->variable) ? (paths)PATH_READS : 0);
}

/* Paths through statements in their order. A switch may enter the sequence at a case. */
static paths paths_in_order(const search *s, const ir_node *node) {
    paths all = PATH_PASSES;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        all = then(ir_holds_case(child) ? all | PATH_PASSES : all, paths_of(s, child));
    }
    return all;
}

/* Paths through operands or initialisers, which are evaluated in any order. */
static paths paths_in_any_order(const search *s, const ir_node *node) {
    paths all = PATH_PASSES;
    for (unsigned i = 0; i < node->child_count; i++) {
        const paths one = paths_of(s, node->children[i]);
        all = one & all & PATH_PASSES ? all | one : (all | one) & ~(paths)PATH_PASSES;
    }
    return all;
}

static paths paths_of_assignment(const search *s, const ir_node *node) {
    const ir_node *target = node->children[0];
    const bool is_whole =
        node->op == IR_OP_NONE && target->kind == IR_VARIABLE && target->variable == s->variable;
    return is_whole ? then(paths_of(s, node->children[1]), 0) : paths_in_any_order(s, node);
}

static paths paths_of_choice(const search *s, const ir_node *node) {
    const paths last = node->child_count > 2 ? paths_of(s, node->children[2]) : PATH_PASSES;
    return then(paths_of(s, node->children[0]), paths_of(s, node->children[1]) | last);
}

/* ---- loops --------------------------------------------------------------------------------- */

/* Paths from the end of the body until the loop ends or the body begins again. */
static paths paths_of_step(const search *s, const ir_node *loop) {
    if (loop->kind == IR_FOR)
        return then(paths_of(s, loop->children[2]), paths_of(s, loop->children[1]));
    return paths_of(s, loop->children[loop->kind == IR_WHILE ? 0 : 1]);
}

/* Paths from a point in the body until the loop ends. `all` are the paths from that point to the
 * end of the body. */
static paths paths_out(const search *s, const ir_node *loop, paths all) {
    assert(ir_is_loop(loop));
    const paths step = paths_of_step(s, loop);
    all = then(landed(all, PATH_CONTINUES), step);
    if (all & PATH_PASSES)
        all |= then(landed(paths_of(s, ir_loop_body(loop)), PATH_CONTINUES), step);
    return landed(all, PATH_BREAKS);
}

static paths paths_of_loop(const search *s, const ir_node *loop) {
    if (loop->kind == IR_DO)
        return paths_out(s, loop, paths_of(s, ir_loop_body(loop)));
    const paths head = loop->kind == IR_FOR
                           ? then(paths_of(s, loop->children[0]), paths_of(s, loop->children[1]))
                           : paths_of(s, loop->children[0]);
    if (loop == s->loop && loop->kind == IR_FOR)
        return head;
    return then(head, PATH_PASSES | paths_out(s, loop, paths_of(s, ir_loop_body(loop))));
}

static paths paths_of_switch(const search *s, const ir_node *node) {
    return then(paths_of(s, node->children[0]),
                PATH_PASSES | landed(paths_of(s, node->children[1]), PATH_BREAKS));
}

/* ---- all kinds ----------------------------------------------------------------------------- */

static paths paths_of_statement(const search *s, const ir_node *node) {
    switch (node->kind) {
    case IR_IF:
        return ir_holds_case(node) ? any_paths(s, node) : paths_of_choice(s, node);
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
        return ir_holds_case(node) ? any_paths(s, node) : paths_of_loop(s, node);
    case IR_SWITCH:
        return paths_of_switch(s, node);
    case IR_BREAK:
        return PATH_BREAKS;
    case IR_CONTINUE:
        return PATH_CONTINUES;
    case IR_RETURN:
        return then(paths_in_order(s, node), 0);
    default:
        return paths_in_order(s, node);
    }
}

static paths paths_of(const search *s, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        return node->variable == s->variable ? PATH_READS : PATH_PASSES;
    case IR_DECLARATOR:
        return then(paths_in_order(s, node),
                    node->variable == s->variable && node->child_count ? 0 : PATH_PASSES);
    case IR_ASSIGN:
        return paths_of_assignment(s, node);
    case IR_CONDITIONAL:
        return paths_of_choice(s, node);
    case IR_BINARY:
        if (node->op == IR_OP_AND || node->op == IR_OP_OR)
            return then(paths_of(s, node->children[0]),
                        PATH_PASSES | paths_of(s, node->children[1]));
        return node->op == IR_OP_COMMA ? paths_in_order(s, node) : paths_in_any_order(s, node);
    case IR_OPAQUE:
        return any_paths(s, node);
    default:
        return node->kind < IR_BLOCK ? paths_in_any_order(s, node) : paths_of_statement(s, node);
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

/* Paths from the end of `node` to the end of the node around it; `all` are the paths to the end of
 * `node`. */
static paths paths_after(const search *s, const ir_node *node, paths all) {
    assert(node->parent);
    const ir_node *parent = node->parent;
    if (ir_is_loop(parent) && node == ir_loop_body(parent))
        return paths_out(s, parent, all);
    const bool is_in_order = parent->kind == IR_BLOCK || parent->kind == IR_DECLARATION;
    const bool is_chosen = parent->kind == IR_IF || parent->kind == IR_SWITCH;
    if (is_chosen && node != parent->children[0])
        return parent->kind == IR_SWITCH ? landed(all, PATH_BREAKS) : all;
    for (unsigned i = 0; i < parent->child_count; i++) {
        const ir_node *child = parent->children[i];
        if (is_in_order ? child->id > node->id : child != node)
            all = then(all, is_in_order ? paths_of(s, child) : any_paths(s, child));
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
    /* control may reach the loop itself again, by a jump or in a loop around it */
    if (!occurs_elsewhere(facts, loop, variable) && !(paths_of(&s, loop) & PATH_READS))
        return false;
    const ir_node *body = loop;
    while (body->parent)
        body = body->parent;
    if (ir_any(body, is_label))
        return true;
    paths all = PATH_PASSES;
    for (const ir_node *node = loop; node->parent && !(all & PATH_READS); node = node->parent)
        all = paths_after(&s, node, all);
    return all & PATH_READS;
}
