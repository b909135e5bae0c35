/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/overlap/sources.h"

#include "analysis/base/expression.h"
#include "analysis/loop/own.h"
#include "analysis/loop/type_changes.h"
#include "analysis/overlap/extent.h"
#include "analysis/reduction/update_array.h"

/* Does the variable change only by its name, because it is private to the iteration or no pointer
 * to it exists? */
static bool is_unreachable(const loop_analysis *j, const location *where) {
    const ir_variable *object = where->object;
    if (!object || !variable_is_automatic(object) || object->function != j->function)
        return false;
    for (unsigned i = 0; i < j->arrays.count; i++)
        if (j->arrays.items[i].where.object == object)
            return false;
    for (unsigned i = 0; i < j->privates.count; i++)
        if (j->privates.items[i].variable == object)
            return true;
    const ir_node *declarator = variable_fact_of(j->an->facts, object)->declarator;
    bool is_inside = declarator && ir_contains(j->loop, declarator);
    return is_inside || !variable_escapes(j->an->facts, object);
}

/* The worst overlap of the read with any update of the array; these updates may be of different
 * fields. */
static overlap overlap_with_array(const loop_analysis *j, const loop_access *read, unsigned array) {
    overlap worst = OVERLAP_NO;
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *update = &j->accesses[i];
        if (update->class != CLASS_REDUCTION || update->array != array)
            continue;
        const overlap meets = accesses_overlap(j, read, update);
        if (meets > worst)
            worst = meets;
    }
    return worst;
}

static bool refuse_callee(loop_analysis *j, const loop_access *read) {
    const char *what = read->access.lvalue ? analysis_name(j, read->access.lvalue) : NULL;
    const char *name = what ? arena_format(j->an->memory, "'%s', by its read of '%s',",
                                           read->access.callee->name, what)
                            : arena_format(j->an->memory, "'%s', by a pointer not followed,",
                                           read->access.callee->name);
    return analysis_refuse(j, REASON_CALLEE_READS, read->access.node, name);
}

static bool refuse_overlap(loop_analysis *j, const loop_access *read, const loop_array *array) {
    if (read->access.callee)
        return refuse_callee(j, read);
    return analysis_refuse_read(j, array, read->access.node);
}

/* Marks the read for the guard if its extent can be determined; otherwise refuses the loop. */
static bool check_guard(loop_analysis *j, loop_access *read) {
    if (source_plan_of(j, read, false).is_possible) {
        read->needs_guard = true;
        return true;
    }
    if (read->access.callee)
        return refuse_callee(j, read);
    return analysis_refuse(j, REASON_MAY_ALIAS, read->access.node,
                           analysis_name(j, read->access.lvalue));
}

static bool has_same_base(const location *a, const location *b) {
    if (a->object || b->object)
        return a->object == b->object;
    return a->pointer && b->pointer && expression_same(a->pointer, b->pointer);
}

/* Do the read and the updated rows belong to the same table, as rows[i][c] and rows[k][c] do? They
 * overlap at least if i == k. */
static bool is_of_same_table(const loop_analysis *j, const loop_access *read,
                             const loop_array *array) {
    const ir_node *x = read->where.pointer, *y = array->where.pointer;
    if (!array->array.is_scattered || !x || !y || x->kind != y->kind ||
        (x->kind == IR_MEMBER && x->field != y->field))
        return false;
    const ir_node *table = update_table_of(j, x);
    return table && expression_same(table, array->array.base);
}

/* The worst overlap with scalars in memory that the loop accumulates into. */
static overlap overlap_with_scalars(const loop_analysis *j, const loop_access *other) {
    overlap worst = OVERLAP_NO;
    for (unsigned i = 0; i < j->access_count; i++) {
        if (!j->accesses[i].is_scalar || other == &j->accesses[i])
            continue;
        const overlap meets = accesses_overlap(j, other, &j->accesses[i]);
        worst = meets > worst ? meets : worst;
    }
    return worst;
}

static bool refuse_scalar(loop_analysis *j, const loop_access *scalar) {
    return analysis_refuse(j, REASON_SCALAR_CARRIED, scalar->access.node,
                           analysis_name(j, scalar->access.lvalue));
}

/* Marks the guarded scalars. At run time, their addresses are compared with all arrays, with each
 * other, and with all reads that may alias them. All other writes must be proved disjoint from
 * these scalars; otherwise the loop is refused. */
static bool check_scalars_in_memory(loop_analysis *j) {
    for (unsigned i = 0; i < j->access_count; i++) {
        loop_access *scalar = &j->accesses[i];
        if (!scalar->is_scalar || own_named(j, scalar->access.lvalue) >= 0)
            continue;
        const source_plan plan = source_plan_of(j, scalar, false);
        if (!plan.is_possible || plan.source.extent != EXTENT_INVARIANT)
            return refuse_scalar(j, scalar);
        scalar->needs_guard = true;
        for (unsigned k = 0; k < j->access_count; k++) {
            const loop_access *other = &j->accesses[k];
            const bool is_own = other->access.lvalue && own_named(j, other->access.lvalue) >= 0;
            if (other->access.kind != ACCESS_READ && other->class != CLASS_REDUCTION &&
                !other->is_scalar && !is_own && /* the first read of the own element is compared
                                                 * instead */
                accesses_overlap(j, other, scalar) != OVERLAP_NO)
                return refuse_scalar(j, scalar);
        }
    }
    return true;
}

static bool check_reads(loop_analysis *j) {
    for (unsigned i = 0; i < j->access_count; i++) {
        loop_access *read = &j->accesses[i];
        if (read->access.kind != ACCESS_READ || read->class == CLASS_SELF ||
            read->class == CLASS_FORWARDED)
            continue;
        if (is_unreachable(j, &read->where)) {
            read->class = CLASS_SCALAR;
            continue;
        }
        read->class = CLASS_SHARED;
        read->meets_arrays = false;
        for (unsigned k = 0; k < j->arrays.count; k++) {
            loop_array *array = &j->arrays.items[k];
            overlap meets = overlap_with_array(j, read, k);
            if (meets == OVERLAP_SAME ||
                (meets == OVERLAP_MAYBE && is_of_same_table(j, read, array)))
                return refuse_overlap(j, read, array);
            if (has_same_base(&read->where, &array->where))
                array->array.is_interleaved = true; /* a different field is read through the same
                                                     * base */
            read->meets_arrays |= meets == OVERLAP_MAYBE && !read->access.is_presumed;
        }
        read->meets_scalars =
            !read->access.is_presumed && overlap_with_scalars(j, read) != OVERLAP_NO;
        if ((read->meets_arrays || read->meets_scalars || read->is_scalar) && !check_guard(j, read))
            return false;
    }
    return true;
}

source_result check_sources(const loop_analysis *j) {
    loop_analysis own = analysis_copy(j);
    if (check_scalars_in_memory(&own))
        check_reads(&own);
    return (source_result){own.why, own.accesses, own.arrays};
}
