/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In-order binning executes the body before what it reads is compared with what the loop writes,
 * and perhaps more than once. Where the two overlap it reads values that are not yet the sequential
 * loop's: stale ones. Its results are thrown away then, but until that is known they must do no
 * harm. They must not decide an address, an integer division, how often a loop inside iterates, or
 * whether something is evaluated that the sequential loop might not evaluate.
 *
 * What depends on stale values is found by going through the body until nothing new is: variables,
 * not values, are marked.
 */
#include "analysis/base/expression.h"
#include "emit/loop.h"
#include "emit/syntax.h"

enum { DEEPEST_CALL = 6 };

typedef struct staleness {
    const loop_text *loop;
    bool *is_stale;                  /* by variable: it may hold a stale value */
    bool changed;                    /* in this pass */
    bool is_harmful;                 /* what was found */
    bool in_callee;                  /* then all memory is stale */
    unsigned depth;                  /* of calls */
    VECTOR(const ir_node *) certain; /* expressions that each iteration evaluates */
} staleness;

/** How control comes to a node. */
typedef struct control {
    bool is_stale;   /* it depends on stale values */
    bool is_certain; /* in each iteration */
} control;

/* ---- what is stale ------------------------------------------------------------------------- */

static bool is_stale(const staleness *s, const ir_node *node);

static bool any_child_is_stale(const staleness *s, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_stale(s, node->children[i]))
            return true;
    return false;
}

/** Is it, or a part that it begins with, read as something that may overlap a reduction array? */
static bool hangs_on_guarded(const staleness *s, const ir_node *path, bool is_whole) {
    const loop_facts *facts = s->loop->facts;
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        if (read->needs_guard && (!read->base || syntax_same(path, read->row) ||
                                  (!is_whole && syntax_same(path, read->base))))
            return true;
    }
    return path->child_count > 0 && path->kind != IR_CALL &&
           hangs_on_guarded(s, path->children[0], false);
}

static bool is_captured(const staleness *s, const ir_variable *variable) {
    for (unsigned i = 0; i < s->loop->facts->variables.captured_count; i++)
        if (s->loop->facts->variables.captured[i] == variable)
            return true;
    return false;
}

/** A pointer that the iteration has computed: where it leads is not looked for. */
static bool begins_with_private_pointer(const staleness *s, const ir_node *path) {
    const ir_variable *root = ir_root_variable(path);
    return !root || (root->type->kind == IR_POINTER && !is_captured(s, root));
}

static bool is_access(const ir_node *node) {
    return node->kind == IR_INDEX || node->kind == IR_MEMBER ||
           (node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE);
}

/** Not where only an address is meant. */
static bool reads_memory(const ir_node *node) {
    return is_access(node) && node->type && node->type->kind != IR_ARRAY;
}

static bool is_address_of(const ir_node *node) {
    return node->kind == IR_UNARY && node->op == IR_OP_ADDRESS;
}

static bool is_address_like(const ir_type *type) {
    return !type || type->kind == IR_POINTER || type->kind == IR_ARRAY || type->kind == IR_RECORD;
}

static const ir_function *callee_of(const ir_node *call) {
    return call->children[0]->kind == IR_FUNCTION ? call->children[0]->function : NULL;
}

static bool call_is_stale(const staleness *s, const ir_node *call) {
    const ir_function *callee = callee_of(call);
    if (!callee || callee->body)
        return true;
    for (unsigned i = 1; i < call->child_count; i++)
        if (is_address_like(call->children[i]->type) || is_stale(s, call->children[i]))
            return true;
    return false;
}

static bool variable_is_stale(const staleness *s, const ir_node *node) {
    const ir_variable *variable = node->variable;
    if (s->is_stale[variable->id])
        return true;
    if (variable->storage == IR_LOCAL || variable->storage == IR_PARAMETER)
        return variable->address_taken && !is_captured(s, variable);
    return s->in_callee || hangs_on_guarded(s, node, true);
}

/** Of an object only the address: what it is computed from. */
static bool address_is_stale(const staleness *s, const ir_node *object) {
    if (object->kind == IR_VARIABLE)
        return false;
    if (!is_access(object))
        return is_stale(s, object);
    const ir_node *first = object->children[0];
    const bool is_inside = first->type && first->type->kind != IR_POINTER;
    return (is_inside ? address_is_stale(s, first) : is_stale(s, first)) ||
           (object->kind == IR_INDEX && is_stale(s, object->children[1]));
}

static bool is_stale(const staleness *s, const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return variable_is_stale(s, node);
    if (node->kind == IR_OPAQUE)
        return true;
    if (node->kind == IR_CALL)
        return call_is_stale(s, node);
    if (is_address_of(node))
        return address_is_stale(s, node->children[0]);
    if (is_access(node) && !reads_memory(node))
        return address_is_stale(s, node);
    if (reads_memory(node) &&
        (s->in_callee || hangs_on_guarded(s, node, true) || begins_with_private_pointer(s, node)))
        return true;
    return any_child_is_stale(s, node);
}

/* ---- marking ------------------------------------------------------------------------------- */

/** What is written through a pointer is no variable's, or of one whose address was taken. */
static void mark(staleness *s, const ir_node *lvalue) {
    const ir_variable *root = ir_root_variable(lvalue);
    const bool is_behind = root && root->type->kind == IR_POINTER && lvalue->kind != IR_VARIABLE;
    if (root && !is_behind && !s->is_stale[root->id]) {
        s->is_stale[root->id] = true;
        s->changed = true;
    }
}

/** What a call may write to through its arguments. What a pointer leads to is not a variable's. */
static void mark_arguments(staleness *s, const ir_node *call) {
    for (unsigned i = 1; i < call->child_count; i++) {
        const ir_node *argument = call->children[i];
        if ((is_address_of(argument) || (argument->type && argument->type->kind == IR_ARRAY)) &&
            call_is_stale(s, call))
            mark(s, is_address_of(argument) ? argument->children[0] : argument);
    }
}

static bool condition_is_stale(const staleness *s, const ir_node *node) {
    switch (node->kind) {
    case IR_IF:
    case IR_CONDITIONAL:
    case IR_SWITCH:
    case IR_WHILE:
        return is_stale(s, node->children[0]);
    case IR_FOR:
    case IR_DO:
        return node->children[1]->kind != IR_EMPTY && is_stale(s, node->children[1]);
    case IR_BINARY:
        return (node->op == IR_OP_AND || node->op == IR_OP_OR) && is_stale(s, node->children[0]);
    default:
        return false;
    }
}

static void spread(staleness *s, const ir_node *node, bool control_is_stale) {
    const ir_node *written = expression_written(node);
    if (written && (control_is_stale || is_stale(s, node->children[node->child_count - 1])))
        mark(s, written);
    if (node->kind == IR_DECLARATOR && node->child_count > 0 && is_stale(s, node->children[0]) &&
        !s->is_stale[node->variable->id])
        s->is_stale[node->variable->id] = s->changed = true;
    if (node->kind == IR_CALL)
        mark_arguments(s, node);
    const bool below = control_is_stale || condition_is_stale(s, node);
    for (unsigned i = 0; i < node->child_count; i++)
        spread(s, node->children[i], below);
}

static void spread_all(staleness *s, const ir_node *body) {
    do {
        s->changed = false;
        spread(s, body, false);
    } while (s->changed);
}

/* ---- what does harm ------------------------------------------------------------------------ */

static void check(staleness *s, const ir_node *node, control how);

static bool is_evaluated_anyway(const staleness *s, const ir_node *node) {
    for (unsigned i = 0; i < s->certain.count; i++)
        if (syntax_same(s->certain.items[i], node))
            return true;
    return false;
}

/** The inspector reads the subscripts of such an update in each iteration as well. */
static bool is_subscript_of_bare_update(const staleness *s, const ir_node *node) {
    const loop_facts *facts = s->loop->facts;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(facts->updates[i].target, node))
            return is_bare(facts, facts->updates[i].statement);
    return false;
}

static void check_access(staleness *s, const ir_node *node, control how) {
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        const bool is_address = child->type && child->type->kind == IR_POINTER;
        const bool is_subscript = node->kind == IR_INDEX && i == 1;
        s->is_harmful |= (is_address || is_subscript) && is_stale(s, child);
    }
    if (!reads_memory(node) || (node->parent && is_address_of(node->parent)))
        return;
    if (how.is_certain)
        VECTOR_PUSH(s->loop->arena, &s->certain, node);
    else if (how.is_stale)
        s->is_harmful |= !is_evaluated_anyway(s, node) && !is_subscript_of_bare_update(s, node);
}

static bool is_division(const ir_node *node) {
    return (node->kind == IR_BINARY || node->kind == IR_ASSIGN) &&
           (node->op == IR_OP_DIVIDE || node->op == IR_OP_REMAINDER) && node->type &&
           node->type->kind == IR_INTEGER;
}

static void check_division(staleness *s, const ir_node *node, control how) {
    const ir_node *divisor = node->children[1];
    const bool is_safe =
        (divisor->flags & IR_HAS_VALUE) && divisor->value != 0 && divisor->value != -1;
    s->is_harmful |= !is_safe && (how.is_stale || any_child_is_stale(s, node));
}

/** In the callee all memory is stale; of its parameters those with stale arguments. */
static void check_callee(staleness *s, const ir_node *call) {
    const ir_function *callee = call->children[0]->function;
    const unsigned count = callee->parameter_count;
    if (s->depth == DEEPEST_CALL || callee->is_variadic || call->child_count != count + 1) {
        s->is_harmful = true;
        return;
    }
    staleness inner = {.loop = s->loop,
                       .is_stale =
                           ARENA_ARRAY(s->loop->arena, bool, s->loop->unit->variable_count + 1),
                       .in_callee = true,
                       .depth = s->depth + 1};
    for (unsigned i = 0; i < count; i++)
        inner.is_stale[callee->parameters[i]->id] =
            callee->parameters[i]->type->kind != IR_POINTER && is_stale(s, call->children[i + 1]);
    spread_all(&inner, callee->body);
    check(&inner, callee->body, (control){false, false});
    s->is_harmful |= inner.is_harmful;
}

/** A function that is not seen: of the system's, on numbers, any will do; others may do what they
 *  like with what is stale. */
static bool is_harmless_unseen(const staleness *s, const ir_node *call, control how) {
    const bool is_known = callee_of(call)->is_from_system;
    for (unsigned i = 1; i < call->child_count; i++)
        if (is_address_like(call->children[i]->type) ||
            (!is_known && is_stale(s, call->children[i])))
            return false;
    return is_known || !how.is_stale;
}

static void check_call(staleness *s, const ir_node *call, control how) {
    const ir_function *callee = callee_of(call);
    if (!callee || (how.is_stale && callee->body)) {
        s->is_harmful = true;
        return;
    }
    for (unsigned i = 1; i < call->child_count; i++)
        s->is_harmful |= call->children[i]->type && call->children[i]->type->kind == IR_POINTER &&
                         is_stale(s, call->children[i]);
    if (callee->body)
        check_callee(s, call);
    else
        s->is_harmful |= !is_harmless_unseen(s, call, how);
}

static bool is_jump(const ir_node *node) {
    return node->kind == IR_BREAK || node->kind == IR_CONTINUE || node->kind == IR_RETURN ||
           node->kind == IR_GOTO;
}

/** How control comes to the parts of a node: `first` is evaluated with it. */
static control control_below(const staleness *s, const ir_node *node, control how, bool first) {
    const bool decides =
        node->kind == IR_IF || node->kind == IR_CONDITIONAL || node->kind == IR_SWITCH ||
        ir_is_loop(node) ||
        (node->kind == IR_BINARY && (node->op == IR_OP_AND || node->op == IR_OP_OR));
    if (!decides || (first && node->kind != IR_DO))
        return how;
    return (control){how.is_stale || condition_is_stale(s, node), false};
}

static void check(staleness *s, const ir_node *node, control how) {
    if (ir_is_loop(node))
        s->is_harmful |= condition_is_stale(s, node);
    if (is_access(node))
        check_access(s, node, how);
    else if (is_division(node))
        check_division(s, node, how);
    else if (node->kind == IR_CALL)
        check_call(s, node, how);
    else if (node->kind == IR_OPAQUE || (is_jump(node) && how.is_stale) ||
             (node->kind == IR_DECLARATOR && node->variable->type->size < 0))
        s->is_harmful = true;
    for (unsigned i = 0; i < node->child_count && !s->is_harmful; i++)
        check(s, node->children[i], control_below(s, node, how, i == 0));
}

/** A jump may pass by what stands below it: nothing is certain then. */
static bool holds_jump(const ir_node *node) {
    if (is_jump(node))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (holds_jump(node->children[i]))
            return true;
    return false;
}

bool is_harmless_when_stale(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    bool needs_guard = false;
    for (unsigned i = 0; i < facts->source_count; i++)
        needs_guard |= facts->sources[i].needs_guard;
    if (!needs_guard)
        return true;
    staleness s = {.loop = loop,
                   .is_stale = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1)};
    const ir_node *body = facts->counted.body;
    spread_all(&s, body);
    check(&s, body, (control){false, !holds_jump(body)});
    return !s.is_harmful;
}
