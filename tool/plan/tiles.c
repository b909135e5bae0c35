/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/tiles.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/stepped.h"
#include "analysis/overlap/row_address.h"
#include "ir/ir_syntax.h"
#include "plan/fresh.h"
#include "plan/lookup.h"

typedef struct pairs {
    const loop_plan *plan;
    const loop_facts *facts;
    loop_span span; /* the inner loop */
    const ir_variable *row, *column;
} pairs;

/* ---- the nest -------------------------------------------------------------------------------- */

static bool holds_update(const loop_facts *facts, const ir_node *node) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(node, facts->updates[i].statement))
            return true;
    return false;
}

static bool is_of_constants(const ir_node *loop) {
    const ir_variable *counter;
    int64_t first, last;
    return counted_constant(loop, &counter, &first, &last);
}

/** The inner loop, which is the body itself or one of its statements. */
static const ir_node *find_inner(const loop_facts *facts, const ir_node *node) {
    if (node->kind == IR_FOR)
        return is_of_constants(node) || !holds_update(facts, node) ? NULL : node;
    for (unsigned i = node->child_count; node->kind == IR_BLOCK && i-- > 0;) {
        const ir_node *found = find_inner(facts, node->children[i]);
        if (found)
            return found;
    }
    return NULL;
}

static bool is_number_of(const ir_type *type) {
    return ir_type_is_plain_integer(type) && type->size >= 4;
}

/** Is the node `row + c` with c >= 0, and does the sum not wrap around? It does not if c is at most
 *  the step, because the counter plus the step stays in the counter's type. Sets *offset to c. */
static bool is_row_plus(const pairs *p, const ir_node *node, int64_t *offset) {
    *offset = 0;
    if (expression_is_variable(node, p->row))
        return true;
    if (node->kind != IR_BINARY || node->op != IR_OP_ADD ||
        !ir_type_equal(node->type, p->row->type))
        return false;
    for (unsigned i = 0; i < 2; i++)
        if (expression_is_variable(node->children[i], p->row) &&
            expression_constant(node->children[1 - i], offset) && *offset >= 0)
            return ir_type_never_wraps(p->row->type) || *offset <= p->facts->counted.step;
    return false;
}

/** Is the bound a macro's name, and is this name the whole text between `<` or `<=` and the `;` of
 * the condition? */
static bool is_named_bound(const pairs *p, const ir_node *node, const ir_node *loop) {
    const ir_node *condition = loop->children[1];
    const source *text = p->plan->unit->source;
    uint32_t before = node->range.begin;
    if (!text || condition->kind != IR_BINARY || !ir_contains(condition->children[1], node) ||
        (condition->op != IR_OP_LESS && condition->op != IR_OP_LESS_EQUAL) ||
        condition->children[0]->flags & (IR_FROM_MACRO | IR_FROM_CALL))
        return false;
    for (uint32_t at = before; at < node->range.end; at++)
        if (!source_is_name_byte(text->text[at]))
            return false;
    while (before > loop->range.begin && text->text[before - 1] == ' ')
        before--;
    const uint32_t end = source_skip_blanks(text, node->range.end, loop->range.end);
    return text->text[end] == ';' &&
           text->text[before - 1] == (condition->op == IR_OP_LESS ? '<' : '=');
}

/** Is the node in the text of the loop's header, where it can be replaced? */
static bool is_editable(const pairs *p, const ir_node *node, const ir_node *loop) {
    return node && !(node->flags & IR_FROM_CALL) && node->range.begin < node->range.end &&
           loop->range.begin < node->range.begin &&
           node->range.end <= loop->children[3]->range.begin &&
           (!(node->flags & IR_FROM_MACRO) || is_named_bound(p, node, loop));
}

/** Are the first row and the first column equal modulo the step? If not, the columns' numbers lie
 * between the rows' numbers. */
static bool begin_together(const counted_loop *outer, const counted_loop *inner) {
    int64_t row, column;
    return outer->step == 1 || (outer->lower && expression_constant(outer->lower, &row) &&
                                expression_constant(inner->lower, &column) && row >= 0 &&
                                column >= 0 && row % outer->step == column % outer->step);
}

/** The reason why the pairs do not form a triangle, or NULL if they do. In a triangle no column is
 * less than its row, or no column is greater than its row. */
static const char *check_header(const pairs *p, tile_plan *tiles) {
    const counted_loop *outer = &p->facts->counted, *inner = &p->span.counted;
    int64_t offset;
    if (p->facts->loop->kind != IR_FOR || outer->step < 1 || outer->stride ||
        !is_number_of(p->row->type))
        return "its counter does not pass through integers at equal distances";
    if (inner->step != outer->step || inner->stride || inner->start_count > 0 || inner->ahead ||
        inner->bound_variable || !ir_type_equal(p->row->type, p->column->type))
        return "the counters of the two loops differ";
    if (!is_editable(p, inner->lower, p->span.loop) || !is_editable(p, inner->bound, p->span.loop))
        return "the bounds of the inner loop are not in its text";
    tiles->is_inclusive = inner->comparison == IR_OP_LESS_EQUAL;
    tiles->lower = inner->lower;
    tiles->bound = inner->bound;
    if (is_row_plus(p, inner->lower, &offset))
        return offset % outer->step == 0 ? NULL : "columns lie between rows";
    tiles->is_below = true;
    if (!is_row_plus(p, inner->bound, &offset) || offset + tiles->is_inclusive > 1)
        return "columns may be above and below their rows";
    return begin_together(outer, inner) ? NULL : "columns lie between rows";
}

/* ---- effects --------------------------------------------------------------------------------- */

static bool may_leave(const ir_node *node, bool is_inside) {
    if (node->kind == IR_GOTO || node->kind == IR_LABEL || node->kind == IR_RETURN ||
        node->kind == IR_OPAQUE || (node->kind == IR_BREAK && !is_inside))
        return true;
    is_inside |= ir_is_loop(node) || node->kind == IR_SWITCH;
    for (unsigned i = 0; i < node->child_count; i++)
        if (may_leave(node->children[i], is_inside))
            return true;
    return false;
}

/** Does the statement, apart from updates and sums of scalars, write only variables? It must
 * contain no `continue`, and no loops except those with constant bounds. */
static bool only_computes(const pairs *p, const ir_node *node) {
    const ir_node *written = expression_written(node);
    const reduction_update *update = loop_update_at(p->facts, node);
    if (update)
        return !update->last && update->statement->kind != IR_DECLARATOR;
    if (scalar_update_at(p->facts, node) >= 0)
        return true;
    if (node->kind == IR_CONTINUE || (written && !expression_object(written)) ||
        (ir_is_loop(node) && !is_of_constants(node)))
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!only_computes(p, node->children[i]))
            return false;
    return true;
}

/** Is only_computes true for all statements before and after the inner loop, in the blocks around
 * that loop? */
static bool row_only_computes(const pairs *p) {
    for (const ir_node *node = p->span.loop; node != p->facts->counted.body; node = node->parent)
        for (unsigned i = 0; i < node->parent->child_count; i++)
            if (node->parent->children[i] != node && !only_computes(p, node->parent->children[i]))
                return false;
    return true;
}

/** Do the statements after the inner loop read the value that the variable has when it ends? */
static bool is_read_after(const pairs *p, const ir_variable *variable) {
    for (const ir_node *node = p->span.loop; node != p->facts->counted.body; node = node->parent)
        for (unsigned i = node->parent->child_count; node->parent->children[--i] != node;)
            if (expression_mentions(node->parent->children[i], variable) &&
                !is_fresh_in(node->parent->children[i], variable))
                return true;
    return false;
}

static bool is_written_in(const ir_node *node, const ir_variable *variable) {
    const ir_node *written = expression_written(node);
    if (written && expression_object(written) == variable)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_written_in(node->children[i], variable))
            return true;
    return false;
}

/** May a statement before the inner loop assign the variable? */
static bool is_set_before(const pairs *p, const ir_variable *variable) {
    for (const ir_node *node = p->span.loop; node != p->facts->counted.body; node = node->parent)
        for (unsigned i = 0; node->parent->children[i] != node; i++) {
            const ir_node *before = node->parent->children[i];
            const ir_node *declarator = ir_declarator_in(before, variable);
            if (is_written_in(before, variable) || (declarator && declarator->child_count > 0) ||
                (variable->address_taken && expression_mentions(before, variable)))
                return true;
        }
    return false;
}

/** Adds the variable to tiles->kept[], whose values are kept from tile to tile. Returns false if it
 * cannot be kept. */
static bool keep(const pairs *p, tile_plan *tiles, const private_variable *item) {
    const ir_variable *variable = item->variable;
    enum { MOST_BYTES = 128 };
    const ir_type *type = variable->type;
    if (variable->has_other_name || !type->spelling || type->size <= 0 || type->size > MOST_BYTES ||
        type->kind == IR_POINTER || type->kind == IR_BOOLEAN ||
        (variable->storage != IR_LOCAL && variable->storage != IR_PARAMETER) ||
        tiles->kept_count == TILES_MOST_KEPT)
        return false;
    tiles->kept[tiles->kept_count++] =
        (kept_value){variable, !item->is_stepped && !is_set_before(p, variable)};
    return true;
}

/** May an inner iteration, or the inner loop's header, leave a value in the variable that is read
 *  by a later inner iteration or after the inner loop? */
static bool may_be_left(const pairs *p, const ir_variable *variable) {
    const ir_node *const step = p->span.loop->children[2]; /* executed after each inner iteration */
    return variable->address_taken ||
           (is_written_in(p->span.loop, variable) &&
            (is_read_after(p, variable) || expression_mentions(step, variable) ||
             !is_fresh_in(ir_loop_body(p->span.loop), variable)));
}

/** Lists in tiles->kept[] the iteration's variables in which inner iterations leave values.
 * Variables declared in the inner loop are left out, because each inner iteration has new ones.
 * Returns false if a variable cannot be kept. */
static bool keep_values(const pairs *p, tile_plan *tiles) {
    const loop_variables *variables = &p->facts->variables;
    for (unsigned i = 0; i < variables->private_count; i++) {
        const ir_variable *variable = variables->privates[i].variable;
        const bool is_named = expression_mentions(p->span.loop, variable);
        if (ir_declarator_in(p->span.loop, variable) || (!is_named && !variable->address_taken))
            continue;
        if (variable == p->column ? is_read_after(p, variable)
                                  : may_be_left(p, variable) &&
                                        !(is_named && keep(p, tiles, &variables->privates[i])))
            return false;
    }
    return true;
}

static bool has_other_results(const loop_facts *facts) {
    const loop_exits *exits = facts->slice.exits;
    return has_live_outs(facts) || has_conditional_live_outs(facts) || facts->forward_count > 0 ||
           facts->variables.own_count > 0 ||
           (facts->distribution && facts->distribution->count > 0) || (exits && exits->count > 0) ||
           facts->slice.may_abort;
}

static bool sums_are_in_order(const pairs *p) {
    for (unsigned i = 0; i < p->facts->scalar_count; i++) {
        const scalar_update *scalar = &p->facts->scalars[i];
        const bool is_in_turn = ir_contains(p->span.loop, scalar->statement);
        if (scalar->is_extremum || (is_in_turn && !(scalar->is_series || scalar->is_repeated)))
            return false;
    }
    return true;
}

/* ---- elements -------------------------------------------------------------------------------- */

/** The bytes at addresses by_row * row + by_column * column + [low, high). */
typedef struct element {
    int64_t by_row, by_column, low, high;
} element;

static bool add(int64_t *sum, int64_t value, int64_t times) {
    int64_t product;
    return !__builtin_mul_overflow(value, times, &product) &&
           !__builtin_add_overflow(*sum, product, sum);
}

/** Adds `bytes` times a value in [low, high] to the address. */
static bool add_range(element *e, int64_t low, int64_t high, int64_t bytes) {
    return add(&e->low, bytes < 0 ? high : low, bytes) &&
           add(&e->high, bytes < 0 ? low : high, bytes);
}

static bool add_term(const pairs *p, const ir_node *node, int64_t bytes, element *e);

/** Adds the result of an operator to the address. The result's type must have 64 bits, so that it
 * wraps around as addresses do, or must never wrap around. */
static bool add_operation(const pairs *p, const ir_node *node, int64_t bytes, element *e) {
    int64_t factor, times;
    if (!is_number_of(node->type) || !(ir_type_never_wraps(node->type) || node->type->size == 8))
        return false;
    switch (node->op) {
    case IR_OP_ADD:
        return add_term(p, node->children[0], bytes, e) && add_term(p, node->children[1], bytes, e);
    case IR_OP_SUBTRACT:
        return add_term(p, node->children[0], bytes, e) &&
               add_term(p, node->children[1], -bytes, e);
    case IR_OP_MULTIPLY:
        for (unsigned i = 0; i < 2; i++)
            if (expression_constant(node->children[i], &factor) &&
                !__builtin_mul_overflow(bytes, factor, &times))
                return add_term(p, node->children[1 - i], times, e);
        return false;
    default:
        return false;
    }
}

static bool add_term(const pairs *p, const ir_node *node, int64_t bytes, element *e) {
    int64_t low, high;
    if (bytes == INT64_MIN)
        return false;
    if (expression_is_variable(node, p->row))
        return add(&e->by_row, bytes, 1);
    if (expression_is_variable(node, p->column))
        return add(&e->by_column, bytes, 1);
    if (counted_range(node, &low, &high))
        return add_range(e, low, high, bytes);
    if (node->kind == IR_CAST && node->type->size == 8 && ir_type_is_plain_integer(node->type) &&
        is_number_of(node->children[0]->type))
        return add_term(p, node->children[0], bytes, e);
    return node->kind == IR_BINARY && add_operation(p, node, bytes, e);
}

static bool find_element(const pairs *p, const reduction_update *update, element *e) {
    row_address address;
    *e = (element){0};
    if (!row_address_of(update->row, &address) || update->row->type->size <= 0 ||
        !syntax_same(address.base, p->facts->arrays[update->array].base))
        return false;
    e->low = e->high = address.offset;
    for (unsigned i = 0; i < address.term_count; i++)
        if (!add_term(p, address.terms[i].subscript, address.terms[i].bytes, e))
            return false;
    return add(&e->high, update->row->type->size, 1);
}

/** Does each update of the array change only bytes of the element whose number is the pair's row or
 *  column? The elements must not overlap: the bytes that updates change lie within one stride. */
static bool has_elements(const pairs *p, unsigned array) {
    int64_t stride = 0, low = INT64_MAX, high = INT64_MIN, span;
    for (unsigned i = 0; i < p->facts->update_count; i++) {
        const reduction_update *update = &p->facts->updates[i];
        element e;
        if (update->array != array)
            continue;
        if (!find_element(p, update, &e) || (e.by_row != 0) == (e.by_column != 0) ||
            (e.by_column != 0 && !ir_contains(p->span.loop, update->statement)))
            return false;
        int64_t by = 0;
        if (!add(&by, e.by_row + e.by_column, p->facts->counted.step) || by <= 0 ||
            (stride > 0 && by != stride))
            return false;
        stride = by;
        low = e.low < low ? e.low : low;
        high = e.high > high ? e.high : high;
    }
    return stride > 0 && !__builtin_sub_overflow(high, low, &span) && span <= stride;
}

static const char *check_elements(const pairs *p) {
    for (unsigned i = 0; i < p->facts->array_count; i++)
        if (p->facts->arrays[i].is_scattered || !has_elements(p, i))
            return "an update is not of the element of its row or of its column";
    return NULL;
}

/* ---- all of it ------------------------------------------------------------------------------- */

static const char *why_not(const loop_plan *plan, tile_plan *tiles) {
    const loop_facts *facts = plan->facts;
    pairs p = {.plan = plan, .facts = facts, .row = facts->counted.counter};
    tiles->inner = find_inner(facts, facts->counted.body);
    if (!tiles->inner || !span_recognise((ir_node *)tiles->inner, &p.span) || p.span.other_count)
        return "it is no loop over pairs";
    tiles->column = p.column = p.span.counted.counter;
    const char *why = check_header(&p, tiles);
    if (why)
        return why;
    if (!facts->inspector.exists)
        return "its subscripts cannot be computed before the loop";
    if (plan->precheck != PRECHECK_NONE)
        return "its subscripts must be checked in order before the loop";
    if (may_leave(facts->counted.body, false) || may_leave(ir_loop_body(tiles->inner), false))
        return "its inner loop may end early";
    if (has_other_results(facts) || !sums_are_in_order(&p))
        return "it has other results than updates and sums";
    if (!row_only_computes(&p))
        return "a row has effects other than updates of its element";
    if (!keep_values(&p, tiles))
        return "a value that an inner iteration leaves cannot be kept from tile to tile";
    return check_elements(&p);
}

void plan_tiles(loop_plan *plan) {
    tile_plan *tiles = ARENA_NEW(plan->arena, tile_plan);
    *tiles = (tile_plan){0};
    tiles->declined = why_not(plan, tiles);
    plan->tiles = tiles;
}
