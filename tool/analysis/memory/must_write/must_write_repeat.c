/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Elements that an earlier loop has written, whatever its bounds:
 *
 *     for (x = lo; x <= hi; x++) w[x - lo] = weight(x);
 *     for (x = lo; x <= hi; x++) h[x] += w[x - lo];
 *
 * Two loops with the same header pass through the same values of their counters, as long as nothing
 * else in it changes between them and their bodies leave the counters alone. A subscript that is
 * the same in both then names the same elements, one after the other. The writer writes all of
 * them, since it has no jumps; the reader reads some. */
#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/memory/must_write/must_write_run.h"

enum { MOST_COUNTERS = 4 };

typedef struct twin_loops {
    const run *r;
    const ir_node *writer, *reader;
    const ir_node *block; /* of the writer; the reader is in a later statement of it */
    unsigned first, last; /* the statements from the writer on up to that with the reader */
    unsigned counter_count;
    struct {
        const ir_variable *of_writer, *of_reader;
    } counters[MOST_COUNTERS];
} twin_loops;

/* A local integer that changes by its name only. */
static bool is_plain(const run *r, const ir_variable *variable) {
    return run_variable_place(r, variable).kind == PLACE_LOCAL &&
           ir_type_is_plain_integer(variable->type);
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

/* Equal trees whose variables are counters of the two loops, or unchanged between them. Nothing in
 * them reads memory. */
static bool same_tree(const twin_loops *twins, const ir_node *a, const ir_node *b) {
    if (a->kind != b->kind || a->op != b->op || a->child_count != b->child_count ||
        !ir_type_is_plain_integer(a->type) || !ir_type_equal(a->type, b->type))
        return false;
    switch (a->kind) {
    case IR_NUMBER:
        return (a->flags & b->flags & IR_HAS_VALUE) != 0 && a->value == b->value;
    case IR_VARIABLE:
        return same_variable(twins, a->variable, b->variable);
    case IR_UNARY:
        if (a->op == IR_OP_DEREFERENCE || a->op == IR_OP_ADDRESS)
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

/* a = value, and b = the same value, in the two headers. */
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

static bool same_headers(twin_loops *twins) {
    ir_node *const *a = twins->writer->children, *const *b = twins->reader->children;
    if (!same_start(twins, a[0], b[0]) || a[1]->kind == IR_EMPTY || b[1]->kind == IR_EMPTY ||
        !expression_is_plain(a[1]) || !same_tree(twins, a[1], b[1]) || a[2]->kind == IR_EMPTY ||
        b[2]->kind == IR_EMPTY || !same_tree(twins, a[2], b[2]))
        return false;
    for (unsigned i = 0; i < twins->counter_count; i++)
        if (variable_is_written_in(a[3], twins->counters[i].of_writer) ||
            variable_is_written_in(b[3], twins->counters[i].of_reader))
            return false;
    return true;
}

static bool may_jump(const ir_node *node) {
    return ir_is_jump(node) || node->kind == IR_LABEL || node->kind == IR_OPAQUE;
}

/* Is it `object[the reader's subscript] = ...;`, executed in each iteration of the writer? */
static bool writes_element(const twin_loops *twins, const ir_node *statement, const ir_node *read) {
    const ir_node *assign = statement->kind == IR_EXPRESSION ? statement->children[0] : statement;
    if (assign->kind != IR_ASSIGN || assign->op != IR_OP_NONE ||
        assign->children[0]->kind != IR_INDEX)
        return false;
    const ir_node *element = assign->children[0];
    return expression_is_variable(element->children[0], twins->r->object) &&
           ir_type_equal(element->type, read->type) &&
           same_tree(twins, element->children[1], read->children[1]);
}

static bool are_twins(twin_loops *twins, const ir_node *read) {
    const ir_node *body = twins->writer->children[3];
    if (ir_any(twins->writer, may_jump) || !same_headers(twins))
        return false;
    if (body->kind != IR_BLOCK)
        return writes_element(twins, body, read);
    for (unsigned i = 0; i < body->child_count; i++)
        if (writes_element(twins, body->children[i], read))
            return true;
    return false;
}

/* Is there a writer for this loop around the read? It is in a block around the loop, before it, so
 * that nothing reaches the loop but through it: blocks of a switch are passed over. */
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
    if (!r->object || !r->body || read->kind != IR_INDEX ||
        read->children[0]->type->kind != IR_ARRAY ||
        !expression_is_variable(read->children[0], r->object) || !ir_type_is_scalar(read->type))
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
