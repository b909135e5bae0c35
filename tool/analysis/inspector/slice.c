/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The slice contains every statement of the body that may assign a needed variable, the control
 * structure around it, and in turn what these need.
 *
 * It records whether it contains floating-point arithmetic. The inspector must compute exactly the
 * executor's subscripts, and two copies of the same text do so only if the compiler rounds each
 * operation separately (docs/decisions/0003).
 *
 * Conditions that only decide whether an address is touched are kept if they can be computed
 * without floating-point values. Otherwise they are left out, provided that the address may be
 * computed unconditionally. */
#include "analysis/inspector/slice.h"

#include "analysis/loop/place.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/exact.h"
#include "analysis/base/expression.h"
#include "analysis/base/step_inside.h"
#include "analysis/base/stepped.h"
#include "analysis/loop/own.h"
#include "analysis/reduction/forward.h"

/* A variable, or one field of a record variable. */
typedef struct needed_part {
    const ir_variable *variable;
    const ir_field *field; /* NULL for the whole variable */
} needed_part;

typedef struct slicer {
    const loop_analysis *j;
    unsigned touch_count;
    const slice_touch *touches;
    bool *keep;
    VECTOR(needed_part) needed;
    uint64_t own;         /* a set of bits: the indices of own elements whose values are needed */
    bool is_integer_only; /* floating-point values are not permitted in the current attempt */
    bool has_floating_work;
    const ir_node *obstacle;
} slicer;

static void need_expression(slicer *s, const ir_node *node);
static void keep_statement(slicer *s, const ir_node *statement, const ir_variable *of);

static void fail(slicer *s, const ir_node *node) {
    if (!s->obstacle)
        s->obstacle = node;
}

/* ---- control --------------------------------------------------------------------------------- */

/* Keeps the jumps that leave a loop or switch. Jumps that end an iteration are handled by
 * keep_continues. */
static void keep_breaks(slicer *s, const ir_node *node) {
    if (node->kind == IR_BREAK)
        keep_statement(s, node, NULL);
    if (ir_is_loop(node) || node->kind == IR_SWITCH)
        return;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!ir_is_expression(node->children[i]))
            keep_breaks(s, node->children[i]);
}

static void keep_header_declaration(slicer *s, const ir_node *part) {
    if (part->kind != IR_DECLARATION)
        return;
    s->keep[part->id] = true;
    for (unsigned i = 0; i < part->child_count; i++)
        s->keep[part->children[i]->id] = true;
}

static void keep_control(slicer *s, const ir_node *node) {
    assert(node->id < s->j->function->node_count && !ir_is_expression(node));
    if (s->keep[node->id])
        return;
    s->keep[node->id] = true;
    switch (node->kind) {
    case IR_IF:
        need_expression(s, node->children[0]);
        break;
    case IR_SWITCH:
        need_expression(s, node->children[0]);
        keep_breaks(s, node->children[1]);
        break;
    case IR_WHILE:
        need_expression(s, node->children[0]);
        keep_breaks(s, node->children[1]);
        break;
    case IR_DO:
        need_expression(s, node->children[1]);
        keep_breaks(s, node->children[0]);
        break;
    case IR_FOR:
        for (unsigned i = 0; i < 3; i++)
            if (node->children[i]->kind != IR_EMPTY)
                need_expression(s, node->children[i]);
        keep_header_declaration(s, node->children[0]);
        keep_breaks(s, node->children[3]);
        break;
    default:
        break;
    }
}

static bool is_declared_in(const slicer *s, const ir_variable *variable, const ir_node *node) {
    const ir_node *declarator = variable_fact_of(s->j->an->facts, variable)->declarator;
    return variable->storage == IR_LOCAL && declarator && ir_contains(node, declarator);
}

/* Keeps the control structure around a kept node, up to the loop's body. `of` is the variable whose
 * value needs the node, or NULL. Two kinds of `if` do not affect this value and are left out: an
 * `if` around the block that declares `of`, and any `if` when `of` is named only in loops over
 * constants that count it. The node that needs the value is inside the same block or loop. The
 * conditions around that node are kept, or it is safe without them. */
static void keep_around(slicer *s, const ir_node *node, const ir_variable *of) {
    for (const ir_node *outer = node->parent; outer && outer != s->j->loop; outer = outer->parent)
        if (outer->kind != IR_IF || !of ||
            (!is_declared_in(s, of, outer) && !counted_constant_sets(s->j->counted.body, of)))
            keep_control(s, outer);
}

/* ---- data ------------------------------------------------------------------------------------ */

static bool is_of_iteration(const slicer *s, const ir_variable *variable) {
    if (variable == s->j->counted.counter)
        return false;
    for (unsigned i = 0; i < s->j->privates.count; i++)
        if (s->j->privates.items[i].variable == variable)
            return true;
    const ir_node *declarator = variable_fact_of(s->j->an->facts, variable)->declarator;
    return declarator && ir_contains(s->j->loop, declarator);
}

/* How a variable in memory is used. Values stored through pointers are followed only into arrays
 * that do not escape (keep_stores_into). */
typedef enum use_kind { USE_IN_PLACE, USE_BY_CALL, USE_UNKNOWN } use_kind;

static use_kind use_kind_of(const ir_node *node) {
    const ir_node *parent = node->parent;
    while (parent && ((parent->kind == IR_INDEX && parent->children[0] == node && node->type &&
                       node->type->kind == IR_ARRAY) ||
                      (parent->kind == IR_MEMBER && !(parent->flags & IR_ARROW)))) {
        node = parent;
        parent = node->parent;
    }
    bool is_address = node->type && node->type->kind == IR_ARRAY;
    if (parent && parent->kind == IR_UNARY && parent->op == IR_OP_ADDRESS) {
        parent = parent->parent;
        is_address = true;
    }
    if (!is_address)
        return USE_IN_PLACE;
    return parent && parent->kind == IR_CALL ? USE_BY_CALL : USE_UNKNOWN;
}

static bool is_in_memory(const ir_variable *variable) {
    return variable->address_taken || !ir_type_is_scalar(variable->type);
}

/* The field of the variable that this occurrence uses, as in v.f or v.f[1]; NULL if it is the whole
 * variable. */
static const ir_field *part_of(const ir_node *use) {
    const ir_node *parent = use->parent;
    if (parent && parent->kind == IR_MEMBER && !(parent->flags & IR_ARROW) && use->type &&
        use->type->kind == IR_RECORD && use->type->record && !use->type->record->is_union)
        return parent->field;
    return NULL;
}

/* The variable's occurrence at the start of the written path; NULL if the path does not start at a
 * variable. */
static const ir_node *bottom_of(const ir_node *write) {
    const ir_node *node = expression_written(write);
    if (write->kind == IR_UNARY && write->op == IR_OP_ADDRESS)
        node = write->children[0];
    while (node && node->kind != IR_VARIABLE)
        node = node->child_count ? node->children[0] : NULL;
    return node;
}

static bool concerns(const ir_field *needed, const ir_field *written) {
    return !needed || !written || needed == written;
}

/* Adds the part to the needed ones. Returns whether it was among them already. */
static bool note_part(slicer *s, needed_part part) {
    for (unsigned i = 0; i < s->needed.count; i++)
        if (s->needed.items[i].variable == part.variable &&
            (!s->needed.items[i].field || s->needed.items[i].field == part.field))
            return true;
    VECTOR_PUSH(s->j->an->memory, &s->needed, part);
    return false;
}

static bool is_in_update(const slicer *s, const ir_node *node) {
    for (unsigned i = 0; i < s->j->updates.count; i++)
        if (!s->j->updates.items[i].last && ir_contains(s->j->updates.items[i].statement, node))
            return true;
    return false;
}

/* Keeps statements that may store to the array through pointers. Since the array does not escape,
 * the location of such a store is either the array or entirely unknown. */
static void keep_stores_into(slicer *s, const ir_variable *array) {
    for (unsigned i = 0; i < s->j->access_count; i++) {
        const loop_access *a = &s->j->accesses[i];
        const bool is_unknown = !a->access.lvalue || (!a->where.object && !a->where.pointer);
        if (a->access.kind != ACCESS_READ && (is_unknown || a->where.object == array))
            keep_statement(s, expression_place(a->access.node), NULL);
    }
}

static void need_part(slicer *s, needed_part part) {
    const ir_variable *variable = part.variable;
    if (!is_of_iteration(s, variable) || note_part(s, part))
        return;
    const ir_node *loop = s->j->loop;
    const variable_fact *fact = variable_fact_of(s->j->an->facts, variable);
    if (fact->declarator && ir_contains(loop, fact->declarator))
        keep_statement(s, fact->declarator, variable);
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        const ir_node *bottom = bottom_of(write);
        if (is_step_afterwards(write) && is_in_update(s, write))
            continue; /* the step is the variable's last use in the iteration (updates.c) */
        if (ir_contains(s->j->counted.body, write) &&
            concerns(part.field, bottom ? part_of(bottom) : NULL))
            keep_statement(s, expression_place(write), variable);
    }
    for (unsigned i = 0; is_in_memory(variable) && i < fact->occurrences.count; i++) {
        const ir_node *use = fact->occurrences.items[i];
        if (!ir_contains(loop, use) || !concerns(part.field, part_of(use)))
            continue;
        const use_kind kind = use_kind_of(use);
        if (kind == USE_UNKNOWN && variable->type->kind == IR_ARRAY &&
            !variable_escapes(s->j->an->facts, variable))
            keep_stores_into(s, variable);
        else if (kind == USE_UNKNOWN)
            fail(s, use);
        else if (kind == USE_BY_CALL)
            keep_statement(s, expression_place(use), NULL);
    }
}

/* Does the operation give the same bits in another copy of the text? Only if it is rounded
 * separately: types with extended precision are excluded, because the compiler may round them
 * differently in each copy. */
static bool is_repeatable(const slicer *s, const ir_node *node) {
    return !s->is_integer_only && node->type && node->type->kind == IR_FLOATING &&
           node->type->size <= 8 && !s->j->function->has_other_attributes &&
           !unit_text_has_own_options(s->j->an->text);
}

static void need_floating_work(slicer *s, const ir_node *node, bool is_possible) {
    if (is_possible)
        s->has_floating_work = true;
    else
        fail(s, node);
}

static void need_call(slicer *s, const ir_node *call) {
    access_list list = {0};
    access_collect(s->j->an->effects, call, &list);
    if (list.problems.count || (list.has_unrepeatable_work && list.has_floating_work))
        fail(s, call);
    else if (list.has_floating_work)
        need_floating_work(s, call,
                           !s->is_integer_only && !unit_text_has_own_options(s->j->an->text));
}

/* Does the node write memory that is not private to the iteration? Only the executor may write
 * that. */
static bool writes_shared(const slicer *s, const ir_node *node) {
    if (node->kind != IR_CALL && !expression_written(node))
        return false;
    for (unsigned i = 0; i < s->j->access_count; i++) {
        const loop_access *a = &s->j->accesses[i];
        if (a->access.kind != ACCESS_READ && a->class != CLASS_SCALAR &&
            ir_contains(node, a->access.node))
            return true;
    }
    return false;
}

/* Keeps the statements that compute the stored value and the store's condition. The memory of the
 * element is not needed. */
static void need_forward(slicer *s, const forwarded_store *store) {
    if (s->keep[store->statement->id])
        return;
    s->keep[store->statement->id] = true;
    need_expression(s, store->value);
    keep_around(s, store->statement, NULL);
}

/* Keeps the statements that store to the own element, as for a variable. */
static void need_own(slicer *s, unsigned number) {
    const uint64_t bit = (uint64_t)1 << number;
    if (s->own & bit)
        return;
    s->own |= bit;
    for (unsigned i = 0; i < s->j->access_count; i++) {
        const access *a = &s->j->accesses[i].access;
        if (a->kind != ACCESS_READ && a->lvalue && own_named(s->j, a->lvalue) == (int)number)
            keep_statement(s, expression_place(a->node), NULL);
    }
}

static void need_expression(slicer *s, const ir_node *node) {
    const int own = own_named(s->j, node);
    if (own >= 0) {
        if (s->is_integer_only && node->type->kind == IR_FLOATING)
            fail(s, node);
        need_own(s, (unsigned)own);
        return;
    }
    const int forward = forward_read(s->j, node);
    if (forward >= 0) {
        need_forward(s, &s->j->forwards.items[forward]);
        return;
    }
    if (s->is_integer_only && node->type && node->type->kind == IR_FLOATING)
        fail(s, node); /* it is data that the next execution may find changed */
    if (expression_is_floating_work(node))
        need_floating_work(s, node, is_repeatable(s, node));
    if (writes_shared(s, node))
        fail(s, node);
    if (node->kind == IR_CALL)
        need_call(s, node);
    if (node->kind == IR_VARIABLE)
        need_part(s, (needed_part){node->variable, part_of(node)});
    for (unsigned i = 0; i < node->child_count && !s->obstacle; i++)
        need_expression(s, node->children[i]);
}

/* Keeps a simple statement, declarator or jump; or a control statement, if its header contains the
 * write. `of` is the variable whose value needs the statement (keep_around); NULL if all effects
 * are needed. */
static void keep_statement(slicer *s, const ir_node *statement, const ir_variable *of) {
    if (!statement || s->obstacle)
        return;
    bool is_new = !s->keep[statement->id];
    if (is_new && (statement->kind == IR_EXPRESSION || statement->kind == IR_DECLARATOR)) {
        s->keep[statement->id] = true;
        for (unsigned i = 0; i < statement->child_count; i++)
            need_expression(s, statement->children[i]);
    } else if (is_new) {
        keep_control(s, statement);
    }
    keep_around(s, statement, of);
}

/* ---- control that only decides whether an address is touched --------------------------------- */

typedef struct snapshot {
    bool *keep;
    unsigned needed;
    uint64_t own;
    bool has_floating_work;
} snapshot;

static snapshot take_snapshot(const slicer *s) {
    unsigned count = s->j->function->node_count;
    snapshot before = {ARENA_ARRAY(s->j->an->memory, bool, count + 1), s->needed.count, s->own,
                       s->has_floating_work};
    memcpy(before.keep, s->keep, sizeof(bool) * count);
    return before;
}

/* Keeps a control statement. If that is impossible, restores the state and returns false. */
static bool try_to_keep(slicer *s, const ir_node *node, bool is_integer_only) {
    if (s->keep[node->id])
        return true;
    if (s->obstacle)
        return false;
    snapshot before = take_snapshot(s);
    s->is_integer_only = is_integer_only;
    keep_statement(s, node, NULL);
    s->is_integer_only = false;
    if (!s->obstacle)
        return true;
    memcpy(s->keep, before.keep, sizeof(bool) * s->j->function->node_count);
    s->needed.count = before.needed;
    s->own = before.own;
    s->has_floating_work = before.has_floating_work;
    s->obstacle = NULL;
    return false;
}

static bool has_own_condition(const ir_node *node) {
    return node->kind == IR_IF || node->kind == IR_SWITCH || ir_is_loop(node);
}

/* In iterations that do not read the row, may its address be far from the other rows, as for
 * `x[t - 1]` where t is 0? Such an address would extend the range over almost all memory, so
 * evaluating the read's condition is worth some work. */
static bool is_wild(const slicer *s, const ir_node *node) {
    const ir_variable *counter = s->j->counted.counter;
    if (node->type && node->type->kind == IR_INTEGER)
        return exact_may_wrap(node, counter) && exact_may_fall_below(node, counter);
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_wild(s, node->children[i]))
            return true;
    return false;
}

/* Does the statement change only variables that are declared in `scope`? True if `scope` is NULL.
 */
static bool changes_only(const slicer *s, const ir_node *node, const ir_node *scope) {
    if (!scope)
        return true;
    const ir_node *target = expression_written(node);
    const ir_variable *root = target ? ir_root_variable(target) : NULL;
    if (target && (!root || root->type->kind == IR_POINTER || !is_declared_in(s, root, scope)))
        return target->kind == IR_VARIABLE && root && is_declared_in(s, root, scope);
    for (unsigned i = 0; i < node->child_count; i++)
        if (!changes_only(s, node->children[i], scope))
            return false;
    return true;
}

/* May the slice execute the kept parts of this statement where the program does not execute it? */
static bool is_safe_to_enter(const slicer *s, const ir_node *node, const ir_node *scope) {
    const ir_variable *counter;
    int64_t first, last;
    switch (node->kind) {
    case IR_EXPRESSION:
    case IR_DECLARATOR:
        return slice_is_safe_here(s->j, node, false) && changes_only(s, node, scope);
    case IR_BREAK: /* the break would leave a loop too early */
        return false;
    case IR_IF:
        return slice_is_safe_here(s->j, node->children[0], false);
    default:
        return !has_own_condition(node) || (counted_constant(node, &counter, &first, &last) &&
                                            ((changes_only(s, node->children[0], scope) &&
                                              changes_only(s, node->children[2], scope)) ||
                                             counted_constant_sets(s->j->counted.body, counter)));
    }
}

/* Is it safe to execute all kept parts below `node` that follow `from`? */
static bool is_safe_after(const slicer *s, const ir_node *node, const ir_node *from,
                          const ir_node *scope) {
    if (node->id > from->id && s->keep[node->id] && !is_safe_to_enter(s, node, scope))
        return false;
    const bool is_header = node->kind == IR_FOR && node->id > from->id && s->keep[node->id];
    if (node->kind == IR_EXPRESSION || node->kind == IR_DECLARATOR)
        return true;
    for (unsigned i = is_header ? 3 : 0; i < node->child_count; i++)
        if (!ir_is_expression(node->children[i]) &&
            !is_safe_after(s, node->children[i], from, scope))
            return false;
    return true;
}

/* ---- loops over blocks ------------------------------------------------------------------------
 * An innermost loop over consecutive rows, inside another loop of the iteration, is recorded as a
 * whole (loop/spans.c). A condition for touching a single row is not worth evaluating there, and
 * the reads in it determine no subscripts. */

static ir_node *loop_around(const slicer *s, const ir_node *node) {
    ir_node *outer = node->parent;
    while (outer != s->j->loop && !ir_is_loop(outer))
        outer = outer->parent;
    return outer != s->j->loop ? outer : NULL;
}

static bool is_in_block(const slicer *s, const ir_node *node) {
    ir_node *const loop = loop_around(s, node);
    loop_span span;
    if (!loop || !loop_around(s, loop) || !span_recognise(loop, &span) || span.counted.step != 1)
        return false;
    for (unsigned i = 0; i < s->touch_count; i++)
        if (ir_contains(span.counted.body, s->touches[i].place) &&
            (s->touches[i].loop_count || !span_is_recorded(&span, s->touches[i].row) ||
             !slice_is_safe_here(s->j, s->touches[i].row, true)))
            return false;
    /* no read in the loop may be one of the compared sources */
    for (unsigned i = 0; i < s->j->sources.count; i++)
        if (s->j->sources.items[i].is_subscript && s->j->sources.items[i].place &&
            ir_contains(span.counted.body, s->j->sources.items[i].place))
            return false;
    return true;
}

static void keep_for_touch(slicer *s, const slice_touch *touch) {
    const bool is_safe = slice_is_safe_here(s->j, touch->row, true) &&
                         slice_loops_are_constant(touch->loop_count, touch->loops);
    const bool is_wanted = !is_safe || is_wild(s, touch->row);
    const ir_variable *counter;
    int64_t first, last;
    for (const ir_node *outer = touch->place->parent; outer && outer != s->j->loop && !s->obstacle;
         outer = outer->parent) {
        if (!has_own_condition(outer)) {
            s->keep[outer->id] |= outer->kind == IR_CASE || outer->kind == IR_DEFAULT;
            continue;
        }
        /* a loop around an invariant address is not needed, because recording the address once is
         * enough */
        if (ir_is_loop(outer) && !s->keep[outer->id] &&
            (is_safe || counted_constant(outer, &counter, &first, &last)))
            continue;
        const bool can_enter = is_safe && is_safe_after(s, outer, outer, outer);
        if (can_enter && !is_wanted && outer->kind == IR_IF && is_in_block(s, outer))
            continue;
        if (try_to_keep(s, outer, true))
            continue;
        if ((is_wanted || !can_enter) && !try_to_keep(s, outer, false) && !can_enter)
            fail(s, outer);
    }
    for (const ir_node *outer = touch->place->parent; outer && outer != s->j->loop;
         outer = outer->parent)
        if (outer->kind == IR_BLOCK)
            s->keep[outer->id] = true;
}

/* ---- continue -------------------------------------------------------------------------------- */

/* May this `continue` be left out of the slice? Only if the rest of the iteration may be executed
 * nevertheless. */
static bool is_safe_without(const slicer *s, const ir_node *loop, const ir_node *jump,
                            unsigned touch_count, const slice_touch *touches) {
    const ir_node *body =
        loop == s->j->loop ? s->j->counted.body : loop->children[loop->child_count - 1];
    if (loop->kind == IR_DO)
        body = loop->children[0];
    for (unsigned i = 0; i < touch_count; i++)
        if (touches[i].place->id > jump->id && ir_contains(body, touches[i].place) &&
            (!slice_is_safe_here(s->j, touches[i].row, true) ||
             !slice_loops_are_constant(touches[i].loop_count, touches[i].loops)))
            return false;
    return is_safe_after(s, body, jump, loop == s->j->loop ? NULL : body);
}

/* Does the `continue` skip code that may end the loop or the program? */
static bool skips_exit(const slicer *s, const ir_node *loop, const ir_node *jump) {
    const loop_exits *exits = s->j->left_out.exits;
    for (unsigned i = 0; exits && i < exits->count; i++)
        if (exits->items[i].rest->id > jump->id && ir_contains(loop, exits->items[i].rest))
            return true;
    for (unsigned i = 0; exits && i < s->j->found.ends.count; i++)
        if (s->j->found.ends.items[i]->id > jump->id &&
            ir_contains(loop, s->j->found.ends.items[i]))
            return true;
    return false;
}

static void keep_continues(slicer *s, const ir_node *loop, const ir_node *node,
                           unsigned touch_count, const slice_touch *touches) {
    const bool is_free = node->kind == IR_CONTINUE && !skips_exit(s, loop, node) &&
                         is_in_block(s, node) &&
                         is_safe_without(s, loop, node, touch_count, touches);
    if (node->kind == IR_CONTINUE && !is_free && !try_to_keep(s, node, true) &&
        (skips_exit(s, loop, node) || !is_safe_without(s, loop, node, touch_count, touches)) &&
        !try_to_keep(s, node, false))
        fail(s, node);
    if (ir_is_loop(node) && !s->keep[node->id])
        return;
    if (ir_is_loop(node))
        loop = node;
    for (unsigned i = 0; i < node->child_count && !s->obstacle; i++)
        if (!ir_is_expression(node->children[i]))
            keep_continues(s, loop, node->children[i], touch_count, touches);
}

static unsigned kept_count(const slicer *s) {
    const unsigned last = expression_last_id(s->j->loop);
    unsigned count = 0;
    for (unsigned i = s->j->loop->id; i <= last; i++)
        count += s->keep[i];
    return count;
}

static void need_touch(slicer *s, const slice_touch *touch) {
    need_expression(s, touch->row);
    for (unsigned i = 0; i < touch->loop_count && !s->obstacle; i++) {
        need_expression(s, touch->loops[i].lower);
        need_expression(s, touch->loops[i].bound);
    }
}

/* Keeps the conditions by which an iteration leaves the loop or ends the program. They are computed
 * exactly, and only in iterations that reach them. */
static void keep_exits(slicer *s) {
    const loop_exits *exits = s->j->left_out.exits;
    for (unsigned i = 0; exits && i < exits->count && !s->obstacle; i++)
        keep_statement(s, exits->items[i].rest, NULL);
    for (unsigned i = 0; exits && i < s->j->found.ends.count && !s->obstacle; i++)
        if (ir_contains(s->j->counted.body, s->j->found.ends.items[i]))
            keep_statement(s, expression_place(s->j->found.ends.items[i]), NULL);
}

slice slice_compute(const loop_analysis *j, unsigned touch_count, const slice_touch *touches) {
    slicer s = {.j = j,
                .touch_count = touch_count,
                .touches = touches,
                .keep = ARENA_ARRAY(j->an->memory, bool, j->function->node_count + 1)};
    assert(j->counted.body && (touches || touch_count == 0));
    for (unsigned i = 0; i < touch_count && !s.obstacle; i++)
        need_touch(&s, &touches[i]);
    unsigned before = 0;
    keep_exits(&s);
    do {
        before = kept_count(&s);
        for (unsigned i = 0; i < touch_count && !s.obstacle; i++)
            keep_for_touch(&s, &touches[i]);
        keep_continues(&s, j->loop, j->counted.body, touch_count, touches);
    } while (!s.obstacle && kept_count(&s) != before);
    if (j->counted.body->kind == IR_BLOCK)
        s.keep[j->counted.body->id] = true;
    const ir_variable **needed =
        ARENA_ARRAY(j->an->memory, const ir_variable *, s.needed.count + 1);
    for (unsigned i = 0; i < s.needed.count; i++)
        needed[i] = s.needed.items[i].variable;
    return (slice){s.keep, s.needed.count, needed, s.own, s.has_floating_work, s.obstacle};
}
