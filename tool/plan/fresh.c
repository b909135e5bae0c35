/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A place is the variable in question, a member of it, or an element of a short array. For
 * elements, short loops with constant bounds are interpreted, so that a counter used as a subscript
 * is a known number. Statements are classified in the order of their execution, up to the first
 * assignment that is always executed. Control leaves a statement early only by `continue`, `break`
 * or `return`; in that case it does not reach what follows the statement.
 */
#include "plan/fresh.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/stepped.h"

enum { MOST_ELEMENTS = 16 };

/** A counter's value in the present iteration of a loop with constant bounds. */
typedef struct known {
    const ir_variable *counter;
    int64_t value;
    const struct known *others;
} known;

typedef struct place {
    const ir_variable *variable;
    const ir_field *field; /* the member, if the variable is a record */
    int64_t element;       /* the subscript, if the variable is an array */
    const known *known;
} place;

typedef enum finding {
    READS,   /* may read the place before assigning it */
    FRESH,   /* does not read it before assigning it */
    ASSIGNS, /* FRESH, and has assigned it whenever the next statement is reached */
} finding;

static bool is_array(const place *p) {
    return p->variable->type->kind == IR_ARRAY;
}

static bool value_of(const place *p, const ir_node *node, int64_t *value) {
    for (const known *it = p->known; it; it = it->others)
        if (expression_is_variable(node, it->counter)) {
            *value = it->value;
            return true;
        }
    return expression_constant(node, value);
}

static bool is_element_of(const place *p, const ir_node *node, int64_t *element) {
    return node->kind == IR_INDEX && expression_is_variable(node->children[0], p->variable) &&
           value_of(p, node->children[1], element);
}

static bool is_place(const place *p, const ir_node *node) {
    int64_t element;
    if (is_array(p))
        return is_element_of(p, node, &element) && element == p->element;
    if (!p->field)
        return expression_is_variable(node, p->variable);
    return node->kind == IR_MEMBER && !(node->flags & IR_ARROW) && node->field &&
           node->field->offset == p->field->offset &&
           expression_is_variable(node->children[0], p->variable);
}

/** May the node name the place? An unknown subscript may have any value. */
static bool mentions(const place *p, const ir_node *node) {
    int64_t element;
    if (is_place(p, node) || (is_array(p) && expression_is_variable(node, p->variable)))
        return true;
    if (is_array(p) && is_element_of(p, node, &element))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions(p, node->children[i]))
            return true;
    return false;
}

static finding find_in(const place *p, const ir_node *node);

static finding in_sequence(const place *p, ir_node *const *parts, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        const finding found = find_in(p, parts[i]);
        if (found != FRESH)
            return found;
    }
    return FRESH;
}

static finding in_assignment(const place *p, const ir_node *node) {
    const ir_node *target = node->children[0];
    const finding value = find_in(p, node->children[1]);
    if (value != FRESH)
        return value;
    if (is_place(p, target))
        return node->op == IR_OP_NONE ? ASSIGNS : READS;
    return mentions(p, target) ? READS : FRESH;
}

static finding in_choice(const place *p, const ir_node *node) {
    const finding condition = find_in(p, node->children[0]);
    if (condition != FRESH)
        return condition;
    const finding one = find_in(p, node->children[1]);
    const finding other = node->child_count > 2 ? find_in(p, node->children[2]) : FRESH;
    if (one == READS || other == READS)
        return READS;
    return one == ASSIGNS && other == ASSIGNS ? ASSIGNS : FRESH;
}

/** Classifies a few iterations in order, each with the value that the counter has in it. No
 * iteration may end early. */
static finding in_iterations(const place *p, const ir_node *node, int64_t first, int64_t last,
                             const ir_variable *counter) {
    assert(first <= last && last - first < MOST_ELEMENTS);
    finding found = FRESH;
    for (int64_t i = first; i <= last && found == FRESH; i++) {
        const known value = {counter, i, p->known};
        place there = *p;
        there.known = &value;
        found = find_in(&there, node->children[3]);
    }
    return found;
}

/** Classifies a `for`. If its iterations are not known, the body is assumed to assign nothing: it
 * may not be executed at all, and `continue` may leave it anywhere. */
static finding in_for(const place *p, const ir_node *node) {
    const finding first = find_in(p, node->children[0]);
    if (first != FRESH)
        return first;
    if (mentions(p, node->children[1]) || mentions(p, node->children[2]))
        return READS;
    const ir_variable *counter;
    int64_t begin, end;
    loop_span steps;
    if (is_array(p) && span_recognise((ir_node *)node, &steps) && steps.counted.step == 1 &&
        counted_constant(node, &counter, &begin, &end) && end - begin < MOST_ELEMENTS &&
        !ir_has_kind(node, IR_CONTINUE) && !ir_has_kind(node, IR_BREAK))
        return in_iterations(p, node, begin, end, counter);
    return find_in(p, node->children[3]) == READS ? READS : FRESH;
}

static finding find_in(const place *p, const ir_node *node) {
    if (!mentions(p, node))
        return FRESH;
    switch (node->kind) {
    case IR_BLOCK:
    case IR_EXPRESSION:
    case IR_DECLARATION:
        return in_sequence(p, node->children, node->child_count);
    case IR_ASSIGN:
        return in_assignment(p, node);
    case IR_BINARY:
        return node->op == IR_OP_COMMA ? in_sequence(p, node->children, node->child_count) : READS;
    case IR_IF:
        return in_choice(p, node);
    case IR_FOR:
        return in_for(p, node);
    default:
        return READS;
    }
}

/** Is the variable named only as `variable.field`, where the field is a scalar and not a
 * bit-field? */
static bool names_only_members(const ir_node *node, const ir_variable *variable) {
    if (expression_is_variable(node, variable))
        return false;
    if (node->kind == IR_MEMBER && !(node->flags & IR_ARROW) &&
        expression_is_variable(node->children[0], variable))
        return ir_type_is_scalar(node->type) && node->field && !node->field->is_bit_field;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!names_only_members(node->children[i], variable))
            return false;
    return true;
}

static bool is_fresh_array_in(const ir_node *statement, const ir_variable *variable) {
    const ir_type *element = variable->type->target;
    const int64_t count = element->size > 0 ? variable->type->size / element->size : 0;
    place one = {.variable = variable};
    if (!ir_type_is_scalar(element) || count < 1 || count > MOST_ELEMENTS)
        return false;
    for (one.element = 0; one.element < count; one.element++)
        if (find_in(&one, statement) == READS)
            return false;
    return true;
}

bool is_fresh_in(const ir_node *statement, const ir_variable *variable) {
    assert(!ir_has_kind(statement, IR_LABEL));
    if (variable->address_taken || variable->has_other_name || ir_has_kind(statement, IR_OPAQUE) ||
        ir_has_kind(statement, IR_GOTO) || ir_has_kind(statement, IR_SWITCH))
        return false;
    const ir_record *record = variable->type->record;
    if (ir_type_is_scalar(variable->type)) {
        const place whole = {.variable = variable};
        return find_in(&whole, statement) != READS;
    }
    if (variable->type->kind == IR_ARRAY)
        return is_fresh_array_in(statement, variable);
    if (variable->type->kind != IR_RECORD || !record || record->is_union ||
        !names_only_members(statement, variable))
        return false;
    for (unsigned i = 0; i < record->field_count; i++) {
        const place member = {.variable = variable, .field = &record->fields[i]};
        if (find_in(&member, statement) == READS)
            return false;
    }
    return true;
}
