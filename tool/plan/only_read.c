/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/only_read.h"

#include <assert.h>

#include "analysis/base/expression.h"

enum { MOST_DEPTH = 8, MOST_ALIASES = 8 };

/* Variables of one function through which the parameter's target may be reached. */
typedef struct aliases {
    unsigned count;
    const ir_variable *variables[MOST_ALIASES];
    unsigned depth; /* nesting depth of calls */
    bool is_written;
} aliases;

static bool only_reads(const ir_function *function, const ir_variable *variable, unsigned depth);

static bool add(aliases *l, const ir_variable *variable) {
    for (unsigned i = 0; i < l->count; i++)
        if (l->variables[i] == variable)
            return true;
    if (l->count == MOST_ALIASES || !variable_is_automatic(variable) || variable->address_taken)
        return false;
    l->variables[l->count++] = variable;
    return true;
}

/* The whole access path that begins with the node: for p in p->a[i].b it is p->a[i].b. */
static const ir_node *whole_path(const ir_node *node) {
    for (const ir_node *outer = node->parent; outer; node = outer, outer = outer->parent) {
        const bool goes_on = outer->kind == IR_MEMBER || outer->kind == IR_INDEX ||
                             (outer->kind == IR_UNARY && outer->op == IR_OP_DEREFERENCE) ||
                             (outer->kind == IR_CAST && outer->type->kind == IR_POINTER);
        if (!goes_on || outer->children[0] != node)
            break;
    }
    return node;
}

static bool callee_only_reads(aliases *l, const ir_node *call, const ir_node *argument) {
    const ir_function *callee = call->children[0]->function;
    for (unsigned i = 1; callee && i < call->child_count && i <= callee->parameter_count; i++)
        if (call->children[i] == argument)
            return only_reads(callee, callee->parameters[i - 1], l->depth + 1);
    return false;
}

/* Is the path's value used only in ways that cannot write the target? */
static bool is_harmless(aliases *l, const ir_node *path) {
    const ir_node *user = path->parent;
    if (expression_written(user) == path)
        return path->kind == IR_VARIABLE; /* the variable itself is set */
    if (path->type->kind == IR_RECORD)    /* a copy of the record's pointers is not followed */
        return false;
    if (path->type->kind != IR_POINTER && path->type->kind != IR_ARRAY)
        return user->kind != IR_UNARY || user->op != IR_OP_ADDRESS;
    switch (user->kind) {
    case IR_DECLARATOR:
        return add(l, user->variable);
    case IR_ASSIGN:
        return user->op == IR_OP_NONE && user->children[0]->kind == IR_VARIABLE &&
               user->parent->kind == IR_EXPRESSION && add(l, user->children[0]->variable);
    case IR_CALL:
        return callee_only_reads(l, user, path);
    case IR_IF:
        return true;
    default:
        return false;
    }
}

static bool check_node(ir_node *node, void *context) {
    aliases *l = context;
    if (node->kind == IR_OPAQUE)
        l->is_written = true;
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < l->count; i++)
        if (l->variables[i] == node->variable && !is_harmless(l, whole_path(node)))
            l->is_written = true;
    return !l->is_written;
}

static bool only_reads(const ir_function *function, const ir_variable *variable, unsigned depth) {
    assert(depth <= MOST_DEPTH);
    aliases l = {.depth = depth};
    if (depth == MOST_DEPTH || !function->body || function->linkage.is_weak || !add(&l, variable))
        return false;
    for (unsigned known = 0; known < l.count && !l.is_written;) {
        known = l.count;
        ir_walk(function->body, check_node, &l);
    }
    return !l.is_written;
}

bool only_reads_through(const ir_function *function, unsigned number) {
    assert(function);
    return number < function->parameter_count &&
           only_reads(function, function->parameters[number], 0);
}
