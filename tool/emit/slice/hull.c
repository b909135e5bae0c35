/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/slice/hull.h"

#include <assert.h>

#include "analysis/base/expression.h"
#include "analysis/base/stepped.h"
#include "emit/text/origin.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"

/** Does the slice load memory anywhere below the node? */
static bool has_load_below(const loop_facts *facts, const ir_node *node) {
    if (ir_is_expression(node))
        return expression_has_load(node, false);
    if (!facts->slice.holds[node->id])
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_load_below(facts, node->children[i]))
            return true;
    return false;
}

/** The first update in the loop, in source order. */
static const ir_node *first_update(const loop_facts *facts, const ir_node *inner) {
    const ir_node *first = NULL;
    for (unsigned i = 0; i < facts->update_count; i++) {
        const ir_node *statement = facts->updates[i].statement;
        if (ir_contains(inner, statement) && (!first || statement->id < first->id))
            first = statement;
    }
    return first;
}

bool loads_between_updates(const loop_text *loop, const ir_node *inner) {
    const loop_facts *facts = loop->facts;
    const ir_node *const first = first_update(facts, inner);
    bool is_later = false, has_load = has_load_below(facts, inner);
    if (loop->plan->precheck == PRECHECK_NONE || !first)
        return false;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(inner, facts->updates[i].statement) &&
            facts->updates[i].statement != first) {
            is_later = true;
            has_load |= expression_has_load(facts->updates[i].row, true);
        }
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        if (read->extent == EXTENT_TOUCHED && read->place && ir_contains(inner, read->place) &&
            read->place->id > first->id) {
            is_later = true;
            has_load |= expression_has_load(read->row, true);
        }
    }
    return is_later && has_load;
}

bool begins_hulls(const inspector *self, const ir_node *loop) {
    return !self->hulls && has_hull(self->loop->facts, loop) && self->loop->facts->slice.has_rows &&
           !loads_between_updates(self->loop, loop);
}

/** Does the outermost loop update the array? */
static bool updates_array(const inspector *self, unsigned array) {
    const loop_facts *facts = self->loop->facts;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (facts->updates[i].array == array &&
            ir_contains(self->hulls, facts->updates[i].statement))
            return true;
    return false;
}

void begin_hulls(inspector *self, const ir_node *loop) {
    writer *out = self->printer.out;
    const char *all = NULL;
    assert(!self->hulls);
    self->hulls = loop;
    for (unsigned i = 0; i < self->loop->facts->array_count; i++)
        if (updates_array(self, i))
            all = all ? arena_format(self->printer.arena, "%s && REDCC_BY_HULL(%u)", all, i)
                      : arena_format(self->printer.arena, "REDCC_BY_HULL(%u)", i);
    writer_line(out, "{");
    out->depth++;
    writer_line(out, "const int redcc__by_hull = %s;", all);
    for (unsigned i = 0; i < self->loop->facts->array_count; i++)
        if (updates_array(self, i))
            writer_line(out, "redcc_hull redcc__hull_%u = REDCC_EMPTY_HULL;", i);
}

void end_hulls(inspector *self) {
    writer *out = self->printer.out;
    for (unsigned i = 0; i < self->loop->facts->array_count; i++)
        if (updates_array(self, i))
            writer_line(out, "REDCC_TOUCH_HULL(%u)", i);
    if (self->loop->plan->precheck != PRECHECK_NONE)
        writer_line(out, "REDCC_RETURN_IF_OVER");
    out->depth--;
    writer_line(out, "}");
    self->hulls = NULL;
}

const char *hull_step(inspector *self, const ir_node *loop) {
    loop_span span;
    if (!self->hulls || !has_hull(self->loop->facts, loop) ||
        !span_recognise((ir_node *)loop, &span))
        return NULL;
    return arena_format(self->printer.arena, "REDCC_NEXT_ROW(%s, %s%s)",
                        origin_variable(self->printer.arena, span.counted.counter),
                        log_row_text(self, span.counted.bound),
                        span.counted.comparison == IR_OP_LESS ? " - 1" : "");
}
