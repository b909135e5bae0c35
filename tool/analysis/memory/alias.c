/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/alias.h"

#include "analysis/base/expression.h"

static bool is_character(const ir_type *type) {
    return type->kind == IR_INTEGER && (type->is_character || type->size == 1);
}

static bool record_may_hold(const ir_type *record, const ir_type *other) {
    if (!record->record || !record->record->is_complete)
        return true;
    for (unsigned i = 0; i < record->record->field_count; i++)
        if (types_may_overlap(record->record->fields[i].type, other))
            return true;
    return false;
}

bool types_may_overlap(const ir_type *a, const ir_type *b) {
    if (!a || !b)
        return true;
    a = ir_type_innermost(a);
    b = ir_type_innermost(b);
    if (a->kind == IR_RECORD)
        return a->record == b->record || record_may_hold(a, b);
    if (b->kind == IR_RECORD)
        return record_may_hold(b, a);
    if (is_character(a) || is_character(b) || a->kind == IR_OTHER_TYPE || b->kind == IR_OTHER_TYPE)
        return true;
    switch (a->kind) {
    case IR_INTEGER:
        return b->kind == IR_INTEGER && a->size == b->size;
    case IR_FLOATING:
        return (b->kind == IR_FLOATING && a->size == b->size) || b->kind == IR_COMPLEX;
    case IR_COMPLEX:
        return b->kind == IR_COMPLEX || b->kind == IR_FLOATING;
    case IR_BOOLEAN:
    case IR_POINTER:
        return a->kind == b->kind;
    default:
        return true;
    }
}

/* Does the type contain an array of length 0 or of unknown length? Its elements overlap members
 * declared after it, or lie outside of the object. */
static bool is_open(const ir_type *type) {
    for (; type->kind == IR_ARRAY; type = type->target)
        if (type->count <= 0)
            return true;
    if (type->kind != IR_RECORD || !type->record)
        return false;
    for (unsigned i = 0; i < type->record->field_count; i++)
        if (is_open(type->record->fields[i].type))
            return true;
    return false;
}

static bool disjoint_in_record(const ir_field *a, const ir_field *b) {
    if (a->is_bit_field || b->is_bit_field)
        return false;
    return !(is_open(a->type) && b->offset >= a->offset) &&
           !(is_open(b->type) && a->offset >= b->offset);
}

/* Do the two paths first differ in naming different fields of one record? Subscripts before the
 * fields do not matter: inside one element the fields are disjoint, and different elements are
 * disjoint anyway. */
static bool fields_are_disjoint(const location *a, const location *b) {
    unsigned count = a->step_count < b->step_count ? a->step_count : b->step_count;
    for (unsigned i = 0; i < count; i++) {
        const location_step *x = &a->steps[i];
        const location_step *y = &b->steps[i];
        if (!x->field != !y->field)
            return false;
        if (!x->field)
            continue;
        if (x->record != y->record || !x->record || x->record->is_union)
            return false;
        if (x->field != y->field)
            return disjoint_in_record(x->field, y->field);
    }
    return false;
}

/* Are the locations different fields p->x and q->y of pointers to the same record type? Then they
 * are disjoint, whatever p and q point to. */
static bool pointed_fields_are_disjoint(const location *a, const location *b) {
    if (a->is_punned || b->is_punned || !a->pointer || !b->pointer)
        return false;
    const ir_type *x = a->pointer->type;
    const ir_type *y = b->pointer->type;
    bool same_records = x && y && x->target && y->target && x->target->kind == IR_RECORD &&
                        ir_type_equal(x->target, y->target);
    return same_records && fields_are_disjoint(a, b);
}

/* Can the pointer behind `other` point into the named object? */
static bool is_reachable(const alias_rules *rules, const ir_variable *object,
                         const location *other) {
    /* Initialisers at file scope are not in the IR, so the address of a static object may be
     * anywhere. */
    if (!variable_is_automatic(object))
        return true;
    /* A pointer of unknown origin may point to any object whose address has been taken. */
    if (!other->pointer)
        return variable_is_exposed(rules->facts, object);
    return variable_escapes(rules->facts, object);
}

/* Does the pointer's restrict qualifier hold only within one iteration? True if the loop's body
 * declares the pointer, because the qualifier holds during one execution of the declaring block
 * (C17 6.7.3.1p2). */
static bool promises_for_one_iteration(const alias_rules *rules, const ir_variable *pointer) {
    const ir_node *declarator = variable_fact_of(rules->facts, pointer)->declarator;
    return rules->loop && declarator && ir_contains(rules->loop, declarator);
}

static const ir_variable *restricted_pointer(const alias_rules *rules, const location *l) {
    if (l->pointer && l->pointer->kind == IR_VARIABLE &&
        variable_is_restricted(rules->facts, l->pointer->variable) &&
        !promises_for_one_iteration(rules, l->pointer->variable))
        return l->pointer->variable;
    return NULL;
}

static bool restrict_separates(const alias_rules *rules, const location *a, const location *b) {
    const ir_variable *x = restricted_pointer(rules, a);
    const ir_variable *y = restricted_pointer(rules, b);
    if (x && b->pointer && !expression_mentions(b->pointer, x))
        return true;
    if (y && a->pointer && !expression_mentions(a->pointer, y))
        return true;
    return (x && b->object) || (y && a->object);
}

/* Is the location an object that is defined const? Any write to it is undefined, through any
 * pointer (C17 6.7.3p7). */
static bool is_constant(const location *l) {
    const ir_type *type = l->object ? ir_type_innermost(l->object->type) : NULL;
    return type && (type->is_const || l->object->type->is_const) && !type->is_volatile;
}

/* Compares the locations. `types_hold` says that neither access may give the memory another
 * effective type before the other is made. */
static overlap compare(const alias_rules *rules, const location *a, const location *b,
                       bool types_hold) {
    if (a->is_string || b->is_string || a->is_of_locale || b->is_of_locale || is_constant(a) ||
        is_constant(b))
        return OVERLAP_NO;
    if (a->object && b->object) {
        if (a->object != b->object)
            return a->object->has_other_name || b->object->has_other_name ? OVERLAP_MAYBE
                                                                          : OVERLAP_NO;
        return fields_are_disjoint(a, b) ? OVERLAP_NO : OVERLAP_SAME;
    }
    if (a->pointer && b->pointer && expression_same(a->pointer, b->pointer))
        return fields_are_disjoint(a, b) ? OVERLAP_NO : OVERLAP_SAME;
    if (a->object && !is_reachable(rules, a->object, b))
        return OVERLAP_NO;
    if (b->object && !is_reachable(rules, b->object, a))
        return OVERLAP_NO;
    bool same_pointers_known = (a->object || a->pointer) && (b->object || b->pointer);
    if (same_pointers_known && restrict_separates(rules, a, b))
        return OVERLAP_NO;
    if (rules->strict_aliasing && types_hold && !a->has_union && !b->has_union &&
        !types_may_overlap(a->type, b->type))
        return OVERLAP_NO;
    if (pointed_fields_are_disjoint(a, b))
        return OVERLAP_NO;
    if (rules->assume_noalias && same_pointers_known)
        return OVERLAP_NO;
    return OVERLAP_MAYBE;
}

overlap locations_overlap(const alias_rules *rules, const location *a, const location *b) {
    return compare(rules, a, b, true);
}

overlap locations_overlap_store(const alias_rules *rules, const location *read,
                                const location *store) {
    return compare(rules, read, store, read->object || store->object);
}
