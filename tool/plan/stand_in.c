/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/stand_in.h"

#include "plan/macros.h"

static bool is_sizeof(const ir_node *node) {
    return node->kind == IR_SIZEOF || node->kind == IR_OPAQUE;
}

/** Does the tree name the variable at offset `at` of the file? Nodes from macros have no
 *  offsets. */
static bool is_named_at(const ir_node *node, const ir_variable *variable, uint32_t at) {
    if (node->kind == IR_VARIABLE && node->variable == variable && node->range.begin == at &&
        !(node->flags & IR_FROM_MACRO))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_named_at(node->children[i], variable, at))
            return true;
    return false;
}

static bool is_named_by_macro(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_VARIABLE && node->variable == variable && node->flags & IR_FROM_MACRO)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_named_by_macro(node->children[i], variable))
            return true;
    return false;
}

enum { MOST_MENTIONS = 64 }; /* each costs a search of the whole body */

/** Does the tree have a node for each occurrence of the variable's name in the body's text? It has
 *  none for names in types (the length of an array, a typeof), which may use the array's type or
 *  size. */
static bool is_named_by_nodes(const loop_plan *plan, const ir_variable *variable) {
    const ir_node *body = plan->facts->counted.body;
    const char *text = plan->unit->source->text;
    const size_t length = strlen(variable->name);
    unsigned mentions = 0;
    for (uint32_t at = body->range.begin; at < body->range.end; at++) {
        if (text[at] == '\\' || text[at] == '?') { /* a splice, \u or trigraph changes a word */
            if (text[at] == '\\' || text[at + 1] == '?')
                return false;
            continue;
        }
        const bool is_begin =
            source_is_name_byte(text[at]) && (at == 0 || !source_is_name_byte(text[at - 1]));
        if (is_begin && strncmp(text + at, variable->name, length) == 0 &&
            !source_is_name_byte(text[at + length]) &&
            (++mentions > MOST_MENTIONS || !is_named_at(body, variable, at)))
            return false;
    }
    return !is_named_by_macro(body, variable);
}

/** Does the body use a macro? A macro may name a variable in a type, for which the tree has no
 * node: `#define LIKE typeof(h)`. */
bool has_macro(const loop_plan *plan) {
    const ir_range body = plan->facts->counted.body->range;
    return macro_name_in(plan->arena, plan->unit, plan->unit->source->text + body.begin,
                         body.end - body.begin) != NULL;
}

bool can_be_pointer(const loop_plan *plan, const ir_variable *variable) {
    return !ir_any(plan->facts->counted.body, is_sizeof) && !has_macro(plan) &&
           is_named_by_nodes(plan, variable);
}

bool can_be_shadowed(const loop_plan *plan, const ir_node *base) {
    if (base->kind != IR_VARIABLE)
        return false;
    return base->type->kind == IR_POINTER || can_be_pointer(plan, base->variable);
}
