/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/loop_exits.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/expression.h"
#include "analysis/base/library.h"
#include "analysis/base/open_loop.h"
#include "analysis/base/stateful.h"

/* ---- assertions ------------------------------------------------------------------------------ */

static bool is_failure(const ir_node *node) {
    while (node && node->kind == IR_CAST)
        node = ir_child(node, 0);
    return node && node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
           node->children[0]->function->is_noreturn &&
           strncmp(node->children[0]->function->name, "__assert", 8) == 0;
}

static const ir_node *only_statement(const ir_node *block) {
    while (block && (block->kind == IR_BLOCK || block->kind == IR_EXPRESSION) &&
           block->child_count == 1)
        block = block->children[0];
    return block;
}

/* The condition c if the node is c ? (void)0 : fail() or ({ if (c) ; else fail(); }), or one of
 * these after sizeof(...) and a comma. NULL if it has another form. */
const ir_node *assertion_condition(const ir_node *node) {
    while (node &&
           (node->kind == IR_CAST || (node->kind == IR_BINARY && node->op == IR_OP_COMMA &&
                                      (node->children[0]->kind == IR_SIZEOF ||
                                       (node->children[0]->kind == IR_CAST &&
                                        node->children[0]->children[0]->kind == IR_SIZEOF)))))
        node = node->children[node->child_count - 1];
    if (!node)
        return NULL;
    if (node->kind == IR_CONDITIONAL)
        return is_failure(node->children[2]) && !ir_has_effect(node->children[1])
                   ? node->children[0]
                   : NULL;
    if (!ir_is_statement_expression(node))
        return NULL;
    const ir_node *inner = only_statement(node->children[0]);
    return inner && inner->kind == IR_IF && inner->child_count == 3 &&
                   inner->children[1]->kind == IR_EMPTY &&
                   is_failure(only_statement(inner->children[2]))
               ? inner->children[0]
               : NULL;
}

/* ---- branches that leave --------------------------------------------------------------------- */

static bool ends_program(const ir_node *node) {
    return node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
           node->children[0]->function->is_noreturn;
}

static bool always_leaves(const ir_node *node, bool break_leaves) {
    switch (node->kind) {
    case IR_RETURN:
    case IR_GOTO:
        return true;
    case IR_BREAK:
        return break_leaves;
    case IR_EXPRESSION:
        return ends_program(node->children[0]);
    case IR_BLOCK:
        return node->child_count > 0 &&
               always_leaves(node->children[node->child_count - 1], break_leaves);
    default:
        return false;
    }
}

/* May the loop continue after a branch that contains this node, or may a jump from outside enter
 * the branch? */
static bool may_continue(const ir_node *node) {
    return node->kind == IR_CONTINUE || node->kind == IR_LABEL || node->kind == IR_CASE ||
           node->kind == IR_DEFAULT || node->kind == IR_BREAK;
}

static bool branch_leaves(const ir_node *branch, bool break_leaves) {
    if (!always_leaves(branch, break_leaves))
        return false;
    if (branch->kind != IR_BLOCK)
        return true;
    for (unsigned i = 0; i + 1 < branch->child_count; i++)
        if (ir_any(branch->children[i], may_continue))
            return false;
    return true;
}

/* ---- conditions ------------------------------------------------------------------------------ */

bool loop_exits_cannot_evaluate(const ir_node *node) {
    const ir_node *written = expression_written(node);
    if (written)
        return written->kind != IR_VARIABLE || !variable_is_automatic(written->variable);
    return node->kind == IR_OPAQUE;
}

/* ---- branches with messages ------------------------------------------------------------------ */

enum { DEEPEST_MESSAGE = 4 }; /* greatest depth of nested calls that are searched */

/* Does a library function of this name print, allocate or keep state? */
static bool is_stateful(const ir_function *function) {
    char name[LIBRARY_NAME_SIZE];
    const char *effect = library_plain_name(function->name, name) ? stateful_effect(name) : NULL;
    return effect && strncmp(effect, "writes memory", 13) != 0;
}

/* Does the node write an element or a member, not of a local variable? */
static bool writes_memory(const ir_node *node) {
    const ir_node *written = expression_written(node);
    const ir_variable *root = written ? ir_root_variable(written) : NULL;
    return written && written->kind != IR_VARIABLE &&
           !(root && variable_is_automatic(root) && root->type->kind == IR_ARRAY);
}

/* Does the statement print or keep state, itself or in functions that it calls? A function that
 * updates elements is not called for its messages. The branches of
 * inner `if` statements in the loop's own text are not searched here; find_exits examines them
 * separately. */
static bool has_message(const ir_node *node, unsigned depth) {
    if (node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION) {
        const ir_function *function = node->children[0]->function;
        if (function->body ? depth < DEEPEST_MESSAGE && !ir_any(function->body, writes_memory) &&
                                 has_message(function->body, depth + 1)
                           : is_stateful(function))
            return true;
    }
    const unsigned count = node->kind == IR_IF && depth == 0 ? 1 : node->child_count;
    for (unsigned i = 0; i < count; i++)
        if (has_message(node->children[i], depth))
            return true;
    return false;
}

static bool is_with_message(const ir_node *statement, const ir_node *branch) {
    return !ir_any(statement->children[0], loop_exits_cannot_evaluate) && has_message(branch, 0) &&
           !ir_may_be_entered(branch);
}

static bool leaves_function(const ir_node *node) {
    return node->kind == IR_RETURN || node->kind == IR_GOTO;
}

static bool is_check(const ir_node *node) {
    return node->kind == IR_IF &&
           (has_message(node->children[1], 0) || ir_any(node->children[1], ends_program));
}

bool loop_exits_ends_program(const ir_node *node) {
    return node->kind == IR_IF && branch_leaves(node->children[1], false) &&
           !ir_any(node->children[1], leaves_function);
}

bool loop_exits_has_check(const ir_node *body) {
    return ir_any(body, is_check);
}

/* ---- exits of the loop ---------------------------------------------------------------------- */

typedef struct search {
    arena *memory;
    loop_exits *found;
    bool is_over; /* set if there are too many exits, or if one cannot be removed */
} search;

static unsigned last_id(const ir_node *node) {
    while (node->child_count)
        node = node->children[node->child_count - 1];
    return node->id;
}

/* Can the statement's bytes be replaced? Not if other statements, from the same macro call, share
 * its range. */
static bool has_own_bytes(const ir_node *statement) {
    const ir_node *block = statement->parent;
    if (statement->range.begin >= statement->range.end || block->flags & IR_FROM_MACRO)
        return false;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *other = block->children[i];
        if (other != statement && other->range.begin < statement->range.end &&
            statement->range.begin < other->range.end)
            return false;
    }
    return true;
}

/* Can the branch's bytes be replaced, so that the condition before it stays? */
static bool has_branch_of_own_bytes(const ir_node *statement, const ir_node *condition) {
    const ir_range *branch = &statement->children[1]->range;
    return condition->range.end <= branch->begin && branch->begin < branch->end &&
           branch->end <= statement->range.end;
}

/* Can the other branch be the one that leaves? Its condition, !c, needs the type of c. */
static bool is_truth_value(const ir_node *node) {
    return (node->kind == IR_BINARY && node->op >= IR_OP_LESS && node->op <= IR_OP_OR) ||
           (node->kind == IR_UNARY && node->op == IR_OP_NOT);
}

/* The negation of an `if` statement's condition. */
static const ir_node *negated(arena *a, const ir_node *tested) {
    ir_node *opposite = ir_new(a, IR_UNARY, tested->type, 1);
    opposite->op = IR_OP_NOT;
    opposite->range = tested->range;
    opposite->flags = tested->flags & (IR_FROM_MACRO | IR_FROM_CALL);
    opposite->id = tested->id;
    opposite->children[0] = (ir_node *)tested;
    return opposite;
}

/* Adds the exit. `otherwise` is the statement's branch that stays. */
static void add(search *s, ir_node *statement, const ir_node *tested, bool is_negated,
                ir_node *otherwise, bool is_message) {
    loop_exits *found = s->found;
    const bool is_other = otherwise && otherwise == statement->children[1];
    const ir_node *condition = is_other ? negated(s->memory, tested) : tested;
    const bool is_kept = !expression_is_plain(condition); /* a call may write variables, too */
    const bool is_shared =
        otherwise || statement->flags & IR_FROM_CALL || !has_own_bytes(statement) ||
        (is_kept && !is_negated && !has_branch_of_own_bytes(statement, condition));
    if (found->count == LOOP_MOST_EXITS || ir_any(condition, loop_exits_cannot_evaluate) ||
        statement->parent->kind != IR_BLOCK || (is_kept && is_negated)) {
        s->is_over = true;
        return;
    }
    ir_node *rest = ir_new(s->memory, IR_IF, NULL, otherwise ? 3 : 2);
    ir_node *end = ir_new(s->memory, IR_CONTINUE, NULL, 0);
    end->flags = IR_LEAVES;
    rest->id = statement->id;
    rest->parent = statement->parent;
    rest->range = end->range = (ir_range){statement->range.begin, statement->range.begin};
    rest->children[0] = (ir_node *)condition;
    rest->children[1] = end;
    if (otherwise)
        rest->children[2] = otherwise;
    end->parent = rest;
    end->id = last_id(tested) + 1;
    found->items[found->count++] = (loop_exit){.statement = statement,
                                               .rest = rest,
                                               .condition = condition,
                                               .tested = tested,
                                               .otherwise = otherwise,
                                               .holder = tested->parent,
                                               .parent = statement->parent,
                                               .is_negated = is_negated,
                                               .is_kept = is_kept,
                                               .is_shared = is_shared,
                                               .is_message = is_message};
}

/* The condition that the statement asserts, as an expression or as the last part of a sequence
 * whose other parts have no effect. NULL if the statement is no assertion. */
static const ir_node *asserted_by(const ir_node *statement) {
    if (statement->kind == IR_EXPRESSION)
        return assertion_condition(statement->children[0]);
    if (statement->kind == IR_OPAQUE)
        return assertion_condition(statement);
    if (statement->kind != IR_BLOCK || !(statement->flags & IR_SEQUENCE) || !statement->child_count)
        return NULL;
    for (unsigned i = 0; i + 1 < statement->child_count; i++)
        if (ir_has_effect(statement->children[i]))
            return NULL;
    return asserted_by(statement->children[statement->child_count - 1]);
}

/* Does the branch with this number leave the loop, or print? */
static bool is_exit(const ir_node *statement, unsigned number, bool break_leaves) {
    const ir_node *branch = statement->children[number];
    return (number == 1 || is_truth_value(statement->children[0])) &&
           (branch_leaves(branch, break_leaves) || is_with_message(statement, branch));
}

static void find_exits(search *s, ir_node *node, bool break_leaves) {
    const ir_node *condition = ir_is_loop(node) ? NULL : asserted_by(node);
    if (condition) {
        add(s, node, condition, true, NULL, false);
        return;
    }
    for (unsigned i = 1; node->kind == IR_IF && i < node->child_count; i++)
        if (is_exit(node, i, break_leaves)) {
            ir_node *otherwise = ir_child(node, 3 - i);
            const bool is_message = !branch_leaves(node->children[i], break_leaves);
            add(s, node, node->children[0], false, otherwise, is_message);
            if (otherwise)
                find_exits(s, otherwise, break_leaves);
            return;
        }
    if (ir_is_loop(node) || node->kind == IR_SWITCH)
        break_leaves = false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!ir_is_expression(node->children[i]))
            find_exits(s, node->children[i], break_leaves);
}

loop_exits *loop_exits_find(arena *a, const ir_node *body) {
    search s = {.memory = a, .found = ARENA_NEW(a, loop_exits)};
    find_exits(&s, (ir_node *)body, true);
    return s.is_over ? NULL : s.found;
}

static void exchange(ir_node *parent, const ir_node *old, ir_node *new) {
    for (unsigned i = 0; i < parent->child_count; i++)
        if (parent->children[i] == old)
            parent->children[i] = new;
}

void loop_exits_take_out(const loop_exits *exits) {
    if (exits)
        open_loop_limit(exits->open);
    for (unsigned i = 0; exits && i < exits->count; i++) {
        const loop_exit *it = &exits->items[i];
        assert(it->parent && it->rest && it->statement->parent == it->parent);
        exchange(it->parent, it->statement, it->rest);
        it->statement->parent = NULL;
        ((ir_node *)it->tested)->parent = (ir_node *)it->condition;
        ((ir_node *)it->condition)->parent = it->rest;
        if (it->otherwise)
            it->otherwise->parent = it->rest;
    }
}

void loop_exits_put_back(const loop_exits *exits) {
    for (unsigned i = 0; exits && i < exits->count; i++) {
        const loop_exit *it = &exits->items[i];
        assert(it->rest->parent == it->parent);
        exchange(it->parent, it->rest, it->statement);
        it->statement->parent = it->parent;
        ((ir_node *)it->tested)->parent = it->holder;
        if (it->otherwise)
            it->otherwise->parent = it->statement;
    }
    if (exits)
        open_loop_restore(exits->open);
}

void loop_exits_hide(const loop_exits *exits, bool are_hidden) {
    for (unsigned i = 0; exits && i < exits->count; i++) {
        const loop_exit *it = &exits->items[i];
        ir_node *rest = it->rest;
        if (it->is_kept) {
            rest->children[1]->kind = are_hidden ? IR_BLOCK : IR_CONTINUE;
            continue;
        }
        assert(rest->kind == (are_hidden ? IR_IF : IR_BLOCK));
        rest->kind = are_hidden ? IR_BLOCK : IR_IF;
        rest->child_count = it->otherwise ? 1 : 0;
        rest->children[0] = it->otherwise;
        if (!are_hidden) {
            rest->children[0] = (ir_node *)it->condition;
            rest->child_count = it->otherwise ? 3 : 2;
        }
    }
}

bool loop_exits_mention(const loop_exits *exits, const ir_variable *variable) {
    for (unsigned i = 0; exits && i < exits->count; i++) {
        const ir_node *statement = exits->items[i].statement;
        for (unsigned n = 1; statement->kind == IR_IF && n < statement->child_count; n++)
            if (expression_mentions(statement->children[n], variable))
                return true;
    }
    return false;
}

const loop_exit *loop_exit_at(const loop_exits *exits, const ir_node *statement) {
    for (unsigned i = 0; exits && i < exits->count; i++)
        if (exits->items[i].rest == statement)
            return &exits->items[i];
    return NULL;
}
