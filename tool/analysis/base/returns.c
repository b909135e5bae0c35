/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/returns.h"

#include <assert.h>

static bool may_return(const ir_node *node) {
    return ir_has_kind(node, IR_RETURN);
}

static bool always_returns(const ir_node *node) {
    if (node->kind == IR_RETURN)
        return true;
    if (node->kind == IR_IF)
        return node->child_count > 2 && always_returns(node->children[1]) &&
               always_returns(node->children[2]);
    for (unsigned i = 0; node->kind == IR_BLOCK && i < node->child_count; i++)
        if (always_returns(node->children[i]))
            return true;
    return false;
}

/* ---- can they be removed? -------------------------------------------------------------------- */

static bool is_decided(const ir_node *branch) {
    return !may_return(branch) || always_returns(branch);
}

/* Can the `return` statements in this statement be removed? `is_followed` says that other
 * statements come after it. */
static bool is_structured(const ir_node *node, bool is_followed) {
    if (node->kind == IR_RETURN || !may_return(node))
        return true;
    if (node->kind == IR_BLOCK) {
        for (unsigned i = 0; i < node->child_count; i++) {
            const bool is_last = i + 1 == node->child_count;
            if (!is_structured(node->children[i], is_followed || !is_last))
                return false;
            if (always_returns(node->children[i]))
                return true;
        }
        return !is_followed;
    }
    if (node->kind != IR_IF)
        return false;
    for (unsigned i = 1; i < node->child_count; i++)
        if ((is_followed && !is_decided(node->children[i])) ||
            !is_structured(node->children[i], is_followed && !always_returns(node->children[i])))
            return false;
    return true;
}

bool returns_are_structured(const ir_node *body) {
    return is_structured(body, false);
}

/* ---- removal --------------------------------------------------------------------------------- */

typedef struct removal {
    arena *memory;
    ir_variable *result;
} removal;

static ir_node *new_like(const removal *r, const ir_node *like, ir_kind kind, const ir_type *type,
                         unsigned child_count) {
    ir_node *node = ir_new(r->memory, kind, type, child_count);
    node->range = like->range;
    node->flags = like->flags & (IR_FROM_MACRO | IR_FROM_CALL);
    return node;
}

/* The replacement of a `return`: `result = value;`, `value;` or an empty block. */
static ir_node *without_return(const removal *r, const ir_node *node) {
    ir_node *value = ir_child(node, 0);
    if (!value || (!r->result && !ir_has_effect(value)))
        return new_like(r, node, IR_BLOCK, NULL, 0);
    ir_node *statement = new_like(r, node, IR_EXPRESSION, NULL, 1);
    if (r->result) {
        ir_node *assignment = new_like(r, node, IR_ASSIGN, r->result->type, 2);
        assignment->children[0] = new_like(r, node, IR_VARIABLE, r->result->type, 0);
        assignment->children[0]->variable = r->result;
        assignment->children[1] = value;
        value = assignment;
    }
    statement->children[0] = value;
    return statement;
}

static void remove_below(const removal *r, ir_node *node);

/* A block of `branch`, if that is not NULL, and the statements of `block` from number `first` on.
 */
static ir_node *branch_with_rest(const removal *r, ir_node *branch, const ir_node *block,
                                 unsigned first) {
    ir_node *all = new_like(r, block, IR_BLOCK, NULL, 1 + block->child_count - first);
    all->child_count = 0;
    if (branch)
        all->children[all->child_count++] = branch;
    for (unsigned i = first; i < block->child_count; i++)
        all->children[all->child_count++] = block->children[i];
    return all;
}

/* Statement number `at` of the block is an `if`. Moves the statements after it into its branch that
 * does not return. */
static void move_rest(const removal *r, ir_node *block, unsigned at) {
    ir_node *old = block->children[at];
    const bool then_returns = always_returns(old->children[1]);
    ir_node *new = new_like(r, old, IR_IF, NULL, 3);
    new->children[0] = old->children[0];
    new->children[1] =
        then_returns ? old->children[1] : branch_with_rest(r, old->children[1], block, at + 1);
    new->children[2] =
        then_returns ? branch_with_rest(r, ir_child(old, 2), block, at + 1) : old->children[2];
    block->children[at] = new;
    block->child_count = at + 1;
}

static void remove_from_block(const removal *r, ir_node *block) {
    for (unsigned i = 0; i < block->child_count; i++) {
        ir_node *child = block->children[i];
        if (!may_return(child))
            continue;
        if (always_returns(child))
            block->child_count = i + 1;
        else if (child->kind == IR_IF && i + 1 < block->child_count)
            move_rest(r, block, i);
        if (block->children[i]->kind == IR_RETURN)
            block->children[i] = without_return(r, block->children[i]);
        else
            remove_below(r, block->children[i]);
    }
}

static void remove_below(const removal *r, ir_node *node) {
    if (node->kind == IR_BLOCK) {
        remove_from_block(r, node);
        return;
    }
    assert(node->kind == IR_IF);
    for (unsigned i = 1; i < node->child_count; i++) {
        if (node->children[i]->kind == IR_RETURN)
            node->children[i] = without_return(r, node->children[i]);
        else if (may_return(node->children[i]))
            remove_below(r, node->children[i]);
    }
}

void returns_take_out(arena *a, ir_node *body, ir_variable *result) {
    const removal r = {a, result};
    assert(body->kind == IR_BLOCK);
    remove_below(&r, body);
}
