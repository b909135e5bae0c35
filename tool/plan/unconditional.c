/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/unconditional.h"

#include "analysis/base/counted.h"

/** May the node skip the statements inside it? False for a loop with constant bounds and without
 * jumps, which executes all its iterations. */
static bool has_condition(const ir_node *node) {
    const ir_variable *counter;
    int64_t first, last;
    if (ir_is_loop(node))
        return !counted_constant(node, &counter, &first, &last) || ir_any(node, ir_is_jump);
    return node->kind == IR_IF || node->kind == IR_SWITCH;
}

/** Does the slice omit a `continue` that precedes `statement` and belongs to a loop around it? */
static bool passes_by_jump(const loop_facts *facts, const ir_node *node, const ir_node *statement) {
    if (node->kind == IR_CONTINUE)
        return node->id < statement->id && !facts->slice.holds[node->id];
    if (node->id >= statement->id || (ir_is_loop(node) && !ir_contains(node, statement)))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (passes_by_jump(facts, node->children[i], statement))
            return true;
    return false;
}

bool is_unconditional(const loop_facts *facts, const ir_node *statement) {
    for (const ir_node *node = statement->parent; node && node != facts->loop; node = node->parent)
        if (has_condition(node) && !facts->slice.holds[node->id])
            return true;
    return passes_by_jump(facts, facts->counted.body, statement);
}

bool update_is_unconditional(const loop_facts *facts, const reduction_update *update) {
    return update->statement->kind == IR_IF || is_unconditional(facts, update->statement);
}

bool source_is_unconditional(const loop_facts *facts, const loop_source *read) {
    return read->is_ahead || !read->place || is_unconditional(facts, read->place);
}

bool row_needs_address(const row_address *address) {
    return address->base_is_object && address->base->type->kind != IR_ARRAY;
}
