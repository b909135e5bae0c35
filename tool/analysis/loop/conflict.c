/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/conflict.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/loop/variation.h"

enum { DEEPEST = 8 }; /* greatest number of definitions that are followed */

typedef struct query {
    variable_facts *facts;
    const ir_node *loop;
    const ir_node *place; /* the access; the loops around it, inside `loop`, are the inner
                           * loops */
    unsigned depth;
} query;

/* The kinds of values in an address. */
typedef struct terms {
    bool has_window; /* counters of inner loops whose range changes with the iteration of
                      * `loop` */
    bool has_table;  /* values read from memory */
    bool has_row;    /* values that differ between iterations, in a separate subscript or as a
                      * factor (i * n), so that iterations have separate rows */
    bool has_own;    /* values that differ between iterations, as a summand: i + j */
    bool has_long;   /* counters of inner loops whose range is invariant */
    bool has_short;  /* counters of inner loops whose range is constant */
} terms;

static bool is_varying(const query *q, const ir_node *node) {
    return !variation_is_invariant(q->facts, q->loop, node);
}

/* The value of a statement expression ({ ...; value; }); NULL if the node is none. */
static const ir_node *value_of_statements(const ir_node *node) {
    const ir_node *block = ir_is_statement_expression(node) ? node->children[0] : NULL;
    const ir_node *last =
        block && block->child_count ? block->children[block->child_count - 1] : NULL;
    return last && last->kind == IR_EXPRESSION ? last->children[0] : NULL;
}

static const ir_node *without_casts(const ir_node *node) {
    const ir_node *value = value_of_statements(node);
    while (value || node->kind == IR_CAST || (node->kind == IR_UNARY && ir_is_increment(node))) {
        node = value ? value : node->children[0];
        value = value_of_statements(node);
    }
    return node;
}

/* ---- pointers ------------------------------------------------------------------------------- */

/* Returns the pointer p with which an address begins, as in p[k], *p, *(p + k) or p->m. Returns
 * NULL if the address begins with a variable or an array. *has_subscript is set to whether p may be
 * used to reach other elements than the first. */
static const ir_node *pointer_of(const ir_node *node, bool *has_subscript) {
    const ir_node *child = node->child_count ? without_casts(node->children[0]) : NULL;
    *has_subscript = false;
    if (node->kind == IR_INDEX && ir_is_pointer(child)) {
        *has_subscript = !(node->children[1]->flags & IR_HAS_VALUE);
        return child;
    }
    if (node->kind == IR_MEMBER)
        return (node->flags & IR_ARROW) && ir_is_pointer(child) ? child : NULL;
    if (node->kind != IR_UNARY || node->op != IR_OP_DEREFERENCE)
        return NULL;
    while (child->kind == IR_BINARY && ir_is_pointer(child)) {
        *has_subscript = true;
        child = without_casts(child->children[ir_is_pointer(child->children[0]) ? 0 : 1]);
    }
    return child;
}

/* The only value that the loop assigns to a local pointer; steps do not count. NULL if there is
 * none or more than one. */
static const ir_node *value_in_loop(const query *q, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(q->facts, variable);
    const ir_node *value = NULL;
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        const bool is_set = write->kind == IR_DECLARATOR
                                ? write->child_count > 0
                                : write->kind == IR_ASSIGN && write->op == IR_OP_NONE;
        if (!ir_contains(q->loop, write) || !is_set)
            continue;
        if (value)
            return NULL;
        value = write->children[write->kind == IR_DECLARATOR ? 0 : 1];
    }
    return value;
}

/* Is a pointer in the address loaded from memory, and does it vary with the iteration? The row
 * pointers in row[i][j] do not count: each row is treated as a separate array. */
static bool is_by_loaded_pointer(query *q, const ir_node *lvalue) {
    bool has_subscript;
    for (const ir_node *node = without_casts(lvalue); node;) {
        const ir_node *pointer = pointer_of(node, &has_subscript);
        if (!pointer) {
            node =
                node->child_count && ir_is_access(node) ? without_casts(node->children[0]) : NULL;
            continue;
        }
        if (pointer->kind == IR_VARIABLE && is_varying(q, pointer) && q->depth < DEEPEST) {
            const ir_node *value = value_in_loop(q, pointer->variable);
            q->depth++;
            pointer = value ? without_casts(value) : NULL;
            if (pointer && pointer->kind == IR_UNARY && pointer->op == IR_OP_ADDRESS)
                pointer = without_casts(pointer->children[0]);
            else if (pointer && ir_is_access(pointer) && is_varying(q, pointer) &&
                     !(has_subscript && pointer->kind == IR_INDEX))
                return true;
            node = pointer;
            continue;
        }
        const bool is_row = pointer->kind == IR_INDEX && has_subscript;
        if (ir_is_access(pointer) && !is_row && is_varying(q, pointer))
            return true;
        node = ir_is_access(pointer) ? pointer : NULL;
    }
    return false;
}

/* ---- ranges of inner loops ------------------------------------------------------------------- */

/* The value to which the header sets the variable; NULL if it does not set it. */
static const ir_node *start_in(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_DECLARATOR && node->variable == variable)
        return ir_child(node, 0);
    if (node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
        expression_is_variable(node->children[0], variable))
        return node->children[1];
    const ir_node *found = NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = start_in(node->children[i], variable);
    return found;
}

static bool mentions_written(const ir_node *node, const ir_node *header) {
    if (node->kind == IR_VARIABLE && variable_is_written_in(header, node->variable))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions_written(node->children[i], header))
            return true;
    return false;
}

/* The side of the condition that the inner loop's increment does not change; NULL if the condition
 * is no comparison. */
static const ir_node *bound_of(const ir_node *inner) {
    const ir_node *condition = inner->children[1];
    if (condition->kind == IR_EXPRESSION)
        condition = condition->children[0];
    if (condition->kind != IR_BINARY || condition->op < IR_OP_LESS ||
        condition->op > IR_OP_NOT_EQUAL)
        return NULL;
    const unsigned side = mentions_written(condition->children[0], inner->children[2]) ? 1 : 0;
    return condition->children[side];
}

static const ir_node *defined(const query *q, const ir_node *node) {
    node = without_casts(node);
    for (unsigned i = 0; i < DEEPEST && node->kind == IR_VARIABLE; i++) {
        const ir_node *value = variable_single_definition(q->facts, node->variable);
        if (!value || !ir_contains(q->loop, value))
            break;
        node = without_casts(value);
    }
    return node;
}

/* Is the range a segment: from first[i] to first[i + 1]? */
static bool is_segment(const query *q, const ir_node *start, const ir_node *bound) {
    int64_t one;
    start = defined(q, start);
    bound = defined(q, bound);
    if (start->kind != IR_INDEX || bound->kind != IR_INDEX ||
        !expression_same(start->children[0], bound->children[0]))
        return false;
    const ir_node *next = bound->children[1];
    return next->kind == IR_BINARY && next->op == IR_OP_ADD &&
           expression_same(next->children[0], start->children[1]) &&
           expression_constant(next->children[1], &one) && one == 1;
}

/* The inner `for` around the access whose header sets and steps the variable; NULL if there is
 * none. */
static const ir_node *inner_loop_of(const query *q, const ir_variable *variable) {
    for (const ir_node *outer = q->place->parent; outer && outer != q->loop; outer = outer->parent)
        if (outer->kind == IR_FOR && start_in(outer->children[0], variable) &&
            variable_is_written_in(outer->children[2], variable))
            return outer;
    return NULL;
}

/* ---- terms ---------------------------------------------------------------------------------- */

static void add_range(query *q, const ir_node *inner, const ir_variable *variable, terms *t) {
    assert(inner->kind == IR_FOR);
    const ir_variable *counter;
    int64_t first, last;
    const ir_node *start = start_in(inner->children[0], variable);
    const ir_node *bound = bound_of(inner);
    const bool varies = is_varying(q, start) || !bound || is_varying(q, bound);
    if (varies && bound && is_segment(q, start, bound))
        t->has_row = true;
    else if (varies)
        t->has_window = true;
    else if (counted_constant(inner, &counter, &first, &last))
        t->has_short = true;
    else
        t->has_long = true;
}

static void add_terms(query *q, const ir_node *node, bool is_factor, terms *t) {
    node = without_casts(node);
    if (!is_varying(q, node))
        return;
    if (node->kind == IR_VARIABLE) {
        const ir_node *inner = inner_loop_of(q, node->variable);
        const ir_node *value = variable_single_definition(q->facts, node->variable);
        if (inner) {
            add_range(q, inner, node->variable, t);
        } else if (value && ir_contains(q->loop, value) && q->depth < DEEPEST) {
            q->depth++;
            add_terms(q, value, is_factor, t);
            q->depth--;
        } else {
            *(is_factor ? &t->has_row : &t->has_own) = true;
        }
        return;
    }
    if (node->kind != IR_BINARY && node->kind != IR_UNARY) {
        t->has_table = true;
        return;
    }
    const bool is_sum =
        node->kind == IR_UNARY || node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT;
    for (unsigned i = 0; i < node->child_count; i++)
        add_terms(q, node->children[i], is_factor || !is_sum, t);
}

static void add_all(terms *to, const terms *from) {
    to->has_window |= from->has_window;
    to->has_table |= from->has_table;
    to->has_row |= from->has_row;
    to->has_own |= from->has_own;
    to->has_long |= from->has_long;
    to->has_short |= from->has_short;
}

static bool has_address(const ir_node *node) {
    return ir_is_pointer(node) || ir_is_array(node);
}

/* Returns the terms of the address. Subscripts are examined one by one, the last one first. If a
 * subscript differs between iterations and the inner loops' counters are in other subscripts only,
 * iterations have separate rows (has_row). */
static terms terms_of(query *q, const ir_node *lvalue) {
    terms all = {0};
    const ir_node *node = without_casts(lvalue);
    while (node && (ir_is_access(node) || node->kind == IR_BINARY || node->kind == IR_VARIABLE)) {
        terms own = {0};
        const ir_node *next = node->child_count ? node->children[0] : NULL;
        if (node->kind == IR_INDEX) {
            add_terms(q, node->children[1], false, &own);
        } else if (node->kind == IR_BINARY) {
            const unsigned side = has_address(node->children[0]) ? 1 : 0;
            add_terms(q, node->children[side], false, &own);
            next = node->children[1 - side];
        } else if (node->kind == IR_VARIABLE) {
            const ir_node *value = ir_is_pointer(node) && is_varying(q, node) && q->depth < DEEPEST
                                       ? value_in_loop(q, node->variable)
                                       : NULL;
            if (value && variable_fact_of(q->facts, node->variable)->write_count > 1)
                own.has_long = true; /* the pointer steps through the elements */
            else if (!value && ir_is_pointer(node) && is_varying(q, node))
                own.has_row = true;
            q->depth++;
            next = value && value->kind == IR_UNARY && value->op == IR_OP_ADDRESS
                       ? value->children[0]
                       : value;
        }
        if ((all.has_window || all.has_long || all.has_short) && own.has_own && !own.has_window &&
            !own.has_long)
            own.has_row = true;
        if (own.has_window && all.has_own)
            all.has_row = true;
        add_all(&all, &own);
        node = next ? without_casts(next) : NULL;
        if (node && node->kind == IR_UNARY && node->op == IR_OP_ADDRESS) /* *&h[k], from a call */
            node = without_casts(node->children[0]);
    }
    return all;
}

/* Classifies an opaque access, such as an element of a vector, or a selection
 * `_Generic(0, int: h[k])`. */
static conflict_kind conflict_of_opaque(variable_facts *facts, const ir_node *loop,
                                        const ir_node *opaque, const ir_node *place) {
    conflict_kind worst = CONFLICT_NONE;
    for (unsigned i = 0; i < opaque->child_count; i++) {
        const conflict_kind kind = conflict_at(facts, loop, opaque->children[i], place);
        worst = kind > worst ? kind : worst;
    }
    return worst;
}

const ir_node *conflict_whole(const ir_node *lvalue) {
    while ((lvalue->kind == IR_OPAQUE && lvalue->child_count) || ir_is_complex_part(lvalue))
        lvalue = lvalue->children[0];
    return lvalue;
}

conflict_kind conflict_at(variable_facts *facts, const ir_node *loop, const ir_node *lvalue,
                          const ir_node *place) {
    if (lvalue->kind == IR_OPAQUE)
        return conflict_of_opaque(facts, loop, lvalue, place);
    if (ir_is_complex_part(lvalue))
        return conflict_at(facts, loop, lvalue->children[0], place);
    query q = {facts, loop, place, 0};
    assert(ir_is_loop(loop));
    if (!expression_is_lvalue(lvalue))
        return CONFLICT_NONE;
    if (variation_is_irregular(facts, loop, lvalue))
        return CONFLICT_SHARED;
    if (lvalue->kind == IR_VARIABLE || !is_varying(&q, lvalue))
        return CONFLICT_NONE;
    if (is_by_loaded_pointer(&q, lvalue))
        return CONFLICT_SHARED;
    q.depth = 0;
    const terms t = terms_of(&q, lvalue);
    if (t.has_table)
        return CONFLICT_SHARED;
    if (t.has_row)
        return CONFLICT_NONE;
    if (t.has_window)
        return CONFLICT_SHARED;
    return t.has_long || (t.has_own && t.has_short) ? CONFLICT_REGULAR : CONFLICT_NONE;
}
