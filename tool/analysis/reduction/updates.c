/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Classifies every write of the loop. It may be private to the iteration, a step of an induction
 * variable, an update of a scalar or of a reduction array, or a store to an own element. The loop
 * is refused at the first write that is none of these. */
#include "analysis/reduction/updates.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/loop/conflict.h"
#include "analysis/loop/own.h"
#include "analysis/memory/update_group.h"
#include "analysis/private/induction.h"
#include "analysis/reduction/extremum.h"
#include "analysis/reduction/forward.h"
#include "analysis/reduction/saturation.h"
#include "analysis/reduction/scalars.h"
#include "analysis/reduction/update_array.h"
#include "analysis/reduction/update_call.h"
#include "analysis/reduction/update_statement.h"

/* ---- private or not -------------------------------------------------------------------------- */

static private_variable *find_private(loop_analysis *j, const ir_variable *variable) {
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == variable)
            return &j->privates.items[i];
    return NULL;
}

static bool is_element(const ir_node *lvalue) {
    return lvalue->kind != IR_VARIABLE;
}

static bool is_own_object(const loop_analysis *j, const location *where) {
    return where->object && variable_is_automatic(where->object) &&
           where->object->function == j->function;
}

/* Is the variable the counter, or private? A private variable is added to the list. */
static bool take_private(loop_analysis *j, const ir_variable *variable) {
    if (variable == j->counted.counter || find_private(j, variable))
        return true;
    const bool is_in_header = analysis_header_declares(j, variable);
    const bool is_inside = analysis_declares(j, variable) && !is_in_header;
    const user_pragma *word = pragma_above(j->an->pragmas, j->loop, PRAGMA_PRIVATE);
    if (!is_inside && !pragma_names(word, variable->name) &&
        must_write_check(j->an->prover, j->counted.body, variable).verdict != PRIVATE_PROVED)
        return false;
    private_variable item = {.variable = (ir_variable *)variable,
                             .is_declared_inside = is_inside,
                             .is_declared_in_header = is_in_header};
    VECTOR_PUSH(j->an->memory, &j->privates, item);
    return true;
}

/* ---- refusing a write ------------------------------------------------------------------------ */

static bool is_updated_too(const loop_analysis *j, const loop_access *store) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (other != store && other->access.kind == ACCESS_UPDATE && !other->access.callee &&
            conflict_is_shared(j->an->facts, j->loop, other->access.lvalue) &&
            locations_overlap(&j->an->rules, &store->where, &other->where) == OVERLAP_SAME)
            return true;
    }
    return false;
}

/* Is the stored memory read as an integer? Then the store probably changes subscripts. */
static bool decides_subscripts(const loop_analysis *j, const loop_access *store) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *read = &j->accesses[i];
        if (read->access.kind != ACCESS_READ || !read->access.type ||
            read->access.type->kind != IR_INTEGER)
            continue;
        if (locations_overlap(&j->an->rules, &store->where, &read->where) == OVERLAP_SAME)
            return true;
    }
    return false;
}

/* A read of the stored memory by a statement that does not write the same element; NULL if there is
 * none. */
static const loop_access *other_read(const loop_analysis *j, const loop_access *store) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *read = &j->accesses[i];
        if (read->access.kind == ACCESS_READ && !is_read_of_own_element(j, read) &&
            locations_overlap(&j->an->rules, &store->where, &read->where) == OVERLAP_SAME)
            return read;
    }
    return NULL;
}

static bool refuse_store(loop_analysis *j, const loop_access *store) {
    const ir_node *node = store->access.node;
    const char *name = analysis_name(j, store->access.lvalue);
    if (store->access.callee)
        return analysis_refuse(j, REASON_CALLEE_UPDATES, node, store->access.callee->name);
    if (is_updated_too(j, store))
        return analysis_refuse(j, REASON_ARRAY_STORED, node, name);
    if (decides_subscripts(j, store))
        return analysis_refuse(j, REASON_INDEX_ARRAY_WRITTEN, node, name);
    const loop_access *read = other_read(j, store);
    if (read && conflict_is_shared(j->an->facts, j->loop, store->access.lvalue))
        return analysis_refuse(j, REASON_ARRAY_READ, read->access.node, name);
    return analysis_refuse(j, REASON_OTHER_STORE, node, name);
}

static bool refuse_variable(loop_analysis *j, const loop_access *store) {
    const ir_variable *variable = store->where.object;
    assert(variable && store->access.kind != ACCESS_READ);
    bool is_scalar = ir_type_is_scalar(variable->type);
    private_result result = must_write_check(j->an->prover, j->counted.body, variable);
    bool escapes = result.verdict == PRIVATE_UNKNOWN && variable_escapes(j->an->facts, variable);
    const ir_node *node = result.node ? result.node : store->access.node;
    if (escapes)
        return analysis_refuse(j, REASON_ESCAPES, node, variable->name);
    if (!is_scalar && store->access.lvalue->kind != IR_VARIABLE && !store->access.callee &&
        is_updated_too(j, store))
        return analysis_refuse(j, REASON_ARRAY_STORED, store->access.node, variable->name);
    if (is_scalar && store->access.callee) /* a sum to which a function adds, as in acc(&s, v) */
        return analysis_refuse(j, REASON_CALLEE_UPDATES, store->access.node,
                               store->access.callee->name);
    return analysis_refuse(j, is_scalar ? REASON_SCALAR_CARRIED : REASON_PRIVATE_NOT_PROVED, node,
                           variable->name);
}

/* ---- one update ------------------------------------------------------------------------------ */

static bool is_inside_node(const ir_node *outer, const ir_node *inner) {
    return inner && ir_contains(outer, inner);
}

/* Is the write a step as in h[*p++] += e, after which the iteration does not use p? Each iteration
 * then begins with its own value of p. */
static bool is_last_step(const loop_analysis *j, const ir_node *statement,
                         const loop_access *write) {
    const ir_node *step = write->access.callee ? NULL : write->access.node->parent;
    return step && statement->kind == IR_EXPRESSION && induction_is_last_step(j, statement, step);
}

/* Does the statement have effects besides the update? The owner-checked body would skip these
 * too. */
static bool has_other_effect(const loop_analysis *j, const ir_node *statement,
                             const loop_access *update) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (other == update || other->access.kind == ACCESS_READ ||
            !is_inside_node(statement, other->access.node))
            continue;
        bool is_same_element = statement->kind == IR_IF && !other->access.callee &&
                               expression_same(other->access.lvalue, update->access.lvalue);
        bool is_same_call = update->access.callee && other->access.node == update->access.node;
        if (!is_same_element && !is_same_call && !is_last_step(j, statement, other))
            return true;
    }
    return false;
}

static bool check_element(loop_analysis *j, const loop_access *update, const char *name) {
    const ir_node *target = update->access.form.target;
    const ir_node *value = update->access.form.value;
    const ir_type *type = update->access.type;
    if (update->where.has_bit_field)
        return analysis_refuse(j, REASON_BIT_FIELD, target, name);
    if (update->where.has_union)
        return analysis_refuse(j, REASON_UNION, target, name);
    if (type->is_volatile || type->is_atomic)
        return analysis_refuse(j, REASON_VOLATILE, target, name);
    if (type->kind != IR_INTEGER && type->kind != IR_FLOATING && type->kind != IR_COMPLEX &&
        type->kind != IR_BOOLEAN)
        return analysis_refuse(j, REASON_ELEMENT_TYPE, target, name);
    if (value && value->type && !ir_type_is_scalar(value->type))
        return analysis_refuse(j, REASON_ELEMENT_TYPE, target, name);
    return true;
}

/* Can the statement be enclosed in a test of ownership, without anything else being skipped? */
static bool check_place(loop_analysis *j, const loop_access *update, const ir_node *statement,
                        const char *name) {
    const ir_node *outer = statement->parent;
    if (outer && outer->kind == IR_FOR && outer->children[3] != statement)
        return analysis_refuse(j, REASON_UPDATE_IN_EXPRESSION, statement, name);
    if (has_other_effect(j, statement, update))
        return analysis_refuse(j, REASON_SIDE_EFFECT, statement, name);
    if (statement->range.begin >= statement->range.end)
        return analysis_refuse(j, REASON_NO_RANGE, statement, name);
    return true;
}

static bool check_statement(loop_analysis *j, const loop_access *update, const char *name,
                            const ir_node **statement) {
    const ir_node *assignment = update->access.form.target->parent;
    *statement = update_statement(j, update->access.form.target);
    if (ir_value_is_used(assignment))
        return analysis_refuse(j, REASON_UPDATE_VALUE_USED, assignment, name);
    if (!*statement)
        return analysis_refuse(j, REASON_UPDATE_IN_EXPRESSION, assignment, name);
    return check_place(j, update, *statement, name);
}

/* ---- does the order of the updates matter? --------------------------------------------------- */

static bool reads_itself(const loop_analysis *j, const ir_node *statement, const ir_node *target) {
    for (unsigned i = 0; i < j->access_count; i++)
        if (update_statement_reads_itself(&j->accesses[i], statement, target))
            return true;
    return false;
}

/* Does each update convert its result to a more restricted kind of number: to _Bool, from a
 * floating to an integer type, or from a complex to a real type? The order of the updates then
 * matters. */
static bool rounds_to_integer(const ir_type *type, const ir_node *value) {
    if (type->kind == IR_BOOLEAN)
        return true;
    return value && type->kind != IR_COMPLEX && value->type &&
           (value->type->kind == IR_COMPLEX ||
            (type->kind == IR_INTEGER && value->type->kind == IR_FLOATING));
}

static update_kind kind_of_update(const loop_analysis *j, const loop_access *update,
                                  const ir_node *statement) {
    const update_form *form = &update->access.form;
    if (form->has_operator && statement->kind == IR_EXPRESSION)
        return (update_kind){form->op,
                             rounds_to_integer(form->target->type, form->value) ||
                                 reads_itself(j, statement, form->target),
                             0};
    int64_t limit;
    if (saturation_of(statement, form->target, &limit))
        return (update_kind){REDUCTION_SATURATING, false, limit};
    extremum found =
        extremum_of(statement->kind == IR_EXPRESSION ? statement->children[0] : statement);
    if (found.target && found.has_operator)
        return (update_kind){found.op, !found.commutes, 0};
    return (update_kind){REDUCTION_NONE, true, 0};
}

static bool check_update(loop_analysis *j, loop_access *update) {
    const ir_node *statement;
    unsigned number;
    const ir_node *target = update->access.lvalue; /* the lvalue with v in place of each v++ */
    const char *name = analysis_name(j, target);
    if (update->where.base &&
        (is_inside_node(target, update->where.base) || update_is_by_local_pointer(j, update)))
        update->where.base = update_base_of(target, update->where.base);
    if (!check_statement(j, update, name, &statement))
        return false;
    update->access.form.target = target;
    if (!check_element(j, update, name) || !update_check_base(j, update, name))
        return false;
    update_kind kind = kind_of_update(j, update, statement);
    kind.needs_order |= update_is_by_local_pointer(j, update); /* the pointer does not point into a
                                                                * private copy */
    if (!update_array_find(j, update, kind, &number))
        return false;
    for (unsigned i = 0; i < j->access_count; i++)
        if (update_statement_reads_itself(&j->accesses[i], statement, target))
            j->accesses[i].class = CLASS_SELF;
    update_array_add(j, update, kind, statement, target, number);
    return true;
}

/* Is the target a scalar, or a row of an array of such rows? Then no two owners share its bytes. */
static bool is_whole_row(const loop_access *update) {
    const ir_node *target = update->access.lvalue;
    return ir_type_is_scalar(target->type) ||
           (target->kind == IR_INDEX && expression_same(update->where.base, target->children[0]));
}

static bool check_call(loop_analysis *j, loop_access *write) {
    unsigned number;
    const update_call found = update_call_of(j, write->access.node);
    if (!found.statement)
        return refuse_store(j, write);
    loop_access update = *write; /* describes the call as a write of the whole element or row */
    update.access.lvalue = update.access.form.target = found.target;
    update.access.form.value = NULL;
    update.access.type = ir_type_innermost(write->access.type);
    update.where = location_of(j->an->facts, found.target, j->loop);
    update.where.type = update.access.type;
    if (update.where.base && is_inside_node(found.target, update.where.base))
        update.where.base = update_base_of(found.target, update.where.base);
    const char *name = analysis_name(j, found.target);
    if (!check_place(j, &update, found.statement, name) || !check_element(j, &update, name) ||
        !update_check_base(j, &update, name))
        return false;
    if (!is_whole_row(&update))
        return refuse_store(j, write);
    const update_kind kind = {found.has_operator ? found.op : REDUCTION_NONE,
                              !found.has_operator || found.is_by_member, 0};
    if (!update_array_find(j, &update, kind, &number))
        return false;
    if (!j->updates.count || j->updates.items[j->updates.count - 1].statement != found.statement)
        update_call_mark_reads(j, &found);
    write->where = update.where;
    update_array_add(j, write, kind, found.statement, found.target, number);
    return true;
}

/* Checks an update of several statements, v = h[k]; v += e; h[k] = v. Only the thread that owns the
 * element executes these statements. */
static bool check_group(loop_analysis *j, loop_access *store, const update_group *group) {
    assert(group->first->parent == group->last->parent && group->first->id <= group->last->id);
    unsigned number;
    const ir_node *target = group->element;
    const char *name = analysis_name(j, target);
    loop_access update = *store;
    update.access.form.target = target;
    update.access.form.value = NULL;
    update.where = location_of(j->an->facts, target, j->loop);
    if (update.where.base && is_inside_node(target, update.where.base))
        update.where.base = update_base_of(target, update.where.base);
    const ir_node *statement =
        group->first->kind == IR_DECLARATION ? group->first->children[0] : group->first;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (other != store && other->access.kind != ACCESS_READ &&
            update_group_has(group, other->access.node) &&
            !(is_own_object(j, &other->where) && take_private(j, other->where.object)))
            return analysis_refuse(j, REASON_SIDE_EFFECT, other->access.node, name);
    }
    if (group->first->range.begin >= group->first->range.end ||
        group->last->range.begin >= group->last->range.end)
        return analysis_refuse(j, REASON_NO_RANGE, statement, name);
    if (!check_element(j, &update, name) || !update_check_base(j, &update, name))
        return false;
    const update_kind kind = {REDUCTION_NONE, true, 0};
    if (!update_array_find(j, &update, kind, &number))
        return false;
    for (unsigned i = 0; i < j->access_count; i++)
        if (j->accesses[i].access.node == target && j->accesses[i].access.kind == ACCESS_READ)
            j->accesses[i].class = CLASS_SELF;
    store->where = update.where;
    update_array_add(j, store, kind, statement, target, number);
    j->updates.items[j->updates.count - 1].last = group->last;
    return true;
}

static bool is_of_group(const loop_analysis *j, const loop_access *store, update_group *group) {
    return store->access.kind == ACCESS_WRITE && !store->access.callee && store->access.lvalue &&
           store->access.lvalue->parent &&
           update_group_of(j->an->facts, store->access.lvalue->parent, group);
}

/* Checks a plain store, or a write by a call or a group of statements. Stores to one element keep
 * their order, because the last one determines its value. */
static bool check_store(loop_analysis *j, loop_access *store) {
    if (store->access.callee)
        return check_call(j, store);
    update_group group;
    if (!is_element(store->access.lvalue))
        return refuse_store(j, store);
    if (is_of_group(j, store, &group) &&
        conflict_is_shared(j->an->facts, j->loop, store->access.lvalue))
        return check_group(j, store, &group);
    const bool is_scattered = store->where.base && update_table_of(j, store->where.base);
    if (other_read(j, store) && (is_scattered || !forward_take(j, store)))
        return refuse_store(j, store);
    if (check_update(j, store))
        return true;
    j->why = (reason){0};
    return refuse_store(j, store);
}

/* Accepts a step of a secondary induction variable (induction_take) that another statement reads.
 * Returns false if no other statement reads it, because its steps may then be updates of a scalar
 * sum. */
static bool take_induction(loop_analysis *j, const loop_access *write) {
    const ir_variable *variable = write->where.object;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *read = &j->accesses[i];
        if (read->access.kind == ACCESS_READ && read->where.object == variable &&
            !ir_contains(expression_place(write->access.node), read->access.node))
            return induction_take(j, variable);
    }
    return false;
}

static bool is_own_scalar(const loop_analysis *j, const location *where) {
    return is_own_object(j, where) && ir_type_is_scalar(where->object->type);
}

/* Does the write go to an element of an array, which is the variable itself or a member of a
 * record? */
static bool is_in_array(const loop_access *write) {
    const ir_variable *object = write->where.object;
    const ir_node *base = write->where.base;
    if (object->type->kind != IR_RECORD || !base)
        return object->type->kind == IR_ARRAY;
    base = update_base_of(write->access.lvalue, base);
    return base->kind == IR_MEMBER && base->type->kind == IR_ARRAY;
}

static bool is_irregular_call(const loop_analysis *j, const loop_access *write) {
    const ir_node *target =
        write->access.callee ? update_call_of(j, write->access.node).target : NULL;
    return target &&
           conflict_at(j->an->facts, j->loop, target, write->access.node) == CONFLICT_SHARED;
}

static bool check_write(loop_analysis *j, loop_access *write) {
    const location *where = &write->where;
    if (!write->access.lvalue)
        return analysis_refuse(j, REASON_CALLEE_UPDATES, write->access.node,
                               write->access.callee->name);
    bool is_update = write->access.kind == ACCESS_UPDATE && !write->access.callee;
    if (is_own_object(j, where)) {
        if (take_private(j, where->object) || take_induction(j, write)) {
            write->class = CLASS_SCALAR;
            return true;
        }
        if (scalar_take_update(j, write))
            return true;
        if (induction_take(j, where->object)) {
            write->class = CLASS_SCALAR;
            return true;
        }
        if ((!is_update && !is_irregular_call(j, write)) || !is_element(write->access.lvalue) ||
            !is_in_array(write))
            return refuse_variable(j, write);
    } else if (where->object && !is_element(write->access.lvalue)) {
        return scalar_take_update(j, write) ||
               analysis_refuse(j, is_update ? REASON_SCALAR_CARRIED : REASON_OTHER_STORE,
                               write->access.node, where->object->name);
    } else if (scalar_take_update(j, write)) {
        return true;
    }
    return is_update ? check_update(j, write) : check_store(j, write);
}

/* Refuses the loop if it reads an updated element. This is checked before stores, because the read
 * is a more useful reason than a store in the same loop. */
static bool check_plain_reads(loop_analysis *j) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *read = &j->accesses[i];
        for (unsigned k = 0;
             read->access.kind == ACCESS_READ && !read->access.callee && k < j->arrays.count; k++)
            if (read->class != CLASS_SELF && !is_own_scalar(j, &read->where) &&
                !is_read_of_own_element(j, read) &&
                locations_overlap(&j->an->rules, &read->where, &j->arrays.items[k].where) ==
                    OVERLAP_SAME)
                return analysis_refuse_read(j, &j->arrays.items[k], read->access.node);
    }
    return true;
}

static bool check_writes(loop_analysis *j) {
    /* irregular updates come first, because a reason to refuse one of these is more useful than a
     * reason to refuse a store */
    for (unsigned pass = 0; pass < 2; pass++) {
        for (unsigned i = 0; i < j->access_count; i++) {
            loop_access *a = &j->accesses[i];
            update_group group;
            bool is_irregular_update = ((a->access.kind == ACCESS_UPDATE && !a->access.callee) ||
                                        is_of_group(j, a, &group)) &&
                                       is_element(a->access.lvalue) &&
                                       conflict_is_shared(j->an->facts, j->loop, a->access.lvalue);
            if (a->access.kind != ACCESS_READ && a->class == CLASS_OPEN &&
                is_irregular_update == (pass == 0) && !check_write(j, a))
                return false;
        }
        if (pass == 0 && !check_plain_reads(j))
            return false;
    }
    return true;
}

update_result check_updates(const loop_analysis *j) {
    loop_analysis own = analysis_copy(j);
    own_take(&own);
    if (check_writes(&own))
        own_check(&own);
    return (update_result){.why = own.why,
                           .access_count = own.access_count,
                           .accesses = own.accesses,
                           .arrays = own.arrays,
                           .updates = own.updates,
                           .scalars = own.scalars,
                           .forwards = own.forwards,
                           .own = own.own,
                           .privates = own.privates};
}
