/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Backward liveness of one variable, asked forward: what is the first thing that may be done with
 * it on the ways from the end of the loop? Structured control only; a label anywhere in the
 * function makes every other occurrence count.
 */
#include "analysis/private/live.h"

#include "analysis/base/expression.h"

typedef enum first_use {
    USE_NONE, /* some way leads past without a use, none reads */
    USE_READ, /* some way reads it */
    USE_WRITE /* every way writes all of it first (or ends the function) */
} first_use;

typedef struct search {
    const ir_variable *variable;
    const ir_node *loop; /* the analysed one: its body reads nothing of before it */
    bool may_jump;       /* a break or continue was met: later writes may be jumped over */
} search;

static first_use use_of(search *s, const ir_node *node);

static first_use in_sequence(first_use first, first_use second) {
    return first == USE_NONE ? second : first;
}

static first_use either(first_use a, first_use b) {
    if (a == USE_READ || b == USE_READ)
        return USE_READ;
    return a == USE_WRITE && b == USE_WRITE ? USE_WRITE : USE_NONE;
}

static first_use optional(first_use use) {
    return use == USE_WRITE ? USE_NONE : use;
}

static first_use use_of_children(search *s, const ir_node *node, unsigned from) {
    first_use use = USE_NONE;
    for (unsigned i = from; i < node->child_count && use == USE_NONE; i++)
        use = use_of(s, node->children[i]);
    return use;
}

static first_use written(const search *s) {
    return s->may_jump ? USE_NONE : USE_WRITE;
}

static first_use use_of_assignment(search *s, const ir_node *node) {
    const ir_node *target = node->children[0];
    bool is_whole =
        node->op == IR_OP_NONE && target->kind == IR_VARIABLE && target->variable == s->variable;
    if (!is_whole)
        return use_of_children(s, node, 0);
    return in_sequence(use_of(s, node->children[1]), written(s));
}

static first_use use_of_loop(search *s, const ir_node *node) {
    bool outer_jump = s->may_jump;
    first_use use;
    if (node == s->loop && node->kind == IR_FOR)
        return in_sequence(use_of(s, node->children[0]), use_of(s, node->children[1]));
    if (node->kind == IR_FOR) {
        use = in_sequence(use_of(s, node->children[0]), use_of(s, node->children[1]));
        first_use body = in_sequence(use_of(s, node->children[3]), use_of(s, node->children[2]));
        use = in_sequence(use, optional(body));
    } else if (node->kind == IR_WHILE) {
        use = in_sequence(use_of(s, node->children[0]), optional(use_of(s, node->children[1])));
    } else {
        use = in_sequence(use_of(s, node->children[0]), use_of(s, node->children[1]));
    }
    s->may_jump = outer_jump;
    return use;
}

static first_use use_of(search *s, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
        return node->variable == s->variable ? USE_READ : USE_NONE;
    case IR_DECLARATOR:
        if (node->variable == s->variable && node->child_count)
            return in_sequence(use_of(s, node->children[0]), written(s));
        return use_of_children(s, node, 0);
    case IR_ASSIGN:
        return use_of_assignment(s, node);
    case IR_CONDITIONAL:
    case IR_IF: {
        first_use use = use_of(s, node->children[0]);
        if (use != USE_NONE)
            return use;
        first_use then = use_of(s, node->children[1]);
        return either(then, node->child_count > 2 ? use_of(s, node->children[2]) : USE_NONE);
    }
    case IR_BINARY:
        if (node->op == IR_OP_AND || node->op == IR_OP_OR)
            return in_sequence(use_of(s, node->children[0]),
                               optional(use_of(s, node->children[1])));
        return use_of_children(s, node, 0);
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
        return use_of_loop(s, node);
    case IR_SWITCH: {
        bool outer_jump = s->may_jump;
        first_use use =
            in_sequence(use_of(s, node->children[0]), optional(use_of(s, node->children[1])));
        s->may_jump = outer_jump;
        return use;
    }
    case IR_BREAK:
    case IR_CONTINUE:
        s->may_jump = true;
        return USE_NONE;
    case IR_RETURN: {
        /* Later statements are reached by other ways only; taking them in is on the safe side. */
        first_use use = use_of_children(s, node, 0);
        return use;
    }
    default:
        return use_of_children(s, node, 0);
    }
}

static bool has_label(const ir_node *node) {
    if (node->kind == IR_LABEL || node->kind == IR_GOTO)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_label(node->children[i]))
            return true;
    return false;
}

static bool occurs_elsewhere(variable_facts *facts, const ir_node *loop,
                             const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++)
        if (!ir_contains(loop, fact->occurrences.items[i]))
            return true;
    return false;
}

/* Once more around an enclosing loop, from its increment and condition to the analysed loop. */
static first_use use_around(search *s, const ir_node *enclosing) {
    first_use use = USE_NONE;
    if (enclosing->kind == IR_FOR)
        use = in_sequence(use_of(s, enclosing->children[2]), use_of(s, enclosing->children[1]));
    else
        use = use_of(s, enclosing->children[enclosing->kind == IR_WHILE ? 0 : 1]);
    const ir_node *body = enclosing->children[enclosing->kind == IR_FOR     ? 3
                                              : enclosing->kind == IR_WHILE ? 1
                                                                            : 0];
    /* All of the body counts, also what stands after the analysed loop: on the safe side. */
    return in_sequence(use, use_of(s, body));
}

bool variable_is_live_after(variable_facts *facts, const ir_node *loop,
                            const ir_variable *variable) {
    /* The loop itself may be reached again, by a jump or in a loop around it. */
    search again = {variable, loop, false};
    if (!occurs_elsewhere(facts, loop, variable) && use_of(&again, loop) != USE_READ)
        return false;
    const ir_node *body = loop;
    while (body->parent)
        body = body->parent;
    if (has_label(body))
        return true;
    search s = {variable, loop, false};
    bool is_finished = false; /* the way straight on has met a write */
    for (const ir_node *node = loop; node->parent; node = node->parent) {
        const ir_node *parent = node->parent;
        bool is_sequence = parent->kind == IR_BLOCK || parent->kind == IR_DECLARATION;
        for (unsigned i = 0; is_sequence && i < parent->child_count && !is_finished; i++) {
            if (parent->children[i]->id <= node->id)
                continue;
            first_use use = use_of(&s, parent->children[i]);
            if (use == USE_READ)
                return true;
            is_finished = use == USE_WRITE;
        }
        if (parent->kind == IR_SWITCH)
            s.may_jump = false;
        if (ir_is_loop(parent)) {
            search around = {variable, loop, s.may_jump};
            if (!is_finished && use_around(&around, parent) == USE_READ)
                return true;
            /* The loop may end before or after: what follows it is asked in any case, unless it
             * was written on the straight way and no break led around that. */
            is_finished = false;
            s.may_jump = false;
        }
    }
    return false;
}
