/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds statements that own their bytes although a macro is involved. `for (...) UPD(h, k[i], w);`
 * ends inside a macro's expansion. Nothing else comes from that expansion, so the whole statement
 * may be replaced. */
#include <string.h>

#include "frontend/convert.h"

static bool is_inside(ir_range inner, ir_range outer) {
    return outer.begin <= inner.begin && inner.end <= outer.end && inner.begin < inner.end;
}

static bool overlaps_sibling(const ir_node *parent, unsigned index) {
    ir_range own = parent->children[index]->range;
    for (unsigned i = 0; i < parent->child_count; i++) {
        ir_range other = parent->children[i]->range;
        bool is_disjoint = other.end <= own.begin || own.end <= other.begin;
        if (i != index && other.begin != other.end && !is_disjoint)
            return true;
    }
    return false;
}

static bool begins_in_macro(const converter *c, const ir_node *node) {
    return map_get(c->expansions.ends, &node->range.begin, sizeof node->range.begin) != NULL;
}

/* Is the last byte before the node, ignoring blanks, a `)`? Then the node directly follows the
 * controlling expression of the statement around it. */
static bool follows_parenthesis(const converter *c, const ir_node *node) {
    const char *text = c->unit->source->text;
    uint32_t at = node->range.begin;
    while (at > 0 && strchr(" \t\r\n", text[at - 1]) != NULL)
        at--;
    return at > 0 && text[at - 1] == ')';
}

/* Does the statement of a block own its bytes? It must share no byte with the braces or with
 * another statement. A loop that begins in a macro does not own its bytes, because the macro may
 * put a pragma before the loop. */
static bool owns_bytes_in_block(const converter *c, const ir_node *block, unsigned index) {
    const ir_node *statement = block->children[index];
    bool is_strictly_inside = is_inside(statement->range, block->range) &&
                              statement->range.begin > block->range.begin &&
                              statement->range.end < block->range.end;
    if (!is_strictly_inside || overlaps_sibling(block, index))
        return false;
    return !ir_is_loop(statement) || !begins_in_macro(c, statement);
}

/* Does the last part of a statement (for instance a loop's body) own its bytes? */
static bool owns_bytes_at_end(const converter *c, const ir_node *parent, unsigned index) {
    const ir_node *body = parent->children[index];
    if (index + 1 != parent->child_count || body->range.end != parent->range.end ||
        !is_inside(body->range, parent->range) || overlaps_sibling(parent, index))
        return false;
    if (!begins_in_macro(c, body))
        return true;
    return !ir_is_loop(body) && follows_parenthesis(c, body);
}

static bool visit(ir_node *node, void *context) {
    const converter *c = context;
    bool is_own = !(node->flags & IR_FROM_MACRO);
    bool is_controlling = ir_is_loop(node) || node->kind == IR_IF || node->kind == IR_SWITCH ||
                          node->kind == IR_LABEL || node->kind == IR_CASE ||
                          node->kind == IR_DEFAULT;
    for (unsigned i = 0; is_own && i < node->child_count; i++) {
        ir_node *child = node->children[i];
        if (ir_is_expression(child) || !(child->flags & IR_FROM_MACRO))
            continue;
        if (node->kind == IR_BLOCK ? owns_bytes_in_block(c, node, i)
                                   : is_controlling && owns_bytes_at_end(c, node, i))
            child->flags &= ~(unsigned)IR_FROM_MACRO;
    }
    return true;
}

void find_own_bytes(converter *c, ir_node *body) {
    ir_walk(body, visit, c);
}
