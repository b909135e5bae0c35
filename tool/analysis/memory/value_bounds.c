/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/value_bounds.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/expression.h"
#include "analysis/base/library.h"

enum { MOST_TRACKED = 16, MOST_OFFSET = 1 << 20 };

/* Facts about a variable. If has_least is set, a floating variable is either a NaN or at least
 * `least`. `least` is a node of the function; NULL stands for 0. */
typedef struct known_value {
    const ir_variable *variable;
    value_bounds integer;
    bool has_least;
    const ir_node *least;
    unsigned needs; /* a set of bits: the indices of the conditions on which these facts depend */
} known_value;

/* Facts about variables. Nothing is known about those not listed. */
typedef struct known_values {
    unsigned count;
    known_value items[MOST_TRACKED];
} known_values;

typedef struct bounding {
    variable_facts *facts;
    const ir_function *function;
    known_values now;
    bounds_conditions conditions; /* conditions of all values so far */
    unsigned needs;               /* a set of bits: the conditions on which the current value
                                   * depends */
} bounding;

/* ---- variables ------------------------------------------------------------------------------- */

/* Is the variable tracked? It must change only by name, and be floating or a signed integer that
 * never wraps around. */
static bool is_tracked(const bounding *b, const ir_variable *variable) {
    const ir_type *type = variable->type;
    return variable_is_automatic(variable) && variable->function == b->function &&
           !variable->address_taken && !type->is_volatile && !type->is_atomic &&
           (type->kind == IR_FLOATING ||
            (ir_type_is_plain_integer(type) && type->is_signed && !type->wraps));
}

static known_value *known_of(bounding *b, const ir_variable *variable) {
    for (unsigned i = 0; i < b->now.count; i++)
        if (b->now.items[i].variable == variable)
            return &b->now.items[i];
    return NULL;
}

/* Returns the known facts about a variable that occurs in the current expression. Adds the
 * conditions on which these facts depend to those of the expression (`needs`). */
static known_value used(bounding *b, const ir_variable *variable) {
    const known_value *known = known_of(b, variable);
    b->needs |= known ? known->needs : 0;
    return known ? *known : (known_value){0};
}

static void forget(bounding *b, const ir_variable *variable) {
    known_value *known = known_of(b, variable);
    if (known)
        *known = b->now.items[--b->now.count];
}

static void learn(bounding *b, const ir_variable *variable, known_value value) {
    known_value *known = known_of(b, variable);
    if (!known && b->now.count == MOST_TRACKED)
        return;
    known = known ? known : &b->now.items[b->now.count++];
    assert(b->now.count <= MOST_TRACKED);
    *known = value;
    known->variable = variable;
}

static bool forget_written(ir_node *node, void *context) {
    bounding *b = context;
    const ir_node *written = expression_written(node);
    if (written && written->kind == IR_VARIABLE)
        forget(b, written->variable);
    if (node->kind == IR_DECLARATOR)
        forget(b, node->variable);
    return true;
}

static void forget_all_written(bounding *b, const ir_node *node) {
    ir_walk((ir_node *)node, forget_written, b);
}

/* ---- values that do not change --------------------------------------------------------------- */

/* Is it a parameter that the function never writes, or a member reached through such a
 * parameter? */
static bool is_unchanged(const bounding *b, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE: {
        const ir_variable *variable = node->variable;
        return variable->storage == IR_PARAMETER && variable->function == b->function &&
               !variable->address_taken && !variable_fact_of(b->facts, variable)->write_count;
    }
    case IR_MEMBER:
        return node->field && !node->field->is_bit_field && !node->type->is_volatile &&
               !node->type->is_atomic && is_unchanged(b, node->children[0]);
    default:
        return false;
    }
}

/* ---- integers -------------------------------------------------------------------------------- */

static value_bounds nothing_known(void) {
    return (value_bounds){0};
}

static value_bounds exactly(bound_term term) {
    return (value_bounds){.low_count = 1, .high_count = 1, .low = {term}, .high = {term}};
}

static void shift_ends(bound_term *end, unsigned *count, int64_t by) {
    for (unsigned i = 0; i < *count; i++) {
        end[i].offset += by;
        if (end[i].offset > MOST_OFFSET || end[i].offset < -MOST_OFFSET) {
            *count = 0;
            return;
        }
    }
}

static value_bounds shifted(value_bounds bounds, int64_t by) {
    if (by > MOST_OFFSET || by < -MOST_OFFSET)
        return nothing_known();
    shift_ends(bounds.low, &bounds.low_count, by);
    shift_ends(bounds.high, &bounds.high_count, by);
    return bounds;
}

static bool is_same_term(bound_term a, bound_term b) {
    return a.offset == b.offset &&
           (a.value && b.value ? expression_same(a.value, b.value) : !a.value && !b.value);
}

/* Joins the bounds of two possible values. The result is unknown (0) if one of the two is. */
static void join_ends(bound_term *ends, unsigned *count, const bound_term *other,
                      unsigned other_count) {
    if (*count == 0 || other_count == 0) {
        *count = 0;
        return;
    }
    for (unsigned i = 0; i < other_count; i++) {
        bool is_there = false;
        for (unsigned k = 0; k < *count; k++)
            is_there |= is_same_term(ends[k], other[i]);
        if (is_there)
            continue;
        if (*count == BOUNDS_MOST_ENDS) {
            *count = 0;
            return;
        }
        ends[(*count)++] = other[i];
    }
}

static value_bounds either(value_bounds a, value_bounds b) {
    join_ends(a.low, &a.low_count, b.low, b.low_count);
    join_ends(a.high, &a.high_count, b.high, b.high_count);
    return a;
}

static bool is_never_below_zero(const value_bounds *bounds) {
    for (unsigned i = 0; i < bounds->low_count; i++)
        if (bounds->low[i].value || bounds->low[i].offset < 0)
            return false;
    return bounds->low_count > 0;
}

static known_value value_of(bounding *b, const ir_node *node);

/* Returns the bounds after a conversion: the same bounds if `to` can represent all values of
 * `from`; otherwise unknown bounds. */
static value_bounds converted(value_bounds bounds, const ir_type *from, const ir_type *to) {
    return from && ir_type_is_plain_integer(from) && from->is_signed &&
                   ir_type_is_plain_integer(to) && to->is_signed && to->size >= from->size
               ? bounds
               : nothing_known();
}

static value_bounds sum_of(bounding *b, const ir_node *node) {
    int64_t constant;
    const ir_node *left = node->children[0], *right = node->children[1];
    if (expression_constant(right, &constant) && constant > -MOST_OFFSET)
        return shifted(value_of(b, left).integer, node->op == IR_OP_ADD ? constant : -constant);
    if (node->op == IR_OP_ADD && expression_constant(left, &constant))
        return shifted(value_of(b, right).integer, constant);
    return nothing_known();
}

static bool is_never_negative(bounding *b, const ir_node *node);

static value_bounds integer_of(bounding *b, const ir_node *node);

/* Returns the bounds of the integer to which a value is converted. A floating value outside of the
 * type's range may become any integer (C17 F.4). In a type of less than 4 bytes, any such integer
 * might be a valid subscript, so nothing is known about a floating value converted to such a
 * type. */
static value_bounds integer_set(bounding *b, const ir_node *value, const ir_type *type) {
    if (value->type && value->type->kind == IR_FLOATING)
        return type->size >= 4 && is_never_negative(b, value) ? (value_bounds){.low_count = 1}
                                                              : nothing_known();
    return converted(integer_of(b, value), value->type, type);
}

static value_bounds integer_of(bounding *b, const ir_node *node) {
    int64_t constant;
    if (!ir_type_is_plain_integer(node->type) || !node->type->is_signed || node->type->wraps)
        return nothing_known();
    if (expression_constant(node, &constant))
        return constant > MOST_OFFSET || constant < -MOST_OFFSET
                   ? nothing_known()
                   : exactly((bound_term){NULL, constant});
    if (is_unchanged(b, node))
        return exactly((bound_term){node, 0});
    switch (node->kind) {
    case IR_VARIABLE:
        return used(b, node->variable).integer;
    case IR_CAST:
        return integer_set(b, node->children[0], node->type);
    case IR_BINARY:
        return node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT ? sum_of(b, node)
                                                                   : nothing_known();
    default:
        return nothing_known();
    }
}

/* ---- floating values ------------------------------------------------------------------------- */

/* Adds the condition that the value is not negative. Returns false if there are too many
 * conditions. */
static bool require(bounding *b, const ir_node *value) {
    bounds_conditions *all = &b->conditions;
    unsigned i = 0;
    while (i < all->count && !expression_same(all->value[i], value))
        i++;
    if (i == BOUNDS_MOST_CONDITIONS)
        return false;
    if (i == all->count)
        all->value[all->count++] = value;
    static_assert(BOUNDS_MOST_CONDITIONS <= 8 * sizeof b->needs, "one bit for each condition");
    b->needs |= 1u << i;
    return true;
}

/* The argument of a call of a C library function that maps non-negative arguments to non-negative
 * results. *is_always says that the result is never negative for any argument. NULL if the call is
 * none of these. */
static const ir_node *keeps_sign(const bounding *b, const ir_node *call, bool *is_always) {
    static const char *const names[] = {"sqrt", "fabs", "floor",    "trunc",
                                        "ceil", "rint", "nearbyint"};
    const ir_function *function = ir_called_function(call);
    const library_function *found =
        function ? library_find(variable_facts_unit(b->facts), function) : NULL;
    for (unsigned i = 0; found && call->child_count == 2 && i < sizeof names / sizeof *names; i++)
        if (strcmp(found->name, names[i]) == 0) {
            *is_always = i < 2;
            return call->children[1];
        }
    return NULL;
}

/* Do the value's operands show that it is not negative, or a NaN? */
static bool is_sign_of_parts(bounding *b, const ir_node *node) {
    bool is_always = false;
    switch (node->kind) {
    case IR_BINARY:
        if (node->op == IR_OP_SUBTRACT) { /* v - least */
            const known_value left = value_of(b, node->children[0]);
            return left.has_least && left.least && is_unchanged(b, node->children[1]) &&
                   expression_same(left.least, node->children[1]);
        }
        if (node->op == IR_OP_MULTIPLY && expression_is_plain(node) &&
            expression_same(node->children[0], node->children[1]))
            return true;
        return (node->op == IR_OP_ADD || node->op == IR_OP_MULTIPLY) &&
               is_never_negative(b, node->children[0]) && is_never_negative(b, node->children[1]);
    case IR_CALL: {
        const ir_node *argument = keeps_sign(b, node, &is_always);
        return argument && (is_always || is_never_negative(b, argument));
    }
    default:
        return false;
    }
}

static bool is_never_negative(bounding *b, const ir_node *node) {
    if (!node->type)
        return false;
    if (node->type->kind != IR_FLOATING) {
        const value_bounds bounds = integer_of(b, node);
        return is_never_below_zero(&bounds);
    }
    if (node->kind == IR_NUMBER)
        return true; /* a literal is never negative, because a sign is an operator */
    if (is_unchanged(b, node))
        return require(b, node);
    if (node->kind == IR_VARIABLE) {
        const known_value known = used(b, node->variable);
        return known.has_least && (!known.least || require(b, known.least));
    }
    if (node->kind == IR_CAST)
        return is_never_negative(b, node->children[0]);
    return is_sign_of_parts(b, node);
}

static known_value value_of(bounding *b, const ir_node *node) {
    if (!node->type || node->type->kind != IR_FLOATING)
        return (known_value){.integer = integer_of(b, node)};
    if (node->kind == IR_VARIABLE && known_of(b, node->variable))
        return used(b, node->variable);
    if (is_unchanged(b, node))
        return (known_value){.has_least = true, .least = node};
    return (known_value){.has_least = is_never_negative(b, node)};
}

/* ---- statements ------------------------------------------------------------------------------ */

static void set(bounding *b, const ir_variable *variable, const ir_node *value) {
    known_value known = {0};
    b->needs = 0;
    if (is_tracked(b, variable) && variable->type->kind == IR_INTEGER)
        known.integer = integer_set(b, value, variable->type);
    else if (is_tracked(b, variable))
        known = value_of(b, value);
    /* converting to another floating type may round below `least`, but not below zero */
    if (known.least && value->type->size != variable->type->size)
        known.has_least = false;
    known.needs = b->needs;
    forget_all_written(b, value);
    if (is_tracked(b, variable))
        learn(b, variable, known);
}

/* Notes that variable <op> bound is true. */
static void refine(bounding *b, const ir_variable *variable, ir_operator op, const ir_node *bound) {
    known_value known = {0};
    if (!is_tracked(b, variable))
        return;
    if (known_of(b, variable))
        known = *known_of(b, variable);
    if (variable->type->kind == IR_FLOATING) {
        if ((op == IR_OP_GREATER || op == IR_OP_GREATER_EQUAL) && !known.has_least &&
            bound->type->kind == IR_FLOATING && bound->type->size == variable->type->size &&
            (is_unchanged(b, bound) || bound->kind == IR_NUMBER)) {
            known.has_least = true;
            known.least = bound->kind == IR_NUMBER ? NULL : bound;
        }
        learn(b, variable, known);
        return;
    }
    b->needs = 0;
    const value_bounds limit =
        ir_type_is_plain_integer(bound->type) && bound->type->is_signed && !bound->type->wraps
            ? integer_of(b, bound)
            : nothing_known();
    const int64_t open = op == IR_OP_LESS || op == IR_OP_GREATER;
    const bool is_above = op == IR_OP_GREATER || op == IR_OP_GREATER_EQUAL || op == IR_OP_EQUAL;
    const bool is_below = op == IR_OP_LESS || op == IR_OP_LESS_EQUAL || op == IR_OP_EQUAL;
    known.needs |= b->needs;
    if (is_above && !known.integer.low_count) {
        known.integer.low_count = limit.low_count;
        memcpy(known.integer.low, limit.low, sizeof limit.low);
        shift_ends(known.integer.low, &known.integer.low_count, open);
    }
    if (is_below && !known.integer.high_count) {
        known.integer.high_count = limit.high_count;
        memcpy(known.integer.high, limit.high, sizeof limit.high);
        shift_ends(known.integer.high, &known.integer.high_count, -open);
    }
    learn(b, variable, known);
}

/* Notes that the condition is true or, if `holds` is false, that it is false. If a comparison of
 * floating values is false, one of them may be a NaN, which has_least permits. */
static void suppose(bounding *b, const ir_node *condition, bool holds) {
    if (condition->kind != IR_BINARY || !expression_is_plain(condition))
        return;
    ir_operator op = holds ? condition->op : expression_negated(condition->op);
    const ir_node *left = condition->children[0], *right = condition->children[1];
    if (op < IR_OP_LESS || op > IR_OP_EQUAL)
        return;
    if (left->kind == IR_VARIABLE)
        refine(b, left->variable, op, right);
    if (right->kind == IR_VARIABLE)
        refine(b, right->variable, expression_mirrored(op), left);
}

/* Keeps the facts that are true after both branches. */
static void join(bounding *b, const known_values *other) {
    for (unsigned i = b->now.count; i-- > 0;) {
        known_value *item = &b->now.items[i];
        const known_value *there = NULL;
        for (unsigned k = 0; k < other->count; k++)
            if (other->items[k].variable == item->variable)
                there = &other->items[k];
        if (!there) {
            *item = b->now.items[--b->now.count];
            continue;
        }
        item->needs |= there->needs;
        item->integer = either(item->integer, there->integer);
        item->has_least &= there->has_least &&
                           (item->least && there->least ? expression_same(item->least, there->least)
                                                        : !item->least && !there->least);
    }
}

static void execute(bounding *b, const ir_node *statement, const ir_node *site);

/* Executes an `if` on the facts; stops at the site, if the statement contains it. */
static void execute_if(bounding *b, const ir_node *statement, const ir_node *site) {
    const ir_node *condition = statement->children[0];
    forget_all_written(b, condition);
    if (ir_contains(condition, site))
        return;
    const known_values before = b->now;
    suppose(b, condition, true);
    execute(b, statement->children[1], site);
    if (ir_contains(statement->children[1], site))
        return;
    const known_values then = b->now;
    b->now = before;
    suppose(b, condition, false);
    if (statement->child_count > 2) {
        execute(b, statement->children[2], site);
        if (ir_contains(statement->children[2], site))
            return;
    }
    join(b, &then);
}

static void execute_expression(bounding *b, const ir_node *node) {
    const bool is_plain_set =
        node->kind == IR_ASSIGN && node->op == IR_OP_NONE && node->children[0]->kind == IR_VARIABLE;
    if (is_plain_set)
        set(b, node->children[0]->variable, node->children[1]);
    else
        forget_all_written(b, node);
}

/* Executes the statement on the facts; stops at the site, if the statement contains it. */
static void execute(bounding *b, const ir_node *statement, const ir_node *site) {
    const bool is_last = ir_contains(statement, site);
    switch (statement->kind) {
    case IR_BLOCK:
        for (unsigned i = 0; i < statement->child_count; i++) {
            execute(b, statement->children[i], site);
            if (ir_contains(statement->children[i], site))
                return;
        }
        return;
    case IR_IF:
        execute_if(b, statement, site);
        return;
    case IR_DECLARATION:
        for (unsigned i = 0; i < statement->child_count && !is_last; i++)
            if (statement->children[i]->child_count)
                set(b, statement->children[i]->variable, statement->children[i]->children[0]);
            else
                forget_all_written(b, statement->children[i]);
        if (is_last)
            forget_all_written(b, statement);
        return;
    case IR_EXPRESSION:
        if (is_last) /* the statement's own assignments may happen before or after the site */
            forget_all_written(b, statement);
        else
            execute_expression(b, statement->children[0]);
        return;
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
    case IR_SWITCH:
        forget_all_written(b, statement);
        if (is_last && statement->kind != IR_SWITCH && ir_contains(ir_loop_body(statement), site))
            execute(b, ir_loop_body(statement), site);
        return;
    default:
        forget_all_written(b, statement);
        return;
    }
}

bool value_bounds_of(variable_facts *facts, const ir_function *function, const ir_node *value,
                     const ir_node *site, value_bounds *bounds, bounds_conditions *conditions) {
    bounding b = {.facts = facts, .function = function};
    const ir_node *body = function->body;
    if (!body || !ir_contains(body, site) || ir_has_kind(body, IR_LABEL) ||
        ir_has_kind(body, IR_GOTO) || ir_has_kind(body, IR_OPAQUE))
        return false;
    execute(&b, body, site);
    b.needs = 0;
    *bounds = integer_of(&b, value);
    *conditions = (bounds_conditions){0};
    for (unsigned i = 0; i < b.conditions.count; i++)
        if (b.needs >> i & 1)
            conditions->value[conditions->count++] = b.conditions.value[i];
    return bounds->low_count > 0 && bounds->high_count > 0;
}

bool element_bounds_has(const element_bounds *bounds, bound_term term) {
    for (unsigned i = 0; i < bounds->term_count; i++)
        if (is_same_term(bounds->terms[i], term))
            return true;
    return false;
}
