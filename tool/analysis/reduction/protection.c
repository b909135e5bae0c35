/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A loop under `parallel for` may be executed in sequential order, because a team of one thread
 * would do so. OpenMP 4.5 (2.5.1, 2.7.1) leaves open which thread executes which iterations, and
 * when. Only clauses make the loop differ from the same loop without directives:
 * - A private variable begins without a value, or with a copy, and the original keeps its value
 *   (openmp_keeps_value). It must therefore be a local variable that is reached only by its name: a
 *   pointer would lead to the original.
 * - A reduced variable is a copy that begins with the identity element. The result is the same if
 *   nothing in the loop reads the variable and all updates use the clause's operator. */
#include "analysis/reduction/protection.h"

#include <string.h>

#include "analysis/base/expression.h"
#include "analysis/base/loop_text.h"
#include "analysis/base/openmp_loop.h"
#include "analysis/reduction/team_loop.h"

static const char *message(const loop_analysis *j, const char *format, const char *name) {
    return arena_format(j->an->memory, format, name);
}

/* ---- what is updated ----------------------------------------------------------------------- */

static bool is_of_update(const reduction_update *update, const ir_node *node) {
    const ir_node *last = update->last ? update->last : update->statement;
    return node->id >= update->statement->id && node->id <= expression_last_id(last);
}

static const ir_variable *base_of(const loop_analysis *j, const reduction_update *update) {
    const ir_node *base = j->arrays.items[update->array].array.base;
    return base->kind == IR_VARIABLE ? base->variable : NULL;
}

static bool is_updated_at(const loop_analysis *j, const ir_variable *variable,
                          const ir_node *node) {
    for (unsigned i = 0; i < j->updates.count; i++)
        if (base_of(j, &j->updates.items[i]) == variable &&
            is_of_update(&j->updates.items[i], node))
            return true;
    for (unsigned i = 0; i < j->scalars.count; i++)
        if (j->scalars.items[i].variable == variable &&
            ir_contains(j->scalars.items[i].statement, node))
            return true;
    return false;
}

/* Does the variable occur in the loop only in its updates, and does no called function read it? */
static bool occurs_in_updates_only(const loop_analysis *j, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++)
        if (ir_contains(j->loop, fact->occurrences.items[i]) &&
            !is_updated_at(j, variable, fact->occurrences.items[i]))
            return false;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *a = &j->accesses[i];
        if (a->class == CLASS_SHARED && a->access.lvalue && a->access.lvalue->kind != IR_VARIABLE &&
            ir_root_variable(a->access.lvalue) == variable)
            return false;
    }
    return true;
}

static bool occurs(const loop_analysis *j, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(j->an->facts, variable);
    for (unsigned i = 0; i < fact->occurrences.count; i++)
        if (ir_contains(j->loop, fact->occurrences.items[i]))
            return true;
    return false;
}

static reduction_operator operator_of(const scalar_update *scalar) {
    switch (scalar->op) {
    case IR_OP_ADD:
    case IR_OP_SUBTRACT:
        return REDUCTION_SUM;
    case IR_OP_MULTIPLY:
        return REDUCTION_PRODUCT;
    case IR_OP_BIT_AND:
        return REDUCTION_AND;
    case IR_OP_BIT_OR:
        return REDUCTION_OR;
    case IR_OP_BIT_XOR:
        return REDUCTION_XOR;
    case IR_OP_LESS:
    case IR_OP_LESS_EQUAL:
        return scalar->is_negated || scalar->place ? REDUCTION_NONE : REDUCTION_MINIMUM;
    case IR_OP_GREATER:
    case IR_OP_GREATER_EQUAL:
        return scalar->is_negated || scalar->place ? REDUCTION_NONE : REDUCTION_MAXIMUM;
    default:
        return REDUCTION_NONE;
    }
}

/* ---- clauses ------------------------------------------------------------------------------- */

static const char *check_reduction(const loop_analysis *j, const openmp_item *item,
                                   const ir_variable *variable, bool *protects) {
    static const char *const other = "reduction of '%s', of which the loop does something else";
    unsigned found = 0;
    for (unsigned i = 0; i < j->arrays.count; i++) {
        const reduction_array *array = &j->arrays.items[i].array;
        if (array->base->kind != IR_VARIABLE || array->base->variable != variable)
            continue;
        if (array->op != item->op || array->order_is_kept)
            return message(j, other, item->text);
        *protects = true;
        found++;
    }
    for (unsigned i = 0; i < j->scalars.count; i++) {
        if (j->scalars.items[i].variable != variable)
            continue;
        if (operator_of(&j->scalars.items[i]) != item->op)
            return message(j, other, item->text);
        found++;
    }
    return found && occurs_in_updates_only(j, variable) ? NULL : message(j, other, item->text);
}

/* Does the loop accumulate into the variable, or into a part of it? */
static bool is_accumulated(const loop_analysis *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->scalars.count; i++) {
        const ir_node *target = j->scalars.items[i].target;
        if (j->scalars.items[i].variable == variable ||
            (target && ir_root_variable(target) == variable))
            return true;
    }
    for (unsigned i = 0; i < j->arrays.count; i++)
        if (ir_root_variable(j->arrays.items[i].array.base) == variable &&
            variable->type->kind != IR_POINTER)
            return true;
    return false;
}

static const char *check_private(const loop_analysis *j, const openmp_item *item,
                                 const ir_variable *variable) {
    if (!occurs(j, variable))
        return NULL;
    if (!variable_is_automatic(variable) || variable->function != j->function ||
        variable->has_other_name || variable_escapes(j->an->facts, variable))
        return message(j, "'%s' is private, and may be reached by other means than its name",
                       item->text);
    if (ir_type_is_variably_modified(variable->type) || variable->type->is_volatile ||
        variable->type->is_atomic ||
        (variable->type->kind == IR_ARRAY && item->kind != OPENMP_PRIVATE))
        return message(j, "'%s' is private, with a type of which no copy is made", item->text);
    if (is_accumulated(j, variable))
        return message(j, "'%s' is private, and accumulated in", item->text);
    return NULL;
}

/* Generated code copies the clause's expression, so all names in it must be variables. Returns the
 * problem, or NULL. */
static const char *check_expression(const loop_analysis *j, const openmp_item *item) {
    size_t length;
    for (const char *at = openmp_token(item->text, &length); length > 0;
         at = openmp_token(at + length, &length)) {
        const char *name = arena_copy(j->an->memory, at, length);
        if (openmp_is_name(item->text, at) &&
            !openmp_variable(j->an->unit, j->loop, j->function, name))
            return message(j, "a clause with '%s', which is no variable", name);
    }
    return NULL;
}

static const char *check_item(const loop_analysis *j, const openmp_item *item, bool *protects) {
    if (item->kind == OPENMP_IF || item->kind == OPENMP_NUM_THREADS)
        return check_expression(j, item);
    if (item->kind > OPENMP_REDUCTION)
        return NULL;
    const ir_variable *variable = openmp_variable(j->an->unit, j->loop, j->function, item->text);
    if (!variable)
        return message(j, "a clause with '%s', which is no variable", item->text);
    return item->kind == OPENMP_REDUCTION ? check_reduction(j, item, variable, protects)
                                          : check_private(j, item, variable);
}

/* ---- atomic and critical ------------------------------------------------------------------- */

/* The outermost statement that begins at `place`; NULL if there is none. */
static const ir_node *statement_at(const ir_node *node, uint32_t place) {
    if (node->kind >= IR_BLOCK && node->range.begin == place)
        return node;
    const ir_node *found = NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = statement_at(node->children[i], place);
    return found;
}

static const char *check_lock(const loop_analysis *j, const ir_directive *d,
                              openmp_construct construct, bool *protects) {
    const source *text = j->an->unit->source;
    const ir_node *statement =
        statement_at(j->loop, source_skip_blanks(text, d->range.end, j->loop->range.end));
    bool found = false;
    for (unsigned i = 0; statement && i < j->updates.count; i++) {
        const reduction_update *update = &j->updates.items[i];
        const bool is_it = construct == OPENMP_CRITICAL ? ir_contains(statement, update->statement)
                                                        : statement == update->statement;
        found |= is_it;
        *protects |= is_it;
    }
    for (unsigned i = 0; statement && i < j->scalars.count; i++)
        found |= construct == OPENMP_CRITICAL
                     ? ir_contains(statement, j->scalars.items[i].statement)
                     : statement == j->scalars.items[i].statement;
    return found ? NULL : message(j, "'%s', which protects no update", d->text);
}

static const char *check_locks(const loop_analysis *j, bool *protects) {
    const ir_unit *unit = j->an->unit;
    const char *why = NULL;
    for (unsigned i = loop_text_first_directive(unit, j->loop->range.begin);
         i < unit->directive_count && unit->directives[i].range.begin < j->loop->range.end && !why;
         i++) {
        const ir_directive *d = &unit->directives[i];
        if (!d->is_skipped && directive_is_openmp_pragma(d))
            why = check_lock(j, d, openmp_read(j->an->memory, unit, d).construct, protects);
    }
    return why;
}

/* ---- `for` --------------------------------------------------------------------------------- */

/* Checks an `omp for`. redcc lets one thread of the team execute the loop, or lets all threads
 * execute it with the variables of one of them. Returns the problem, or NULL. */
static const char *check_team(const loop_analysis *j, const openmp_loop *openmp) {
    const openmp_directive directive = {OPENMP_FOR, openmp->item_count, openmp->items, NULL};
    team_facts facts;
    const char *why =
        team_of_loop(j->an, j->function, j->loop, &directive, j->counted.counter, &facts);
    if (why)
        return why;
    if (openmp_knows_thread(&directive, j->function->body))
        return "its schedule fixes the threads, and the function asks for their numbers";
    if (facts.reduced)
        return message(j, "the region around it reduces '%s'", facts.reduced);
    return facts.names_all ? "the region around it has a 'default' other than shared" : NULL;
}

reason check_protection(const loop_analysis *j) {
    const openmp_loop *openmp = j->an->unit->dialect.replaces_openmp ? j->an->openmp : NULL;
    if (!openmp)
        return (reason){0};
    bool protects = false;
    const char *why = check_locks(j, &protects);
    for (unsigned i = 0; i < openmp->item_count && !why; i++)
        why = check_item(j, &openmp->items[i], &protects);
    if (!why && openmp->is_of_team)
        why = check_team(j, openmp);
    if (!why && !protects)
        why = "no array is protected by 'atomic', 'critical' or 'reduction'";
    return why ? analysis_reason(j, REASON_EXISTING_OPENMP, j->loop, why) : (reason){0};
}
