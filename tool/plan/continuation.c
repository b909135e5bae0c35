/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/continuation.h"

#include "analysis/base/loop_exits.h"

static bool is_from_macro(const ir_node *node) {
    return node->flags & IR_FROM_MACRO;
}

/* ---- the first clause ------------------------------------------------------------------------ */

/* Does the header spell the expression, in text that only this expression comes from? */
static bool is_spelled_in_header(const loop_facts *facts, const ir_node *expression) {
    const ir_range range = expression->range, body = facts->counted.body->range;
    return facts->loop->range.begin < range.begin && range.begin < range.end &&
           range.end < body.begin && !ir_any(expression, is_from_macro);
}

/* The number of the variable, if it is stepped; otherwise CONTINUED_CLAUSE. */
static int number_of(const loop_facts *facts, const ir_variable *variable) {
    if (variable == facts->counted.counter)
        return CONTINUED_COUNTER;
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].variable == variable)
            return facts->variables.privates[i].is_stepped ? (int)i : CONTINUED_CLAUSE;
    return CONTINUED_CLAUSE;
}

/* The initialisers of the counter and of stepped variables. Others are repeated: the variable is
 * written before it is read, or is the bound. */
static bool parts_of_declaration(const loop_facts *facts, const ir_node *declaration,
                                 continued_part parts[MOST_CONTINUED], unsigned *count) {
    for (unsigned i = 0; i < declaration->child_count; i++) {
        const ir_node *declarator = declaration->children[i];
        if (declarator->kind != IR_DECLARATOR || !declarator->child_count)
            return false;
        const ir_node *value = declarator->children[0];
        const int number = number_of(facts, declarator->variable);
        if (number == CONTINUED_CLAUSE)
            continue;
        if (*count == MOST_CONTINUED || value->kind == IR_INITIALIZERS ||
            !is_spelled_in_header(facts, value))
            return false;
        parts[(*count)++] = (continued_part){value->range, number};
    }
    return true;
}

bool continued_parts(const loop_facts *facts, continued_part parts[MOST_CONTINUED],
                     unsigned *count) {
    *count = 0;
    if (facts->loop->kind != IR_FOR)
        return true;
    const ir_node *first = facts->loop->children[0];
    if (first->kind == IR_EMPTY)
        return true;
    if (first->kind == IR_DECLARATION)
        return parts_of_declaration(facts, first, parts, count);
    if (first->kind == IR_EXPRESSION)
        first = first->children[0];
    parts[(*count)++] = (continued_part){first->range, CONTINUED_CLAUSE};
    return is_spelled_in_header(facts, first) && !facts->counted.bound_variable;
}

/* ---- variables ------------------------------------------------------------------------------- */

/* Is the variable's value after each iteration known to the branches of the exits? */
static bool is_known_at_exits(const loop_facts *facts, const private_variable *item) {
    return item->is_declared_inside || item->is_stepped || item->is_live_after ||
           item->is_conditional_live_out || !loop_exits_mention(facts->slice.exits, item->variable);
}

static bool may_leave(const loop_exits *exits) {
    for (unsigned i = 0; exits && i < exits->count; i++)
        if (!exits->items[i].is_message)
            return true;
    return false;
}

bool may_continue_at_exits(const loop_facts *facts) {
    continued_part parts[MOST_CONTINUED];
    unsigned count;
    if (!may_leave(facts->slice.exits) || facts->variables.openmp || !facts->inspector.exists ||
        facts->counted.body->range.begin <= facts->loop->range.begin)
        return false;
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (!is_known_at_exits(facts, &facts->variables.privates[i]))
            return false;
    return continued_parts(facts, parts, &count);
}
