/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/update_array.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/loop/bases.h"
#include "analysis/loop/variation.h"

/* ---- the base ------------------------------------------------------------------------------- */

/* For example, the target is row[1] or p->x, after double *row = b[k] or p = &b[k] in the loop. The
 * pointer's definition then contains the base b. */
bool update_is_by_local_pointer(const loop_analysis *j, const loop_access *update) {
    const ir_node *target = update->access.form.target;
    const ir_node *base = update->where.base;
    const ir_variable *root = ir_root_variable(target);
    return base && !ir_contains(target, base) && ir_contains(j->counted.body, base) && root &&
           root->type->kind == IR_POINTER &&
           (variable_single_definition(j->an->facts, root) ||
            variable_walk_start(j->an->facts, root, j->loop));
}

static bool base_is_invariant(const loop_analysis *j, const ir_node *base) {
    return base->type && base->type->kind == IR_ARRAY
               ? variation_is_fixed(j->an->facts, j->loop, base)
               : variation_is_invariant(j->an->facts, j->loop, base);
}

/* Is the table local, and may the loop store pointers to it? Such pointers could differ in each
 * iteration, and depend on data that are not compared when a plan is reused. */
static bool is_filled_here(const loop_analysis *j, const ir_node *table) {
    const ir_variable *root = ir_root_variable(table);
    for (unsigned i = 0; root && variable_is_automatic(root) && i < j->access_count; i++) {
        const loop_access *a = &j->accesses[i];
        const ir_type *type = a->access.type ? ir_type_innermost(a->access.type) : NULL;
        const bool may_be_pointer =
            !type || (type->kind != IR_INTEGER && type->kind != IR_FLOATING) || type->size == 1;
        if (a->access.kind != ACCESS_READ && a->where.object == root && may_be_pointer)
            return true;
    }
    return false;
}

const ir_node *update_table_of(const loop_analysis *j, const ir_node *base) {
    enum { MOST_POINTERS = 8 };
    const ir_node *table = base;
    for (unsigned i = 0; table && i <= MOST_POINTERS; i++) {
        if (base_is_invariant(j, table))
            return table == base || is_filled_here(j, table) ? NULL : table;
        if (table->kind != IR_INDEX && table->kind != IR_MEMBER)
            return NULL;
        const location where = location_of(j->an->facts, table, j->loop);
        if (where.is_punned || where.has_union || where.base == table)
            return NULL;
        table = where.base;
    }
    return NULL;
}

/* Handles elements that each iteration finds through pointers from an invariant table. Writes are
 * then checked by address, and no element's address is computed before the loop. */
static bool check_table(loop_analysis *j, const ir_node *base, const ir_node *target,
                        const char *name) {
    const ir_node *table = update_table_of(j, base);
    if (!table)
        return analysis_refuse(j, base->kind == IR_INDEX ? REASON_ROW_POINTERS : REASON_BASE_VARIES,
                               target, name);
    if (!ir_type_is_scalar(target->type)) /* a thread might own only a part of the element */
        return analysis_refuse(j, REASON_ROW_POINTERS, target, name);
    return true;
}

/* Is this an update of a fixed element, h[0]++, of an array whose first update has a varying
 * subscript, h[k]++? */
static bool is_updated_besides(const loop_analysis *j, const loop_access *update) {
    for (unsigned i = 0; i < j->arrays.count; i++)
        if (update->access.kind == ACCESS_UPDATE &&
            expression_same(j->arrays.items[i].array.base, update->where.base) &&
            !variation_is_fixed(j->an->facts, j->loop, j->arrays.items[i].first))
            return true;
    return false;
}

bool update_check_base(loop_analysis *j, const loop_access *update, const char *name) {
    assert(name);
    const ir_node *target = update->access.form.target;
    const location *where = &update->where;
    if (where->is_punned)
        return analysis_refuse(j, REASON_TYPE_PUNNED, target, name);
    if (!where->base || where->base == target || (!where->object && !where->pointer) ||
        (!ir_contains(target, where->base) && !update_is_by_local_pointer(j, update)))
        return analysis_refuse(j, REASON_BASE_VARIES, target, name);
    if (!base_is_invariant(j, where->base))
        return where->base->kind == IR_INDEX || where->base->kind == IR_MEMBER
                   ? check_table(j, where->base, target, name)
                   : analysis_refuse(j, REASON_BASE_VARIES, where->base, name);
    if (!base_can_be_read_before(j, where->base))
        return analysis_refuse(j, REASON_BASE_CONDITIONAL, where->base, name);
    const ir_type *type = where->base->type;
    if (!type || (type->kind != IR_POINTER && type->kind != IR_ARRAY))
        return analysis_refuse(j, REASON_SCALAR_CARRIED, target, name);
    if (type->is_volatile || type->is_atomic)
        return analysis_refuse(j, REASON_VOLATILE, target, name);
    if (variation_is_fixed(j->an->facts, j->loop, target) && !is_updated_besides(j, update))
        return analysis_refuse(j, REASON_SCALAR_CARRIED, target, name);
    return true;
}

const ir_node *update_base_of(const ir_node *target, const ir_node *base) {
    const ir_node *last = base;
    while (last != target && last->parent && last->parent->kind == IR_MEMBER)
        last = last->parent;
    return last != target && last->type && last->type->kind == IR_ARRAY ? last : base;
}

/* ---- the arrays ------------------------------------------------------------------------------ */

static bool add_array(loop_analysis *j, const loop_access *update, update_kind kind,
                      unsigned *number) {
    const ir_node *target = update->access.form.target;
    const ir_node *table = update_table_of(j, update->where.base);
    const ir_node *base = table ? table : update->where.base;
    for (unsigned i = 0; i < j->arrays.count; i++) {
        loop_array *known = &j->arrays.items[i];
        if (known->array.is_scattered != (table != NULL) ||
            !expression_same(known->array.base, base))
            continue;
        /* the same base means the same array; different fields of it are disjoint */
        overlap meets = locations_overlap(&j->an->rules, &known->where, &update->where);
        bool other_type = !ir_type_equal(known->array.element, update->access.type);
        bool other_limit = known->array.limit != kind.limit;
        bool differs = known->array.op != kind.op || other_type || other_limit;
        if (meets != OVERLAP_NO && other_type)
            return analysis_refuse(j, REASON_TYPE_PUNNED, target, known->array.name);
        known->array.order_is_kept |=
            kind.needs_order || other_limit || (meets != OVERLAP_NO && differs);
        known->array.is_interleaved |= differs;
        *number = i;
        return true;
    }
    loop_array item = {.where = update->where, .first = target};
    item.array = (reduction_array){.base = base,
                                   .name = expression_text(j->an->memory, base),
                                   .element = update->access.type,
                                   .op = kind.op,
                                   .limit = kind.limit,
                                   .order_is_kept = kind.needs_order || table,
                                   .is_scattered = table};
    *number = j->arrays.count;
    VECTOR_PUSH(j->an->memory, &j->arrays, item);
    assert(j->arrays.items[*number].first == target);
    return true;
}

/* Compares the update with all other updates of the array. add_array has compared it only with the
 * first one, which may be of another field. */
static bool check_neighbours(loop_analysis *j, const loop_access *update, update_kind kind,
                             loop_array *array, unsigned number) {
    assert(number < j->arrays.count);
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        if (other->class != CLASS_REDUCTION || other->array != number ||
            locations_overlap(&j->an->rules, &other->where, &update->where) == OVERLAP_NO)
            continue;
        if (!ir_type_equal(other->where.type, update->where.type))
            return analysis_refuse(j, REASON_TYPE_PUNNED, update->access.lvalue, array->array.name);
        if (other->op != kind.op)
            array->array.order_is_kept = true;
    }
    return true;
}

bool update_array_find(loop_analysis *j, const loop_access *update, update_kind kind,
                       unsigned *number) {
    return add_array(j, update, kind, number) &&
           check_neighbours(j, update, kind, &j->arrays.items[*number], *number);
}

/* ---- rows behind pointers to records ---------------------------------------------------------
 * After p = &b[k], the row of an update p->x += v is b[k].x if k has not changed since. From the
 * spelling b[k].x, unlike p->x, spans.c can see how the row steps. */

/* Is the subscript a sum of numbers, the loop's counter, and local variables that the body writes
 * by name? */
static bool is_of_iteration_alone(const loop_analysis *j, const ir_node *index) {
    if (index->kind == IR_VARIABLE)
        return !index->variable->address_taken && variable_is_automatic(index->variable) &&
               (index->variable == j->counted.counter ||
                variable_is_written_in(j->counted.body, index->variable));
    const bool is_sum =
        index->kind == IR_BINARY && (index->op == IR_OP_ADD || index->op == IR_OP_SUBTRACT);
    if (index->kind != IR_NUMBER && index->kind != IR_CAST && !is_sum)
        return false;
    for (unsigned i = 0; i < index->child_count; i++)
        if (!is_of_iteration_alone(j, index->children[i]))
            return false;
    return true;
}

static bool writes_any_of(const ir_node *block, const ir_node *index) {
    if (index->kind == IR_VARIABLE)
        return variable_is_written_in(block, index->variable);
    for (unsigned i = 0; i < index->child_count; i++)
        if (writes_any_of(block, index->children[i]))
            return true;
    return false;
}

/* Is the pointer to the element computed before the statement, in a block around it, and does
 * nothing in that block write a variable of the element's subscript? */
static bool is_made_before(const loop_analysis *j, const ir_node *element,
                           const ir_node *statement) {
    const ir_node *made = element;
    while (made->parent && made->parent->kind != IR_BLOCK)
        made = made->parent;
    const ir_node *block = made->parent;
    return block && ir_contains(j->loop, block) && ir_contains(block, statement) &&
           made->id < statement->id && !ir_contains(made, statement) &&
           !writes_any_of(block, element->children[1]);
}

/* The element at an address &b[k], b + k or k + b. NULL if the address has another form. */
static const ir_node *element_at(const loop_analysis *j, const ir_node *pointer) {
    if (pointer && pointer->kind == IR_UNARY && pointer->op == IR_OP_ADDRESS)
        return pointer->children[0];
    if (!pointer || pointer->kind != IR_BINARY || pointer->op != IR_OP_ADD ||
        !ir_is_pointer(pointer))
        return NULL;
    const unsigned base =
        ir_is_pointer(pointer->children[0]) || ir_is_array(pointer->children[0]) ? 0 : 1;
    ir_node *element = ir_new(j->an->memory, IR_INDEX, pointer->type->target, 2);
    element->range = pointer->range;
    element->flags = pointer->flags & (IR_FROM_MACRO | IR_FROM_CALL);
    element->parent = pointer->parent;
    for (unsigned i = 0; i < 2; i++) {
        element->children[i] =
            ir_substitute(j->an->memory, pointer->children[i == 0 ? base : 1 - base], NULL, NULL);
        element->children[i]->parent = element;
    }
    return element;
}

/* The element b[k] for an update through p = &b[k]. NULL if the pointer has another form, or if k
 * may have changed. */
static const ir_node *element_of_pointer(const loop_analysis *j, const loop_access *update,
                                         const ir_node *statement) {
    if (!update_is_by_local_pointer(j, update) || !base_is_invariant(j, update->where.base))
        return NULL;
    const ir_node *pointer =
        variable_single_definition(j->an->facts, ir_root_variable(update->access.form.target));
    const ir_node *element = element_at(j, pointer);
    return element && element->kind == IR_INDEX &&
                   expression_same(element->children[0], update->where.base) &&
                   is_of_iteration_alone(j, element->children[1]) &&
                   is_made_before(j, element, statement)
               ? element
               : NULL;
}

/* Returns the target p->x spelled as b[k].x, with the element b[k] to which p points. Returns the
 * target itself if it has another form. */
static const ir_node *spelled_by_element(const loop_analysis *j, const ir_node *target,
                                         const ir_node *element) {
    const ir_variable *pointer = ir_root_variable(target);
    ir_node *copy = ir_substitute(j->an->memory, target, NULL, NULL);
    ir_node *member = copy;
    while (member->child_count > 0 && member->children[0]->kind != IR_VARIABLE)
        member = member->children[0];
    if (member->kind != IR_MEMBER || !(member->flags & IR_ARROW))
        return target;
    member->flags &= ~(unsigned)IR_ARROW;
    member->children[0] = ir_substitute(j->an->memory, element, NULL, NULL);
    member->children[0]->parent = member;
    return expression_mentions(copy, pointer) ? target : copy;
}

static const ir_node *row_of(const loop_analysis *j, const loop_access *update,
                             const ir_node *statement, const ir_node *target) {
    const ir_node *element = element_of_pointer(j, update, statement);
    return access_row(element ? spelled_by_element(j, target, element) : target);
}

void update_array_add(loop_analysis *j, loop_access *update, update_kind kind,
                      const ir_node *statement, const ir_node *target, unsigned number) {
    assert(number < j->arrays.count && ir_contains(j->loop, statement));
    update->class = CLASS_REDUCTION;
    update->array = number;
    update->op = kind.op;
    for (unsigned i = 0; i < j->updates.count; i++)
        if (j->updates.items[i].statement == statement)
            return; /* all writes in if (R < v) R = v; else R = 0; belong to one update */
    reduction_array *array = &j->arrays.items[number].array;
    reduction_update item = {.statement = statement,
                             .target = target,
                             .row = row_of(j, update, statement, target),
                             .array = number};
    int64_t unit = item.row->type->size > 0 ? item.row->type->size : target->type->size;
    if (unit > array->unit)
        array->unit = unit;
    VECTOR_PUSH(j->an->memory, &j->updates, item);
}
