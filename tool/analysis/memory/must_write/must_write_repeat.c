/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Recognises reads of elements that an earlier loop has written, whatever the loops' bounds are:
 *
 *     for (x = lo; x <= hi; x++) w[x - lo] = weight(x);
 *     for (x = lo; x <= hi; x++) h[x] += w[x - lo];
 *
 * If two loops have equal headers, nothing in the headers changes between them, and their bodies do
 * not write the counters, then both counters take the same values. Equal subscripts then name the
 * same elements in the same order. The writing loop has no jumps, so it writes all of these
 * elements; the reading loop may read only some.
 *
 *     for (p = w, x = lo; x <= hi; x++) *p++ = weight(x);
 *     for (q = w, x = lo; x <= hi; x++) h[x] += *q++;
 *
 * A pointer counts as a counter too: it takes the same values if it starts at the same address. A
 * counter may also be set before its loop and stepped in the body, if each iteration does so once,
 * after all other uses (must_write_walk.c). */
#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/step_inside.h"
#include "analysis/memory/must_write/must_write_run.h"
#include "analysis/memory/must_write/must_write_walk.h"

enum { MOST_COUNTERS = 4 };

typedef struct twin_loops {
    const run *r;
    const ir_node *writer, *reader;
    const ir_node *block; /* block that contains the writer; the reader is in a later statement of
                           * this block */
    unsigned first, last; /* numbers of statements in the block. The first is the writer, or an
                           * earlier statement that sets a counter. The last contains the
                           * reader */
    unsigned counter_count;
    struct {
        const ir_variable *of_writer, *of_reader;
    } counters[MOST_COUNTERS];
} twin_loops;

static bool is_number_or_pointer(const ir_type *type) {
    return type && (ir_type_is_plain_integer(type) || type->kind == IR_POINTER);
}

/* Is the variable a local integer or pointer that changes only by name? */
static bool is_plain(const run *r, const ir_variable *variable) {
    return run_variable_place(r, variable).kind == PLACE_LOCAL &&
           is_number_or_pointer(variable->type);
}

static bool is_unchanged(const twin_loops *twins, const ir_variable *variable) {
    for (unsigned i = twins->first; i <= twins->last; i++)
        if (variable_is_written_in(twins->block->children[i], variable))
            return false;
    return is_plain(twins->r, variable);
}

static bool same_variable(const twin_loops *twins, const ir_variable *a, const ir_variable *b) {
    for (unsigned i = 0; i < twins->counter_count; i++)
        if (twins->counters[i].of_writer == a || twins->counters[i].of_reader == b)
            return twins->counters[i].of_writer == a && twins->counters[i].of_reader == b;
    return a == b && is_unchanged(twins, a);
}

static bool same_tree(const twin_loops *twins, const ir_node *a, const ir_node *b);

/* Are both nodes of the form &p[i] (or &w[i]), with equal arrays and subscripts? */
static bool same_address_of(const twin_loops *twins, const ir_node *a, const ir_node *b) {
    return a->children[0]->kind == IR_INDEX && b->children[0]->kind == IR_INDEX &&
           same_tree(twins, a->children[0]->children[0], b->children[0]->children[0]) &&
           same_tree(twins, a->children[0]->children[1], b->children[0]->children[1]);
}

/* Are the trees equal, if counters of the two loops count as equal and all other variables are
 * unchanged between the loops? The array's own name counts as its address. Neither tree may read
 * memory. */
static bool same_tree(const twin_loops *twins, const ir_node *a, const ir_node *b) {
    if (expression_is_variable(a, twins->r->object))
        return expression_is_variable(b, twins->r->object) && a->type->kind == IR_ARRAY;
    if (a->kind != b->kind || a->op != b->op || a->child_count != b->child_count ||
        !is_number_or_pointer(a->type) || !ir_type_equal(a->type, b->type))
        return false;
    switch (a->kind) {
    case IR_NUMBER:
        return (a->flags & b->flags & IR_HAS_VALUE) != 0 && a->value == b->value;
    case IR_VARIABLE:
        return same_variable(twins, a->variable, b->variable);
    case IR_UNARY:
        if (a->op == IR_OP_ADDRESS)
            return same_address_of(twins, a, b);
        if (a->op == IR_OP_DEREFERENCE)
            return false;
        break;
    case IR_BINARY:
    case IR_ASSIGN:
    case IR_CONDITIONAL:
    case IR_CAST:
        break;
    default:
        return false;
    }
    for (unsigned i = 0; i < a->child_count; i++)
        if (!same_tree(twins, a->children[i], b->children[i]))
            return false;
    return true;
}

/* Adds the pair of counters a and b, which the writer sets to `start` and the reader sets to
 * `other`. Returns false if these values may differ, or if the pair cannot be added. */
static bool add_counter(twin_loops *twins, const ir_variable *a, const ir_node *start,
                        const ir_variable *b, const ir_node *other) {
    if (twins->counter_count == MOST_COUNTERS || !is_plain(twins->r, a) || !is_plain(twins->r, b) ||
        !ir_type_equal(a->type, b->type) || !expression_is_plain(start) ||
        !same_tree(twins, start, other))
        return false;
    for (unsigned i = 0; i < twins->counter_count; i++)
        if (twins->counters[i].of_writer == a || twins->counters[i].of_reader == b)
            return false;
    twins->counters[twins->counter_count].of_writer = a;
    twins->counters[twins->counter_count++].of_reader = b;
    return true;
}

static bool same_start(twin_loops *twins, const ir_node *a, const ir_node *b) {
    if (a->kind != b->kind || a->op != b->op || a->child_count != b->child_count)
        return false;
    if (a->kind == IR_DECLARATOR)
        return a->child_count == 1 &&
               add_counter(twins, a->variable, a->children[0], b->variable, b->children[0]);
    if (a->kind == IR_ASSIGN)
        return a->op == IR_OP_NONE && a->children[0]->kind == IR_VARIABLE &&
               b->children[0]->kind == IR_VARIABLE &&
               add_counter(twins, a->children[0]->variable, a->children[1],
                           b->children[0]->variable, b->children[1]);
    if (a->kind != IR_DECLARATION && a->kind != IR_EXPRESSION &&
        (a->kind != IR_BINARY || a->op != IR_OP_COMMA))
        return false;
    for (unsigned i = 0; i < a->child_count; i++)
        if (!same_start(twins, a->children[i], b->children[i]))
            return false;
    return true;
}

/* The pointer p of an element *p, *p++ or p[k]; NULL if the element has another form. */
static const ir_variable *pointer_of(const ir_node *element) {
    const ir_node *address = element->child_count ? element->children[0] : element;
    if (is_step_afterwards(address))
        address = address->children[0];
    return address->kind == IR_VARIABLE && address->type->kind == IR_POINTER ? address->variable
                                                                             : NULL;
}

static bool header_sets(const ir_node *loop, const ir_variable *variable) {
    return variable_is_written_in(loop->children[0], variable) ||
           ir_declarator_in(loop->children[0], variable);
}

/* Adds pointers that are set by statements before the loops: p = w; for (...) *p++ = ...; The
 * values must not mention counters, which the headers have not set at that time. Returns false if
 * such a pointer has no equal start in both loops. */
static bool add_earlier_start(twin_loops *twins, const ir_variable *a, const ir_variable *b) {
    unsigned number;
    if (!a || !b || header_sets(twins->writer, a) || header_sets(twins->reader, b) ||
        (!variable_is_written_in(twins->writer, a) && !variable_is_written_in(twins->reader, b)))
        return true;
    const ir_node *start = start_before(twins->writer, a, &number);
    if (start && number < twins->first)
        twins->first = number;
    const ir_node *other = start_before(twins->reader, b, &number);
    if (other && twins->reader->parent == twins->block && number < twins->first)
        twins->first = number;
    return start && other && add_counter(twins, a, start, b, other);
}

/* Do the two bodies step these counters in the same way, or not at all? */
static bool same_steps(const twin_loops *twins, const ir_variable *a, const ir_variable *b) {
    ir_node *const *writer = twins->writer->children, *const *reader = twins->reader->children;
    if (!variable_is_written_in(writer[3], a) && !variable_is_written_in(reader[3], b))
        return true;
    const ir_node *step = step_of_body(writer[3], a), *other = step_of_body(reader[3], b);
    return step && other && same_tree(twins, step, other);
}

static bool same_headers(twin_loops *twins, const ir_node *element, const ir_node *read) {
    ir_node *const *a = twins->writer->children, *const *b = twins->reader->children;
    twins->counter_count = 0;
    if (!add_earlier_start(twins, pointer_of(element), pointer_of(read)) ||
        !same_start(twins, a[0], b[0]) || a[1]->kind == IR_EMPTY || b[1]->kind == IR_EMPTY ||
        !expression_is_plain(a[1]) || !same_tree(twins, a[1], b[1]) || a[2]->kind == IR_EMPTY ||
        b[2]->kind == IR_EMPTY || !same_tree(twins, a[2], b[2]))
        return false;
    for (unsigned i = 0; i < twins->counter_count; i++)
        if (!same_steps(twins, twins->counters[i].of_writer, twins->counters[i].of_reader))
            return false;
    return true;
}

static bool may_jump(const ir_node *node) {
    return ir_is_jump(node) || node->kind == IR_LABEL || node->kind == IR_OPAQUE;
}

/* Do both nodes name the same element w[k], p[k] or *p? If a pointer is stepped in the expression
 * (*p++), its value before the step is compared. */
static bool same_element(const twin_loops *twins, const ir_node *a, const ir_node *b) {
    const bool is_indexed = a->kind == IR_INDEX;
    if (a->kind != b->kind || a->op != b->op || !ir_type_equal(a->type, b->type))
        return false;
    const ir_node *address = a->children[0], *other = b->children[0];
    if (is_step_afterwards(address))
        address = address->children[0];
    if (is_step_afterwards(other))
        other = other->children[0];
    return same_tree(twins, address, other) &&
           (!is_indexed || same_tree(twins, a->children[1], b->children[1]));
}

static bool is_element(const ir_node *node) {
    return node->kind == IR_INDEX || (node->kind == IR_UNARY && node->op == IR_OP_DEREFERENCE);
}

/* Is the statement, a direct part of the writer's body, an assignment `element = ...;` to the
 * element that is read? */
static bool writes_element(twin_loops *twins, const ir_node *statement, const ir_node *read) {
    const ir_node *assign = statement->kind == IR_EXPRESSION ? statement->children[0] : statement;
    return assign->kind == IR_ASSIGN && assign->op == IR_OP_NONE &&
           is_element(assign->children[0]) && same_headers(twins, assign->children[0], read) &&
           same_element(twins, assign->children[0], read);
}

static bool are_twins(twin_loops *twins, const ir_node *read) {
    const ir_node *body = twins->writer->children[3];
    if (ir_any(twins->writer, may_jump))
        return false;
    if (body->kind != IR_BLOCK)
        return writes_element(twins, body, read);
    for (unsigned i = 0; i < body->child_count; i++)
        if (writes_element(twins, body->children[i], read))
            return true;
    return false;
}

/* Does a writer precede the loop `reader`? The writer must be an earlier statement of a block
 * around that loop, so that control reaches the loop only through the writer. Blocks of a switch
 * are skipped, because a case may jump past the writer. */
static bool has_writer(const run *r, const ir_node *reader, const ir_node *read) {
    for (const ir_node *at = reader; at != r->body; at = at->parent) {
        const ir_node *block = at->parent;
        if (!block || (block->kind != IR_BLOCK && block->kind != IR_IF && !ir_is_loop(block)))
            return false;
        if (block->kind != IR_BLOCK || !block->parent || block->parent->kind == IR_SWITCH)
            continue;
        unsigned last = 0;
        while (block->children[last] != at)
            last++;
        for (unsigned i = 0; i < last; i++) {
            twin_loops twins = {.r = r,
                                .writer = block->children[i],
                                .reader = reader,
                                .block = block,
                                .first = i,
                                .last = last};
            if (twins.writer->kind == IR_FOR && are_twins(&twins, read))
                return true;
        }
    }
    return false;
}

bool run_repeats_write(const run *r, const ir_node *read) {
    if (!r->object || !r->body || !is_element(read) || !ir_type_is_scalar(read->type))
        return false;
    for (const ir_node *at = read; at != r->body; at = at->parent) {
        const ir_node *above = at->parent;
        if (!above)
            return false;
        if (above->kind == IR_FOR && above->children[3] == at && has_writer(r, above, read))
            return true;
    }
    return false;
}
