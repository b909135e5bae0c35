/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Writes the code that logs addresses: those of one row, of all rows through which a loop steps, or
 * of reads in loops of a called function. */
#include "emit/slice/access_log.h"

#include <assert.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "emit/base/forward.h"
#include "emit/base/names.h"
#include "emit/base/own.h"
#include "emit/base/wrapping.h"
#include "emit/slice/slice.h"
#include "emit/text/origin.h"
#include "ir/ir_syntax.h"
#include "plan/inner_iterations.h"
#include "plan/lookup.h"
#include "plan/unconditional.h"

/** Returns the value of `counter` in the first or, if is_at_last, in the last row of the current
 * span. Returns NULL unless `counter` counts a loop with constant bounds. */
static const char *end_value(inspector *self, const ir_variable *counter) {
    const constant_loop found = counted_constant_around(self->place, self->span, counter);
    if (!found.loop)
        return NULL;
    const int64_t number = self->is_at_last ? found.last : found.first;
    const char *value =
        arena_format(self->loop->arena, number < 0 ? "(%lld)" : "%lld", (long long)number);
    return counter->type->is_signed && counter->type->size == 4
               ? value
               : origin_value(self->loop->arena, counter->type, value);
}

const char *inspector_note_variable(const ir_node *node, void *context) {
    inspector *self = context;
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < self->loop_count; i++)
        if (self->loops[i].counter == node->variable)
            return source_loop_counter(self->loop->arena, i);
    if (node->kind == IR_VARIABLE && self->place && end_value(self, node->variable))
        return end_value(self, node->variable);
    if (node->kind == IR_VARIABLE)
        self->is_mentioned[node->variable->id] = true;
    const char *name = own_name(self->loop, node);
    if (!name)
        name = forward_read_name(self->loop, node);
    if (!name)
        name = pointed_name(self->loop, node);
    if (name || !self->is_unconditional)
        return name;
    return wrapping_operation(self->loop->arena, node, inspector_note_variable, self);
}

bool logged_same(const logged_row *a, const logged_row *b) {
    return a->source == b->source && a->array == b->array && syntax_same(a->row, b->row);
}

static bool is_listed(const row_list *rows, logged_row item) {
    for (unsigned i = 0; i < rows->count; i++)
        if (logged_same(&rows->items[i], &item))
            return true;
    return false;
}

static bool was_just_logged(inspector *self, logged_row item) {
    if (self->printer.out->out.length != self->recent_end)
        self->recent.count = 0;
    return is_listed(&self->recent, item);
}

static void remember(inspector *self, logged_row item) {
    VECTOR_PUSH(self->printer.arena, &self->recent, item);
    self->recent_end = self->printer.out->out.length;
}

const char *log_row_text(inspector *self, const ir_node *row) {
    const char *text = text_operand(self->loop->arena, row, inspector_note_variable, self);
    if (!text)
        loop_obstacle(self->loop, row->range,
                      "an expression of the loop cannot be written as C outside of it");
    return text ? text : "0";
}

/** Is the row an element, of constant size, of the invariant array or pointer `base`? If so, its
 *  number identifies the row, and is cheaper to compare than its address. */
static bool is_numbered(const ir_node *row, const ir_node *base) {
    return row->kind == IR_INDEX && row->type->size > 0 && syntax_same(row->children[0], base);
}

const char *log_address_text(inspector *self, const ir_node *row, const ir_variable *counter) {
    arena *a = self->loop->arena;
    row_address address;
    const char *number = NULL;
    if (self->is_unconditional && row_address_of(row, &address)) {
        number = address_number(a, &address, counter, inspector_note_variable, self);
        if (row_needs_address(&address) &&
            number) /* a pointer that replaces the object would have another address */
            self->loop->outline.possible = false;
    }
    if (number)
        return arena_format(a, "(const char *)(%s)", number);
    const char *plain = row->type->is_restrict ? "(const void *)" : ""; /* without the cast
                                                                         * compilers would warn
                                                                         * about the qualifier */
    return arena_format(a, "%s&%s", plain, log_row_text(self, row));
}

/** Logs a whole array. Its size is written as a number, because the slice gets only a pointer to
 *  the array's first element. */
static void log_array(inspector *self, const ir_node *row, const char *what, unsigned number) {
    const ir_type *type = row->type, *element = type->target;
    const char *text = log_row_text(self, row);
    if (type->size < 0 || element->size <= 0) {
        self->loop->outline.possible = false;
        return;
    }
    writer_line(self->printer.out, "REDCC_%s(%u, %s%s, %lldu * sizeof(%s[0]));", what, number,
                element->is_restrict ? "(const void *)" : "", text,
                (long long)(type->size / element->size), text);
}

static void log_address(inspector *self, const ir_node *row, bool is_update, unsigned number,
                        const ir_node *base) {
    arena *a = self->loop->arena;
    const char *what = is_update ? "TOUCH" : "READ";
    const char *text = log_row_text(self, row);
    const char *address = log_address_text(self, row, NULL);
    writer *out = self->printer.out;
    const bool is_row = base && is_numbered(row, base);
    const char *array = is_row ? log_row_text(self, row->children[0]) : NULL;
    const char *subscript = is_row ? log_row_text(self, row->children[1]) : NULL;
    if (row->kind == IR_VARIABLE && row->type->kind == IR_ARRAY)
        log_array(self, row, what, number);
    else if (is_row && !self->is_unconditional)
        writer_line(out, "REDCC_%s_ROW(%u, %s, %s);", what, number, macro_argument(a, array),
                    macro_argument(a, subscript));
    else if (is_row)
        writer_line(out,
                    "redcc_slice_%s_row(REDCC_SLICE_NAMES, %u, %s, %s%s, (redcc_int)%s, "
                    "sizeof(%s));",
                    is_update ? "touch" : "read", number, address,
                    row->type->is_restrict ? "(const void *)" : "", array, subscript, text);
    else
        writer_line(out, "REDCC_%s(%u, %s, sizeof(%s));", what, number, macro_argument(a, address),
                    text);
}

static bool is_guarded(const loop_text *loop, unsigned number) {
    for (unsigned i = 0; i < loop->facts->source_count; i++)
        if (loop->plan->source_number[i] == (int)number && loop->facts->sources[i].needs_guard)
            return true;
    return false;
}

/** Writes the statement by which a dependence pre-check may stop after this access. */
static void may_end_here(inspector *self, bool is_update, unsigned number) {
    loop_text *loop = self->loop;
    writer *out = self->printer.out;
    if (is_update ? loop->plan->precheck == PRECHECK_NONE
                  : loop->plan->precheck != PRECHECK_OF_ALL || !is_guarded(loop, number))
        return;
    if (is_update)
        writer_line(out, "REDCC_RETURN_IF_OVER");
    else
        writer_line(out, "REDCC_RETURN_IF_STALE(%u)", number);
}

/* ---- the leader ----------------------------------------------------------------------------- */

/* Of the threads that execute an iteration, one leads: it executes the whole iteration, and keeps
 * the operands of series (redcc/series.h). The owner of a row that changes in the fewest nested
 * loops leads, because that owner can skip the fewest inner iterations. */

/** The number of inner loops around the most deeply nested assignment of the variable. */
static unsigned loops_around_writes(const ir_node *node, const ir_variable *variable,
                                    unsigned loops) {
    const ir_node *written = expression_written(node);
    unsigned most = (written && expression_object(written) == variable) ||
                            (node->kind == IR_DECLARATOR && node->variable == variable)
                        ? loops
                        : 0;
    for (unsigned i = 0; i < node->child_count; i++) {
        const unsigned below =
            loops_around_writes(node->children[i], variable, loops + ir_is_loop(node));
        most = below > most ? below : most;
    }
    return most;
}

static unsigned loops_around(const loop_facts *facts, const ir_node *row) {
    unsigned most =
        row->kind == IR_VARIABLE ? loops_around_writes(facts->counted.body, row->variable, 0) : 0;
    for (unsigned i = 0; i < row->child_count; i++) {
        const unsigned below = loops_around(facts, row->children[i]);
        most = below > most ? below : most;
    }
    return most;
}

static void log_leader(inspector *self, const ir_node *row) {
    const loop_facts *facts = self->loop->facts;
    if (!plan_has_leaders(self->loop->plan))
        return;
    const unsigned own = loops_around(facts, row);
    for (unsigned i = 0; i < facts->update_count; i++)
        if (loops_around(facts, facts->updates[i].row) < own)
            return;
    writer_line(self->printer.out, "REDCC_LEADER");
}

void log_row(inspector *self, const ir_node *row, bool is_update, unsigned number,
             const ir_node *base) {
    assert(number < (is_update ? self->loop->facts->array_count : self->loop->plan->source_count));
    if (is_update)
        log_leader(self, row);
    log_address(self, row, is_update, number, base);
    may_end_here(self, is_update, number);
}

bool logged_is_update(const logged_row *item) {
    return item->source == SOURCE_NOT_LOGGED;
}

unsigned logged_number(const logged_row *item) {
    return logged_is_update(item) ? item->array : (unsigned)item->source;
}

void log_up_to(inspector *self, const logged_row *item, unsigned row, const ir_variable *counter) {
    const unsigned number = logged_number(item);
    arena *a = self->printer.arena;
    self->is_unconditional = item->is_unconditional;
    self->place = item->place;
    self->is_at_last = true;
    const char *end =
        item->is_unconditional
            ? arena_format(a, "%s + sizeof(%s)", log_address_text(self, item->row, counter),
                           log_row_text(self, item->row))
            : arena_format(a, "(const char *)(&%s + 1)", log_row_text(self, item->row));
    self->place = NULL;
    const char *bytes = arena_format(a, "(redcc_size)(%s - redcc__begin_%u)", end, row);
    writer *out = self->printer.out;
    if (logged_is_update(item))
        log_leader(self, item->row);
    if (logged_is_update(item))
        writer_line(out, "%s(%u, redcc__begin_%u, %s);",
                    self->hulls ? "REDCC_TOUCH_PART" : "REDCC_TOUCH_SPAN", number, row,
                    macro_argument(a, end));
    else
        writer_line(out, "REDCC_READ(%u, redcc__begin_%u, %s);", number, row,
                    macro_argument(a, bytes));
    may_end_here(self, logged_is_update(item), number);
}

/* ---- loops of called functions --------------------------------------------------------------- */

/** Opens the loops around the row, each in a block that declares its counter. */
static void open_loops(inspector *self, const loop_source *read, bool is_span) {
    arena *a = self->loop->arena;
    writer *out = self->printer.out;
    for (unsigned i = 0; i < read->loop_count; i++) {
        const source_loop *loop = &read->loops[i];
        const char *name = source_loop_counter(a, i);
        const char *type = origin_type(a, loop->counter->type);
        const char *lower = log_row_text(self, loop->lower);
        self->loop_count = i + 1;
        if (!type)
            loop_obstacle(self->loop, read->row->range, "the type of a counter has no name");
        writer_line(out, "{ %s %s = (%s)%s;", type, name, type, lower);
        writer_line(out, "%s {",
                    source_loop_header(a, read, i, name, log_row_text(self, loop->bound),
                                       is_span && i + 1 == read->loop_count));
    }
}

/** Logs the reads in loops of a called function. The innermost loop is logged as one span (range)
 * if possible; otherwise each iteration is logged. */
static void log_in_loops(inspector *self, const loop_source *read, unsigned number,
                         const ir_node *base) {
    const source_loop *last = &read->loops[read->loop_count - 1];
    const bool is_span = source_loop_is_span(last, read->row);
    arena *a = self->loop->arena;
    writer *out = self->printer.out;
    self->loops = read->loops;
    if (read->is_repeated && self->loop->bins)
        writer_line(out, "REDCC_IF_RECORDED(%u)", number);
    open_loops(self, read, is_span);
    if (is_span) {
        writer_line(out, "const char *const redcc__begin_0 = (const char *)%s;",
                    log_address_text(self, read->row, last->counter));
        writer_line(out, "%s = (%s)(%s%s);", source_loop_counter(a, read->loop_count - 1),
                    origin_type(a, last->counter->type), log_row_text(self, last->bound),
                    last->comparison == IR_OP_LESS ? " - 1" : "");
        log_up_to(self, &(logged_row){read->row, (int)number, 0, self->is_unconditional, NULL}, 0,
                  last->counter);
    } else {
        log_row(self, read->row, false, number, base);
    }
    self->loop_count = 0;
    for (unsigned i = 0; i < read->loop_count; i++)
        writer_line(out, "} }");
    self->recent.count = 0;
}

void log_update(inspector *self, const reduction_update *update) {
    const logged_row item = {update->row, SOURCE_NOT_LOGGED, update->array, false, NULL};
    if (was_just_logged(self, item))
        return;
    self->is_unconditional = update_is_unconditional(self->loop->facts, update);
    log_row(self, update->row, true, update->array, self->loop->facts->arrays[update->array].base);
    remember(self, item);
}

void log_read(inspector *self, const loop_source *read, int number) {
    const logged_row item = {read->row, number, 0, false, NULL};
    if (!read->loop_count && was_just_logged(self, item))
        return;
    const bool is_fixed =
        read->base && self->loop->plan->has_ready_base[read - self->loop->facts->sources];
    self->is_unconditional = source_is_unconditional(self->loop->facts, read);
    if (read->loop_count) {
        log_in_loops(self, read, (unsigned)number, is_fixed ? read->base : NULL);
        return;
    }
    log_row(self, read->row, false, (unsigned)number, is_fixed ? read->base : NULL);
    remember(self, item);
}
