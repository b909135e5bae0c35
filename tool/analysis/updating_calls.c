/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/updating_calls.h"

#include "analysis/base/expandable_call.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/loop/conflict.h"

typedef struct listing {
    loop_search *search;
    unsigned from; /* number of the function's first verdict */
    const ir_node *loop;
    bool is_shared; /* a call updates an element that iterations of the loop share */
} listing;

/* Does the access write a single element, and not one of a local variable? If the function contains
 * a loop, the caller must also be able to name the element. */
static bool is_update(const listing *l, const access *a) {
    if (a->kind == ACCESS_READ || !a->lvalue || a->loop_count ||
        (!a->is_exact && ir_any(a->callee->body, ir_is_loop)))
        return false;
    const ir_variable *object = location_of(l->search->an->facts, a->lvalue, l->loop).object;
    return !object || !variable_is_automatic(object);
}

/* Does an inner loop of the function update elements? */
static bool updates_in_loop(const access_list *list) {
    for (unsigned i = 0; i < list->items.count; i++)
        if (list->items.items[i].kind == ACCESS_UPDATE)
            return true;
    return false;
}

/* Is a scalar of the caller written, which the call gets by address? */
static bool writes_local(const access_list *list) {
    for (unsigned i = 0; i < list->items.count; i++) {
        const access *a = &list->items.items[i];
        const ir_node *target = a->kind == ACCESS_READ ? NULL : a->lvalue;
        if (target && target->kind == IR_UNARY && target->op == IR_OP_DEREFERENCE &&
            ir_is_address_of(target->children[0]))
            target = target->children[0]->children[0];
        if (target && target->kind == IR_VARIABLE && variable_is_automatic(target->variable) &&
            ir_type_is_scalar(target->type))
            return true;
    }
    return false;
}

/* Does the argument only read, so that the order in which arguments are evaluated does not matter?
 */
static bool only_reads(const listing *l, const ir_node *argument) {
    access_list list = {0};
    access_collect(l->search->an->effects, argument, &list);
    bool is_fine = list.problems.count == 0 && list.ends.count == 0;
    for (unsigned i = 0; i < list.items.count; i++)
        is_fine &= list.items.items[i].kind == ACCESS_READ;
    return is_fine;
}

/* Is the loop refused for this reason? */
static bool is_refused_for(const listing *l, reason_id why) {
    const loop_search *s = l->search;
    for (unsigned i = l->from; i < s->verdicts.count; i++)
        if (s->verdicts.items[i].loop == l->loop && s->verdicts.items[i].kind == VERDICT_REFUSE)
            return s->verdicts.items[i].why.id == why;
    return false;
}

/* May a check in a called function be why the loop is refused? A loop without a verdict, around a
 * loop that is refused, may be refused for it, too. */
static bool is_refused_for_check(const listing *l) {
    const loop_search *s = l->search;
    bool is_around = false;
    for (unsigned i = l->from; i < s->verdicts.count; i++) {
        const loop_verdict *verdict = &s->verdicts.items[i];
        if (verdict->loop == l->loop)
            return is_refused_for(l, REASON_IMPURE_CALL) || is_refused_for(l, REASON_NO_RETURN);
        is_around |= verdict->kind == VERDICT_REFUSE && ir_contains(l->loop, verdict->loop);
    }
    return is_around;
}

/* Would the body in place of the call help: does it update an element, check something, or set a
 * variable? */
static bool is_wanted(listing *l, const ir_node *call) {
    const analyser *an = l->search->an;
    access_list list = {0};
    const ir_function *function = ir_called_function(call);
    if (!function || !function->body)
        return false;
    access_collect_known(an->effects, call, &list);
    bool is_found = (loop_exits_has_check(function->body) && is_refused_for_check(l)) ||
                    (writes_local(&list) && is_refused_for(l, REASON_SCALAR_CARRIED)) ||
                    (updates_in_loop(&list) && is_refused_for(l, REASON_CALLEE_UPDATES));
    l->is_shared |= is_found;
    for (unsigned i = 0; i < list.items.count; i++)
        if (is_update(l, &list.items.items[i])) {
            is_found = true;
            l->is_shared |= conflict_at(an->facts, l->loop, list.items.items[i].lvalue, call) ==
                            CONFLICT_SHARED;
        }
    for (unsigned i = 1; i < call->child_count && is_found; i++)
        is_found = only_reads(l, call->children[i]);
    return is_found;
}

static bool is_written(const listing *l, const ir_node *node) {
    const loop_search *s = l->search;
    for (unsigned i = l->from; i < s->verdicts.count; i++)
        if (verdict_is_written(&s->verdicts.items[i]) && s->verdicts.items[i].loop == node)
            return true;
    return false;
}

static void list_below(listing *l, const ir_node *node) {
    const ir_node *statement = expression_place(node);
    if (statement && statement->kind == IR_DECLARATOR)
        statement = statement->parent;
    if (is_written(l, node))
        return;
    /* A call in another one's argument is not the one that would be expanded. */
    if (node->kind == IR_CALL && statement && call_in_statement(statement) == node &&
        is_wanted(l, node))
        VECTOR_PUSH(l->search->an->memory, l->search->calls,
                    ((updating_call){l->search->function, (ir_node *)statement}));
    for (unsigned i = 0; i < node->child_count; i++)
        list_below(l, node->children[i]);
}

static void search_loops(listing *l, const ir_node *node) {
    const unsigned before = l->search->calls->count;
    if (is_written(l, node))
        return;
    if (ir_is_loop(node)) {
        l->loop = node;
        list_below(l, node);
        if (l->is_shared) {
            l->is_shared = false;
            return;
        }
        l->search->calls->count = before;
    }
    for (unsigned i = 0; i < node->child_count; i++)
        search_loops(l, node->children[i]);
}

void list_updating_calls(loop_search *s, unsigned from) {
    listing l = {.search = s, .from = from};
    search_loops(&l, s->function->body);
}
