/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/slice/read_ends.h"

#include "analysis/base/stepped.h"
#include "emit/text/origin.h"
#include "plan/bins.h"
#include "plan/lookup.h"

/** Does each iteration execute each statement, and does the slice keep none? What a statement of
 * the slice computes may depend on all iterations, and be used after the loop. */
static bool is_straight(const loop_facts *facts, const ir_node *body) {
    if (facts->slice.holds[body->id])
        return false;
    if (body->kind == IR_EXPRESSION || body->kind == IR_DECLARATOR)
        return true;
    bool is_all = body->kind == IR_BLOCK || body->kind == IR_DECLARATION;
    for (unsigned i = 0; is_all && i < body->child_count; i++)
        is_all = is_straight(facts, body->children[i]);
    return is_all;
}

/** Is the row `base[counter]`, where the base is a variable that the whole loop only reads? */
static bool is_at_counter(const loop_facts *facts, const loop_source *read,
                          const ir_variable *counter) {
    const ir_node *const row = read->row;
    return row->kind == IR_INDEX && ir_child(row, 0)->kind == IR_VARIABLE &&
           is_captured(facts, ir_child(row, 0)->variable) &&
           ir_child(row, 1)->kind == IR_VARIABLE && ir_child(row, 1)->variable == counter &&
           !read->is_sometimes && !read->is_ahead && read->loop_count == 0;
}

/** Are all reads that are recorded in the loop at its counter, and are there any? */
static bool reads_at_counter(const inspector *self, const loop_span *span) {
    const loop_text *loop = self->loop;
    bool has_any = false;
    for (unsigned i = 0; i < loop->facts->source_count; i++) {
        const loop_source *read = &loop->facts->sources[i];
        const int number = loop->plan->source_number[i];
        if (read->extent != EXTENT_TOUCHED || number == SOURCE_NOT_LOGGED || !read->place ||
            !(loop->bins->guarded_sources >> number & 1) || !ir_contains(span->loop, read->place))
            continue;
        if (!is_at_counter(loop->facts, read, span->counted.counter))
            return false;
        has_any = true;
    }
    return has_any;
}

const char *read_ends_step(inspector *self, const ir_node *loop) {
    const loop_facts *facts = self->loop->facts;
    loop_span span;
    if (!self->loop->bins || facts->slice.exits || facts->forward_count > 0 ||
        !span_recognise((ir_node *)loop, &span) || span.counted.step != 1 ||
        span.stepped_count != 1 || span.other_count != 0 ||
        span.counted.counter->type->kind != IR_INTEGER || !is_straight(facts, span.counted.body) ||
        !reads_at_counter(self, &span))
        return NULL;
    return arena_format(self->printer.arena, "REDCC_NEXT_READ(%s, %s%s)",
                        origin_variable(self->printer.arena, span.counted.counter),
                        log_row_text(self, span.counted.bound),
                        span.counted.comparison == IR_OP_LESS ? " - 1" : "");
}
