/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The inspector: the slice of the body that computes the subscripts. At the body's updates and
 * reads it has macros that log their addresses or compare them with those of preceding iterations.
 */
#include "emit/slice/slice.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_exits.h"
#include "analysis/base/row_steps.h"
#include "analysis/base/stepped.h"
#include "emit/base/forward.h"
#include "emit/base/names.h"
#include "emit/base/own.h"
#include "emit/base/step.h"
#include "emit/slice/access_log.h"
#include "emit/slice/hull.h"
#include "emit/slice/read_ends.h"
#include "emit/text/origin.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"
#include "plan/unconditional.h"

static bool is_declared_in_block(const ir_node *node) {
    return node->kind == IR_DECLARATOR && node->parent->kind == IR_DECLARATION &&
           node->parent->parent && node->parent->parent->kind == IR_BLOCK;
}

/** Is the source's address logged before this statement or declarator? If a declarator reads the
 * source, the address is logged directly before that declarator, because preceding declarators of
 * the same declaration may compute the address. */
static bool is_place(const loop_facts *facts, const loop_source *read, const ir_node *statement) {
    if (!read->place || read->place == facts->loop)
        return statement == facts->counted.body;
    if (read->place == statement || is_declared_in_block(read->place))
        return read->place == statement;
    return syntax_enclosing_statement(read->place, facts->counted.body) == statement;
}

/** Writes the check whether the iteration leaves the loop. A comparison gets no additional
 * parentheses, because clang would warn of them. */
static void write_exit(inspector *self, const loop_exit *exit) {
    const ir_node *condition = exit->rest->children[0];
    const char *operand = log_row_text(self, condition);
    const char *text = text_expression(self->loop->arena, condition, inspector_note_variable, self);
    const char *leave =
        self->loop->continues && !exit->is_message ? "REDCC_END_AT(redcc__k)" : "REDCC_LEAVE";
    if (exit->is_negated)
        writer_line(self->printer.out, "if (!%s) %s", operand, leave);
    else if (text)
        writer_line(self->printer.out, "if (%s) %s", text, leave);
}

static bool before_statement(printer *p, const ir_node *statement) {
    inspector *self = (inspector *)p;
    const loop_facts *facts = self->loop->facts;
    if (begins_hulls(self, statement)) {
        begin_hulls(self, statement);
        print_statement(p, statement);
        end_hulls(self);
        return true;
    }
    for (unsigned i = 0; i < facts->source_count; i++) {
        const int number = self->loop->plan->source_number[i];
        if (facts->sources[i].extent == EXTENT_TOUCHED && number != SOURCE_NOT_LOGGED &&
            is_place(facts, &facts->sources[i], statement)) {
            log_read(self, &facts->sources[i], number);
            self->source_logged[i] = true;
        }
    }
    const loop_exit *exit = loop_exit_at(facts->slice.exits, statement);
    if (exit) {
        write_exit(self, exit);
        if (exit->otherwise)
            print_statement(p, exit->otherwise);
        return true;
    }
    self->is_unconditional = is_unconditional(facts, statement);
    const forwarded_store *store = forward_stored_by(facts, statement);
    if (store && facts->slice.holds[statement->id])
        write_forward(self->loop, p->out, store, inspector_note_variable, self);
    bool is_update = false;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (facts->updates[i].statement == statement) {
            if (facts->slice.has_rows)
                log_update(self, &facts->updates[i]);
            self->update_logged[i] = true;
            is_update = true;
        }
    self->is_unconditional = is_unconditional(facts, statement);
    const ir_node *increment = facts->counted.increment;
    return is_update || statement == increment ||
           (increment && statement->kind == IR_EXPRESSION && ir_child(statement, 0) == increment);
}

/* ---- spans: loops whose rows are logged as one range ----------------------------------------- */

static bool is_at_once(const printer *p, const ir_node *loop) {
    const inspector *self = (const inspector *)p;
    return span_of(self->loop->facts, loop) && !loads_between_updates(self->loop, loop);
}

/** Are both places within the same loops with constant bounds? Only loops whose counters occur in
 * the row are compared. */
static bool has_same_ends(const ir_node *row, const ir_node *span, const ir_node *place,
                          const ir_node *other) {
    if (row->kind == IR_VARIABLE && counted_constant_around(place, span, row->variable).loop !=
                                        counted_constant_around(other, span, row->variable).loop)
        return false;
    for (unsigned i = 0; i < row->child_count; i++)
        if (!has_same_ends(row->children[i], span, place, other))
            return false;
    return true;
}

static void list_row(inspector *self, row_list *rows, const loop_span *span, logged_row item) {
    for (unsigned i = 0; i < rows->count; i++)
        if (logged_same(&rows->items[i], &item) &&
            has_same_ends(item.row, span->loop, rows->items[i].place, item.place)) {
            rows->items[i].is_unconditional |= item.is_unconditional;
            return;
        }
    VECTOR_PUSH(self->printer.arena, rows, item);
}

/** Is the row, accessed at a place in the span's body, logged by a nested span? */
static bool is_logged_below(const loop_facts *facts, const loop_span *span, const ir_node *place,
                            const ir_node *row) {
    for (const ir_node *node = place->parent; node && node != span->loop; node = node->parent)
        if (span_of(facts, node))
            return span_mentions(span, row) == 0;
    return false;
}

/** Is the row logged by an enclosing span, because that span's variables occur in the row? */
static bool is_logged_above(const loop_facts *facts, const loop_span *span, const ir_node *row) {
    for (const ir_node *node = span->loop->parent; node != facts->loop; node = node->parent)
        if (span_of(facts, node) && span_mentions(span_of(facts, node), row) > 0)
            return true;
    return false;
}

/** Does the span itself log the row at this place? */
static bool is_logged_here(const loop_facts *facts, const loop_span *span, const ir_node *place,
                           const ir_node *row) {
    return ir_contains(span->counted.body, place) && !is_logged_below(facts, span, place, row) &&
           !is_logged_above(facts, span, row);
}

/** The rows that the span itself logs, each once. */
static row_list rows_of_span(inspector *self, const loop_span *span) {
    const loop_facts *facts = self->loop->facts;
    row_list rows = {0};
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        const int number = self->loop->plan->source_number[i];
        if (read->extent != EXTENT_TOUCHED || number == SOURCE_NOT_LOGGED || !read->place ||
            !is_logged_here(facts, span, read->place, read->row))
            continue;
        list_row(
            self, &rows, span,
            (logged_row){read->row, number, 0, source_is_unconditional(facts, read), read->place});
        self->source_logged[i] = true;
    }
    for (unsigned i = 0; i < facts->update_count && facts->slice.has_rows; i++) {
        const reduction_update *update = &facts->updates[i];
        if (!is_logged_here(facts, span, update->statement, update->row))
            continue;
        list_row(self, &rows, span,
                 (logged_row){update->row, SOURCE_NOT_LOGGED, update->array,
                              update_is_unconditional(facts, update), update->statement});
        self->update_logged[i] = true;
    }
    return rows;
}

/** Are all rows of the span logged by enclosing spans, and is the span's header not needed for
 * anything else? If so, the span is not written. */
static bool is_logged_elsewhere(inspector *self, const loop_span *span) {
    return rows_of_span(self, span).count == 0 && !ir_has_kind(span->counted.body, IR_FOR) &&
           span->counted.counter_is_declared_in_header && span->stepped_count == 1;
}

/** Prints the nested spans, except those whose rows enclosing spans log. */
static void log_spans_below(printer *p, const loop_facts *facts, const ir_node *node) {
    if (span_of(facts, node)) {
        if (!is_logged_elsewhere((inspector *)p, span_of(facts, node)))
            print_statement(p, node);
        return;
    }
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        log_spans_below(p, facts, node->children[i]);
}

/** Sets the stepped variables to their values in the last iteration. The arithmetic wraps around,
 * because the program may not execute the loop. */
static void step_to_last(inspector *self, const loop_span *span) {
    const counted_loop *counted = &span->counted;
    writer *out = self->printer.out;
    const char *counter = origin_variable(self->printer.arena, counted->counter);
    const char *last = arena_format(self->printer.arena, "%s%s", log_row_text(self, counted->bound),
                                    counted->comparison == IR_OP_LESS ? " - 1" : "");
    if (counted->step > 1) /* without iterations, `last` remains less than the first value */
        last = arena_format(self->printer.arena,
                            "(redcc_int)(%s) - (redcc_int)(((redcc_size)(%s) - (redcc_size)%s) %% "
                            "%lldu)",
                            last, last, counter, (long long)counted->step);
    for (unsigned i = 0; i < span->stepped_count; i++) {
        const char *name = origin_variable(self->printer.arena, span->stepped[i]);
        if (span->stepped[i]->type->kind == IR_POINTER) /* the counter itself is an integer */
            writer_line(out,
                        "%s = (__typeof__(%s))((redcc_size)%s + "
                        "((redcc_size)(%s) - (redcc_size)%s) * sizeof(*%s));",
                        name, name, name, last, counter, name);
        else if (span->stepped[i] != counted->counter)
            writer_line(out,
                        "%s = (__typeof__(%s))((redcc_size)%s + (redcc_size)(%s) - "
                        "(redcc_size)%s);",
                        name, name, name, last, counter);
    }
    writer_line(out, "%s = (__typeof__(%s))(%s);", counter, counter, last);
}

/** Steps variables declared outside of the loop from the last iteration to their values
 *  after it. */
static void step_past_end(inspector *self, const loop_span *span) {
    const long long step = (long long)span->counted.step;
    for (unsigned i = 0; i < span->stepped_count; i++)
        if (!ir_declarator_in(span->loop->children[0], span->stepped[i]))
            writer_line(self->printer.out, step == 1 ? "%s++;" : "%s += %lld;",
                        origin_variable(self->printer.arena, span->stepped[i]), step);
}

/** Writes a span in place of its loop. Before this text the stepped variables have their initial
 * values; after it, the values that they have after the loop. */
static void log_at_once(printer *p, const ir_node *loop) {
    inspector *self = (inspector *)p;
    const loop_facts *facts = self->loop->facts;
    const loop_span *span = span_of(facts, loop);
    const row_list rows = rows_of_span(self, span);
    for (unsigned i = 0; i < rows.count; i++)
        if (span_mentions(span, rows.items[i].row)) {
            self->is_unconditional = rows.items[i].is_unconditional;
            self->span = loop;
            self->place = rows.items[i].place;
            self->is_at_last = false;
            writer_line(p->out, "const char *const redcc__begin_%u = (const char *)%s;", i,
                        log_address_text(self, rows.items[i].row,
                                         span_stepped_in(span, rows.items[i].row)));
            self->place = NULL;
        }
    for (unsigned i = 0; i < rows.count; i++) {
        const logged_row *item = &rows.items[i];
        self->is_unconditional = item->is_unconditional;
        if (!span_mentions(span, item->row))
            log_row(self, item->row, logged_is_update(item), logged_number(item), NULL);
    }
    log_spans_below(p, facts, span->counted.body);
    self->is_unconditional = is_unconditional(facts, loop);
    step_to_last(self, span);
    for (unsigned i = 0; i < rows.count; i++)
        if (span_mentions(span, rows.items[i].row)) {
            self->span = loop;
            log_up_to(self, &rows.items[i], i, span_stepped_in(span, rows.items[i].row));
        }
    step_past_end(self, span);
}

static const char *step_of(printer *p, const ir_node *loop) {
    const char *const step = hull_step((inspector *)p, loop);
    return step ? step : read_ends_step((inspector *)p, loop);
}

/** Records an obstacle if an access of the loop is not logged. */
static void check_all_logged(inspector *self) {
    const loop_facts *facts = self->loop->facts;
    for (unsigned i = 0; i < facts->update_count && facts->slice.has_rows; i++)
        if (!self->update_logged[i])
            loop_obstacle(self->loop, facts->updates[i].target->range,
                          "the inspector cannot reach an update of '%s'",
                          facts->arrays[facts->updates[i].array].name);
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].extent == EXTENT_TOUCHED && !self->source_logged[i] &&
            self->loop->plan->source_number[i] != SOURCE_NOT_LOGGED)
            loop_obstacle(self->loop, facts->sources[i].row->range,
                          "the inspector cannot reach a read of '%s'", facts->sources[i].name);
}

/* ---- the variables of the slice ------------------------------------------------------------ */

/** Do the printed code or the logged addresses need the variable? */
static bool is_needed(const inspector *self, const ir_variable *variable) {
    const loop_facts *facts = self->loop->facts;
    if (self->is_mentioned[variable->id])
        return true;
    for (unsigned i = 0; i < facts->update_count && facts->slice.has_rows; i++)
        if (expression_mentions(facts->updates[i].row, variable))
            return true;
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].extent == EXTENT_TOUCHED && self->source_logged[i] &&
            expression_mentions(facts->sources[i].row, variable))
            return true;
    return false;
}

/** A hook that spells an own element itself, and records the variables in it. */
static const char *note_element_variable(const ir_node *node, void *context) {
    inspector *self = context;
    if (node->kind == IR_VARIABLE)
        self->is_mentioned[node->variable->id] = true;
    return pointed_name(self->loop, node);
}

static void declare_variables(inspector *self, writer *out) {
    loop_text *loop = self->loop;
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->variables.private_count; i++) {
        const private_variable *item = &facts->variables.privates[i];
        if (!item->is_declared_inside && is_needed(self, item->variable))
            writer_line(out, "%s%s;", private_declaration(loop, item), stepped_value(loop, i));
    }
    declare_own(loop, out, true, note_element_variable, self);
    declare_forwards(loop, out, true);
}

/** Writes, at the end of the slice, prefetches of rows that it does not log. */
static void write_gathers(loop_text *loop, writer *out, bool *is_mentioned) {
    const prefetch_plan *prefetch = &loop->plan->prefetch;
    for (unsigned i = 0; i < prefetch->gather_count; i++) {
        const gather *one = &prefetch->gathers[i];
        if (!is_mentioned[one->subscript->id])
            continue;
        is_mentioned[one->base->id] = true;
        writer_line(out, "REDCC_AHEAD(%s, %s);", origin_variable(loop->arena, one->base),
                    origin_variable(loop->arena, one->subscript));
    }
}

static void write_gathers_at_end(printer *p) {
    inspector *self = (inspector *)p;
    write_gathers(self->loop, p->out, self->is_mentioned);
}

void write_slice_statements(loop_text *loop, writer *out, bool *is_mentioned) {
    const loop_facts *facts = loop->facts;
    inspector self = {.printer = {.arena = loop->arena,
                                  .keep = facts->slice.holds,
                                  .before = before_statement,
                                  .is_at_once = is_at_once,
                                  .print_at_once = log_at_once,
                                  .step_of = step_of,
                                  .at_end = write_gathers_at_end},
                      .loop = loop,
                      .update_logged = ARENA_ARRAY(loop->arena, bool, facts->update_count + 1),
                      .source_logged = ARENA_ARRAY(loop->arena, bool, facts->source_count + 1),
                      .is_mentioned = is_mentioned};
    self.printer.rename = inspector_note_variable;
    self.printer.context = &self;
    writer slice = {.depth = out->depth};
    self.printer.out = &slice;
    print_body(&self.printer, facts->counted.body);
    check_all_logged(&self);
    if (self.printer.problem)
        loop_obstacle(loop, facts->loop->range, "%s", self.printer.problem);
    declare_variables(&self, out);
    /* `continue` of the user's loop jumps to the end of the slice */
    if (self.printer.continues)
        writer_line(out, "do {");
    buffer_append(&out->out, slice.out.data ? slice.out.data : "", slice.out.length);
    if (self.printer.continues)
        writer_line(out, "} while (0);");
    buffer_free(&slice.out);
}
