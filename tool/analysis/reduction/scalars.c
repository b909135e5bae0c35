/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* If nothing else reads a scalar that the loop accumulates into, the scalar's value does not matter
 * while the loop runs. Each iteration stores its operands. After the loop they are applied in
 * order, which gives the same bits as the sequential loop. For a minimum or maximum the operands
 * are the compared values (scalar_extremum.c).
 *
 * An iteration may combine its integer operands, because modulo 2^64 the result does not depend on
 * the order. For floating numbers in an inner loop, each iteration stores a series of operands. */
#include "analysis/reduction/scalars.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/reduction/scalar_extremum.h"
#include "analysis/reduction/scalar_target.h"

static bool is_operator(ir_operator op) {
    return op == IR_OP_ADD || op == IR_OP_SUBTRACT || op == IR_OP_MULTIPLY || op == IR_OP_BIT_AND ||
           op == IR_OP_BIT_OR || op == IR_OP_BIT_XOR;
}

/* Recognises s op= e, s = s op e, s = e + s, s = e * s, s++ and s--. Sets the operator and the
 * operand. */
static bool recognise(const ir_node *assignment, const ir_node *s, scalar_update *found) {
    if (assignment->kind == IR_UNARY) {
        found->op = assignment->op == IR_OP_PRE_INCREMENT || assignment->op == IR_OP_POST_INCREMENT
                        ? IR_OP_ADD
                        : IR_OP_SUBTRACT;
        return ir_is_increment(assignment);
    }
    if (assignment->kind != IR_ASSIGN)
        return false;
    const ir_node *value = assignment->children[1];
    found->op = assignment->op;
    found->value = value;
    if (assignment->op == IR_OP_NONE && value->kind == IR_BINARY) {
        bool is_left = expression_same(value->children[0], s);
        bool is_right = expression_same(value->children[1], s) &&
                        (value->op == IR_OP_ADD || value->op == IR_OP_MULTIPLY);
        if (!is_left && !is_right)
            return false;
        found->op = value->op;
        found->value = value->children[is_left ? 1 : 0];
    }
    return is_operator(found->op) && !expression_occurrences(found->value, s);
}

static bool is_narrow_floating(const ir_type *type) {
    return type->kind == IR_FLOATING && (type->size == 4 || type->size == 8);
}

/* Sets `operand`, the type of the operation, to which the value is converted. Returns false if no
 * operand_type represents that type, if the target is volatile or atomic, or if a floating-point
 * target is updated by an operator other than +, -, * and the extrema. For integers, only the value
 * modulo 2^64 matters. */
static bool find_operand_type(scalar_update *found) {
    const ir_type *type = found->target->type;
    const ir_type *value = found->value ? found->value->type : NULL;
    bool value_is_integer =
        !found->value || (value && (value->kind == IR_INTEGER || value->kind == IR_BOOLEAN));
    if (type->is_volatile || type->is_atomic)
        return false;
    if (type->kind == IR_INTEGER) {
        found->operand = OPERAND_INTEGER;
        return value_is_integer && type->size <= 8 && (!value || value->size <= 8);
    }
    if (!is_narrow_floating(type) || (found->op != IR_OP_ADD && found->op != IR_OP_SUBTRACT &&
                                      found->op != IR_OP_MULTIPLY && !found->is_extremum))
        return false;
    if (!value_is_integer && (!value || !is_narrow_floating(value)))
        return false;
    bool is_double = type->size == 8 || (value && value->kind == IR_FLOATING && value->size == 8);
    found->operand = is_double ? OPERAND_DOUBLE : OPERAND_FLOAT;
    return true;
}

/* Is the loop do { ... } while (0), as in macros? */
static bool is_executed_once(const ir_node *loop) {
    int64_t again;
    return loop->kind == IR_DO && expression_constant(loop->children[1], &again) && !again;
}

/* Is the statement executed at most once in each iteration? */
static bool is_outside_inner_loops(const loop_analysis *j, const ir_node *statement) {
    for (const ir_node *outer = statement->parent; outer != j->loop; outer = outer->parent)
        if (!outer || (ir_is_loop(outer) && !is_executed_once(outer)))
            return false;
    return true;
}

/* Does the statement write anything else? Local objects that a called function writes, as in
 * `s += energy(x, stress)`, do not count here: like all written variables, they must be proved
 * private. */
static bool has_other_write(const loop_analysis *j, const ir_node *statement,
                            const loop_access *write) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *other = &j->accesses[i];
        const ir_variable *object = other->where.object;
        const bool is_own = other->access.callee && object && variable_is_automatic(object);
        if (other != write && other->access.kind != ACCESS_READ && !is_own &&
            ir_contains(statement, other->access.node))
            return true;
    }
    return false;
}

static bool is_declared_within(const loop_analysis *j, const ir_variable *variable) {
    return variable->storage == IR_THREAD_LOCAL || analysis_declares(j, variable);
}

/* Marks every access to the variable in the statement as part of the update. */
static void mark_own(loop_analysis *j, const ir_node *statement, const ir_variable *variable) {
    for (unsigned i = 0; i < j->access_count; i++) {
        loop_access *a = &j->accesses[i];
        if (!a->access.callee && a->access.lvalue &&
            expression_is_variable(a->access.lvalue, variable) &&
            ir_contains(statement, a->access.node))
            a->class = CLASS_SELF;
    }
}

static bool take_extremum(loop_analysis *j, const ir_node *assignment) {
    scalar_update found;
    if (!scalar_extremum_of(j, assignment, &found) || !find_operand_type(&found) ||
        found.statement->range.begin >= found.statement->range.end ||
        is_declared_within(j, found.variable) ||
        (found.place && is_declared_within(j, found.place)))
        return false;
    for (unsigned i = 0; i < j->scalars.count; i++)
        if (j->scalars.items[i].statement == found.statement)
            return true; /* both assignments in if (e > s) { s = e; at = i; } belong to one
                          * update */
    mark_own(j, found.statement, found.variable);
    if (found.place)
        mark_own(j, found.statement, found.place);
    VECTOR_PUSH(j->an->memory, &j->scalars, found);
    return true;
}

/* Is the target an object from outside the loop that is the same in all iterations? Sets
 * *is_guarded if other accesses may alias it. */
static bool is_scalar(const loop_analysis *j, const loop_access *write, bool *is_guarded) {
    const ir_node *target = write->access.lvalue;
    if (target->kind == IR_VARIABLE) {
        *is_guarded = !variable_is_automatic(target->variable) &&
                      scalar_target_overlap(j, target) == OVERLAP_MAYBE;
        return !is_declared_within(j, target->variable);
    }
    if (target != write->access.node || !ir_type_is_scalar(target->type) ||
        !scalar_target_is_invariant(j, target))
        return false;
    const overlap meets = scalar_target_overlap(j, target);
    *is_guarded = meets == OVERLAP_MAYBE;
    return meets != OVERLAP_SAME;
}

static bool have_same_target(const scalar_update *a, const scalar_update *b) {
    return expression_same(a->target, b->target);
}

/* If one update of a scalar has a series, the operands of all updates of that scalar go into it. */
static void join_series(loop_analysis *j, scalar_update *found) {
    for (unsigned i = 0; i < j->scalars.count; i++)
        found->is_series |=
            j->scalars.items[i].is_series && have_same_target(&j->scalars.items[i], found);
    for (unsigned i = 0; found->is_series && i < j->scalars.count; i++)
        if (have_same_target(&j->scalars.items[i], found))
            j->scalars.items[i].is_series = true;
}

bool scalar_take_update(loop_analysis *j, loop_access *write) {
    assert(write->access.kind != ACCESS_READ);
    const ir_node *target = write->access.lvalue;
    if (write->access.callee || !target || !target->parent)
        return false;
    const ir_node *assignment = target->parent;
    const ir_node *statement = assignment->parent;
    const bool is_variable = target->kind == IR_VARIABLE;
    if (is_variable && take_extremum(j, assignment))
        return true;
    scalar_update found = {.variable = is_variable ? target->variable : NULL,
                           .target = target,
                           .statement = statement};
    if (!statement || statement->kind != IR_EXPRESSION || ir_value_is_used(assignment) ||
        statement->range.begin >= statement->range.end || !recognise(assignment, target, &found) ||
        !find_operand_type(&found) || has_other_write(j, statement, write))
        return false;
    found.is_repeated = !is_outside_inner_loops(j, statement);
    found.is_conditional = write->access.is_conditional || found.is_repeated;
    found.is_series = found.is_repeated && found.operand != OPERAND_INTEGER;
    if (!is_scalar(j, write, &found.is_guarded))
        return false;
    for (unsigned i = 0; i < j->access_count; i++) {
        loop_access *read = &j->accesses[i];
        if (read->access.kind == ACCESS_READ && !read->access.callee && read->access.lvalue &&
            expression_same(read->access.lvalue, target) &&
            ir_contains(statement, read->access.node))
            read->class = CLASS_SELF;
    }
    write->class = CLASS_SELF;
    write->is_scalar = found.is_guarded;
    join_series(j, &found);
    VECTOR_PUSH(j->an->memory, &j->scalars, found);
    return true;
}

static bool is_own_access(const loop_access *a, const ir_variable *s) {
    return a->class == CLASS_SELF && a->access.lvalue &&
           expression_is_variable(a->access.lvalue, s);
}

static const char *name_of(const loop_analysis *j, const scalar_update *update) {
    return expression_text(j->an->memory, update->target);
}

/* Can updates by these operators be exchanged? Additions and subtractions can be exchanged with
 * each other; updates by any other operator only with updates by the same operator. */
static bool commute(ir_operator a, ir_operator b) {
    const bool is_sum = a == IR_OP_ADD || a == IR_OP_SUBTRACT;
    return a == b || (is_sum && (b == IR_OP_ADD || b == IR_OP_SUBTRACT));
}

/* Can the operands of both updates be in one series, with the same operator and type? */
static bool is_of_series(const scalar_update *other, const scalar_update *repeated) {
    return !other->is_extremum && other->op == repeated->op && other->operand == repeated->operand;
}

/* Checks an update in an inner loop. Operands that an iteration combines must commute with the
 * scalar's other updates. Operands of a series must have the same operator and type. */
static reason check_repeated(const loop_analysis *j, const scalar_update *repeated) {
    for (unsigned i = 0; i < j->scalars.count; i++) {
        const scalar_update *other = &j->scalars.items[i];
        const bool is_fit =
            repeated->is_series ? is_of_series(other, repeated) : commute(other->op, repeated->op);
        if (have_same_target(other, repeated) && !is_fit)
            return analysis_reason(j, REASON_SCALAR_CARRIED, other->statement, name_of(j, other));
    }
    return (reason){0};
}

/* Checks that the scalar, which is a member, an element or a pointer's target, is named only by its
 * updates. scalar_target_overlap has already compared it with other expressions. */
static reason check_target_alone(const loop_analysis *j, const scalar_update *update) {
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *a = &j->accesses[i];
        if (a->class != CLASS_SELF && a->access.lvalue &&
            expression_same(a->access.lvalue, update->target))
            return analysis_reason(j, REASON_SCALAR_CARRIED, a->access.node, name_of(j, update));
    }
    return (reason){0};
}

/* Checks that the variable is accessed only by updates of its scalar. If `variable` is the `place`
 * of an extremum, only the update `update` may access it. If the scalar is guarded, possible
 * aliases are compared at run time (sources.c). */
static reason check_alone(const loop_analysis *j, const scalar_update *update,
                          ir_variable *variable) {
    const location where = {.object = variable, .type = variable->type};
    for (unsigned i = 0; i < j->access_count; i++) {
        const loop_access *a = &j->accesses[i];
        const bool is_own =
            is_own_access(a, variable) &&
            (variable != update->place || ir_contains(update->statement, a->access.node));
        const overlap meets =
            is_own ? OVERLAP_NO : locations_overlap(&j->an->rules, &a->where, &where);
        if (meets == OVERLAP_SAME || (meets == OVERLAP_MAYBE && !update->is_guarded))
            return analysis_reason(j, REASON_SCALAR_CARRIED, a->access.node, variable->name);
    }
    return (reason){0};
}

reason check_scalars(const loop_analysis *j) {
    reason why = {0};
    for (unsigned k = 0; k < j->scalars.count && why.id == REASON_NONE; k++) {
        const scalar_update *update = &j->scalars.items[k];
        if (update->is_repeated)
            why = check_repeated(j, update);
        if (why.id == REASON_NONE)
            why = update->variable ? check_alone(j, update, update->variable)
                                   : check_target_alone(j, update);
        if (why.id == REASON_NONE && update->place)
            why = check_alone(j, update, update->place);
    }
    return why;
}
