/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Before the loop begins it is unknown whether an iteration writes memory that the bound reads. In
 * `do h[k[i]]++; while (++i < n / m[0]);`, m[0] may be 0 until the first iteration writes it. The
 * bound may therefore be a value read from memory, but no address or divisor in it may depend on
 * such a value. */
#include "analysis/base/counted_bound.h"

#include "analysis/base/expression.h"

/* Does the value consist of numbers and of local variables that change only by name? Then no store
 * to memory in the first iteration changes it. */
static bool is_steady(const ir_node *node) {
    switch (node->kind) {
    case IR_NUMBER:
    case IR_SIZEOF:
        return true;
    case IR_VARIABLE:
        return node->type->kind == IR_ARRAY ||
               (variable_is_automatic(node->variable) && !node->variable->address_taken &&
                !node->variable->has_other_name);
    case IR_CAST:
    case IR_UNARY:
    case IR_BINARY:
    case IR_CONDITIONAL:
        if (node->kind == IR_UNARY &&
            (node->op == IR_OP_ADDRESS || node->op == IR_OP_DEREFERENCE || ir_is_increment(node)))
            return false;
        for (unsigned i = 0; i < node->child_count; i++)
            if (!is_steady(node->children[i]))
                return false;
        return true;
    default:
        return false;
    }
}

/* Is the address of the object (n, p->n, s.n, *p, p[2]) steady, so that no store to memory changes
 * it? */
static bool has_steady_address(const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        return true;
    case IR_MEMBER:
        return node->flags & IR_ARROW ? is_steady(node->children[0])
                                      : has_steady_address(node->children[0]);
    case IR_INDEX:
        return is_steady(node->children[1]) &&
               (node->children[0]->type->kind == IR_ARRAY ? has_steady_address(node->children[0])
                                                          : is_steady(node->children[0]));
    default:
        return node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE &&
               is_steady(node->children[0]);
    }
}

bool counted_bound_is_safe_before(const ir_node *bound) {
    return is_steady(bound) || has_steady_address(bound);
}
