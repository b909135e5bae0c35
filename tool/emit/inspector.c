/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The inspector: the slice of the body that computes the subscripts, and where the body would
 * update or read, a call that tells the runtime the address; or, to probe the iteration, one that
 * only compares it with what the iterations before have touched.
 */
#include "analysis/base/expression.h"
#include "analysis/base/row_steps.h"
#include "emit/loop.h"
#include "emit/origin.h"
#include "emit/print.h"
#include "emit/syntax.h"
#include "support/vector.h"

typedef struct told_row {
    const ir_node *row;
    int source; /* or SOURCE_NOT_TOLD, for an update */
    unsigned array;
    bool is_bare;
} told_row;

typedef VECTOR(told_row) row_list;

typedef struct inspector {
    printer printer; /* first: the printer's hook gets at the rest through it */
    loop_text *loop;
    bool probes;         /* addresses are compared, not told; */
    bool is_either;      /* or the text does for both */
    bool *update_told;   /* by update */
    bool *source_told;   /* by the facts' source */
    bool *is_mentioned;  /* by variable: in what was printed */
    bool is_bare;        /* what is printed now may be evaluated where the program does not */
    unsigned loop_count; /* around what is printed now, of a function that the loop calls */
    const source_loop *loops;
    row_list recent;   /* told since the slice last did something else */
    size_t recent_end; /* length of the text when the last of them was */
} inspector;

/* ---- telling addresses --------------------------------------------------------------------- */

static bool is_same_told(const told_row *a, const told_row *b) {
    return a->source == b->source && a->array == b->array && syntax_same(a->row, b->row);
}

static bool is_listed(const row_list *rows, told_row item) {
    for (unsigned i = 0; i < rows->count; i++)
        if (is_same_told(&rows->items[i], &item))
            return true;
    return false;
}

static bool was_just_told(inspector *self, told_row item) {
    if (self->printer.out->out.length != self->recent_end)
        self->recent.count = 0;
    return is_listed(&self->recent, item);
}

static void remember(inspector *self, told_row item) {
    VECTOR_PUSH(self->printer.arena, &self->recent, item);
    self->recent_end = self->printer.out->out.length;
}

static const char *note_variable(const ir_node *node, void *context);

/** As the slice names things: what it has stored is in variables. */
static const char *row_text(inspector *self, const ir_node *row) {
    const char *text = text_operand(self->loop->arena, row, note_variable, self);
    if (!text)
        loop_obstacle(self->loop, row->range, "an expression of the loop cannot be spelled");
    return text ? text : "0";
}

/** Is this row an element, of constant size, of an array or pointer that no iteration changes? Then
 *  its number says which it is: that takes less to compare than its address. */
static bool is_numbered(const ir_node *row, const ir_node *base) {
    return row->kind == IR_INDEX && row->type->size > 0 && syntax_same(row->children[0], base);
}

/** &row, or, where the program may not come to it, as a number: a pointer has a meaning only within
 *  its object. Of a span: for the counter's present value. */
static const char *row_address_text(inspector *self, const ir_node *row,
                                    const ir_variable *counter) {
    arena *a = self->loop->arena;
    row_address address;
    const char *number = NULL;
    if (self->is_bare && row_address_of(row, &address)) {
        number = address_number(a, &address, counter, note_variable, self);
        if (address.base_is_object && number) /* a pointer may stand for it: another address */
            self->loop->is_outlinable = false;
    }
    if (number)
        return arena_format(a, "(const char *)(%s)", number);
    const char *plain = row->type->is_restrict ? "(const void *)" : ""; /* compilers would warn */
    return arena_format(a, "%s&%s", plain, row_text(self, row));
}

/** The same by a macro of loop.h. */
static void tell_either(inspector *self, const ir_node *row, bool is_update, unsigned number,
                        const ir_node *base) {
    arena *a = self->loop->arena;
    const char *what = is_update ? "TOUCH" : "READ";
    const char *text = row_text(self, row);
    const char *address = row_address_text(self, row, NULL);
    writer *out = self->printer.out;
    const bool is_row = base && is_numbered(row, base);
    const char *array = is_row ? row_text(self, row->children[0]) : NULL;
    const char *subscript = is_row ? row_text(self, row->children[1]) : NULL;
    if (is_row && !self->is_bare)
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

/** Tells a row of array or source `number`, or probes it; `is_update` or read. `base`: as of
 *  is_numbered, or NULL. */
static void tell_row(inspector *self, const ir_node *row, bool is_update, unsigned number,
                     const ir_node *base) {
    const char *what = is_update ? "touch" : "read";
    const char *text = row_text(self, row);
    const char *address = row_address_text(self, row, NULL);
    const char *plain = row->type->is_restrict ? "(const void *)" : "";
    writer *out = self->printer.out;
    if (self->is_either)
        tell_either(self, row, is_update, number, base);
    else if (!self->probes)
        writer_line(out, "redcc_%s(&redcc__worker, %u, %s, sizeof(%s));", what, number, address,
                    text);
    else if (base && is_numbered(row, base))
        writer_line(out,
                    "redcc_probe_%s_row(&redcc__probe, &redcc__worker, %u, %s%s, (redcc_int)%s, "
                    "sizeof(%s));",
                    what, number, plain, row_text(self, row->children[0]),
                    row_text(self, row->children[1]), text);
    else
        writer_line(out, "redcc_probe_%s(&redcc__probe, &redcc__worker, %u, %s, sizeof(%s));", what,
                    number, address, text);
}

/* ---- loops of functions that are called ---------------------------------------------------- */

static void tell_up_to(inspector *self, const told_row *item, unsigned row,
                       const ir_variable *counter);

/** The row lies in these loops, each of which begins a block and another inside. */
static void open_loops(inspector *self, const loop_source *read, bool is_span) {
    arena *a = self->loop->arena;
    writer *out = self->printer.out;
    for (unsigned i = 0; i < read->loop_count; i++) {
        const source_loop *loop = &read->loops[i];
        const char *name = source_loop_counter(a, i);
        const char *type = origin_type(a, loop->counter->type);
        const char *lower = row_text(self, loop->lower);
        self->loop_count = i + 1;
        if (!type)
            loop_obstacle(self->loop, read->row->range, "the type of a counter has no name");
        writer_line(out, "{ %s %s = (%s)%s;", type, name, type, lower);
        writer_line(out, "%s {",
                    source_loop_header(a, read, i, name, row_text(self, loop->bound),
                                       is_span && i + 1 == read->loop_count));
    }
}

/** Tells what a function that is called reads in its loops: `for` each turn, or at once. */
static void tell_in_loops(inspector *self, const loop_source *read, unsigned number,
                          const ir_node *base) {
    const source_loop *last = &read->loops[read->loop_count - 1];
    const bool is_span = source_loop_is_span(last, read->row);
    arena *a = self->loop->arena;
    writer *out = self->printer.out;
    self->loops = read->loops;
    open_loops(self, read, is_span);
    if (is_span) {
        writer_line(out, "const char *const redcc__begin_0 = (const char *)%s;",
                    row_address_text(self, read->row, last->counter));
        writer_line(out, "%s = (%s)(%s%s);", source_loop_counter(a, read->loop_count - 1),
                    origin_type(a, last->counter->type), row_text(self, last->bound),
                    last->comparison == IR_OP_LESS ? " - 1" : "");
        tell_up_to(self, &(told_row){read->row, (int)number, 0, self->is_bare}, 0, last->counter);
    } else {
        tell_row(self, read->row, false, number, base);
    }
    self->loop_count = 0;
    for (unsigned i = 0; i < read->loop_count; i++)
        writer_line(out, "} }");
    self->recent.count = 0;
}

static bool update_is_bare(const loop_facts *facts, const reduction_update *update) {
    return update->statement->kind == IR_IF || is_bare(facts, update->statement);
}

static bool source_is_bare(const loop_facts *facts, const loop_source *read) {
    return read->is_ahead || !read->place || is_bare(facts, read->place);
}

static void tell_update(inspector *self, const reduction_update *update) {
    const told_row item = {update->row, SOURCE_NOT_TOLD, update->array, false};
    if (was_just_told(self, item))
        return;
    self->is_bare = update_is_bare(self->loop->facts, update);
    tell_row(self, update->row, true, update->array, self->loop->facts->arrays[update->array].base);
    remember(self, item);
}

static void tell_read(inspector *self, const loop_source *read, int number) {
    const told_row item = {read->row, number, 0, false};
    if (!read->loop_count && was_just_told(self, item))
        return;
    const bool is_fixed = read->base && can_be_read_ahead(self->loop->facts, read->base);
    self->is_bare = source_is_bare(self->loop->facts, read);
    if (read->loop_count) {
        tell_in_loops(self, read, (unsigned)number, is_fixed ? read->base : NULL);
        return;
    }
    tell_row(self, read->row, false, (unsigned)number, is_fixed ? read->base : NULL);
    remember(self, item);
}

static bool is_declared_in_block(const ir_node *node) {
    return node->kind == IR_DECLARATOR && node->parent->kind == IR_DECLARATION &&
           node->parent->parent && node->parent->parent->kind == IR_BLOCK;
}

/** Is this the statement before which the source's address is to be told, or the declarator? Those
 *  before it in its declaration may be needed for the address. */
static bool is_place(const loop_facts *facts, const loop_source *read, const ir_node *statement) {
    if (!read->place || read->place == facts->loop)
        return statement == facts->counted.body;
    if (read->place == statement || is_declared_in_block(read->place))
        return read->place == statement;
    return syntax_enclosing_statement(read->place, facts->counted.body) == statement;
}

static bool before_statement(printer *p, const ir_node *statement) {
    inspector *self = (inspector *)p;
    const loop_facts *facts = self->loop->facts;
    for (unsigned i = 0; i < facts->source_count; i++) {
        const int number = self->loop->source_number[i];
        if (facts->sources[i].extent == EXTENT_TOUCHED && number != SOURCE_NOT_TOLD &&
            is_place(facts, &facts->sources[i], statement)) {
            tell_read(self, &facts->sources[i], number);
            self->source_told[i] = true;
        }
    }
    self->is_bare = is_bare(facts, statement);
    const forwarded_store *store = forward_stored_by(facts, statement);
    if (store && facts->in_slice[statement->id])
        write_forward(self->loop, p->out, store, note_variable, self);
    bool is_update = false;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (facts->updates[i].statement == statement) {
            tell_update(self, &facts->updates[i]);
            self->update_told[i] = true;
            is_update = true;
        }
    self->is_bare = is_bare(facts, statement);
    const ir_node *increment = facts->counted.increment;
    return is_update || statement == increment ||
           (increment && statement->kind == IR_EXPRESSION && ir_child(statement, 0) == increment);
}

/* ---- loops told at once -------------------------------------------------------------------- */

static const loop_span *span_of(const inspector *self, const ir_node *loop) {
    const loop_facts *facts = self->loop->facts;
    for (unsigned i = 0; i < facts->span_count; i++)
        if (facts->spans[i].loop == loop)
            return &facts->spans[i];
    return NULL;
}

static bool is_at_once(const printer *p, const ir_node *loop) {
    return span_of((const inspector *)p, loop) != NULL;
}

static void list_row(inspector *self, row_list *rows, told_row item) {
    for (unsigned i = 0; i < rows->count; i++)
        if (is_same_told(&rows->items[i], &item)) {
            rows->items[i].is_bare |= item.is_bare;
            return;
        }
    VECTOR_PUSH(self->printer.arena, rows, item);
}

/** What the body of a span tells, each row once. */
static row_list rows_of_span(inspector *self, const ir_node *body) {
    const loop_facts *facts = self->loop->facts;
    row_list rows = {0};
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *read = &facts->sources[i];
        const int number = self->loop->source_number[i];
        if (read->extent != EXTENT_TOUCHED || number == SOURCE_NOT_TOLD || !read->place ||
            !ir_contains(body, read->place))
            continue;
        list_row(self, &rows, (told_row){read->row, number, 0, source_is_bare(facts, read)});
        self->source_told[i] = true;
    }
    for (unsigned i = 0; i < facts->update_count; i++) {
        const reduction_update *update = &facts->updates[i];
        if (!ir_contains(body, update->statement))
            continue;
        list_row(
            self, &rows,
            (told_row){update->row, SOURCE_NOT_TOLD, update->array, update_is_bare(facts, update)});
        self->update_told[i] = true;
    }
    return rows;
}

static bool is_update(const told_row *item) {
    return item->source == SOURCE_NOT_TOLD;
}

/** Of the array that is updated, or of the source. */
static unsigned number_of(const told_row *item) {
    return is_update(item) ? item->array : (unsigned)item->source;
}

/** Row number `row` of the list, from its first on, whose address was noted, to this one. */
static void tell_up_to(inspector *self, const told_row *item, unsigned row,
                       const ir_variable *counter) {
    const unsigned number = number_of(item);
    arena *a = self->printer.arena;
    self->is_bare = item->is_bare;
    const char *end =
        item->is_bare
            ? arena_format(a, "%s + sizeof(%s)", row_address_text(self, item->row, counter),
                           row_text(self, item->row))
            : arena_format(a, "(const char *)(&%s + 1)", row_text(self, item->row));
    const char *bytes = arena_format(a, "(redcc_size)(%s - redcc__begin_%u)", end, row);
    writer *out = self->printer.out;
    if (self->is_either && is_update(item))
        writer_line(out, "REDCC_TOUCH_SPAN(%u, redcc__begin_%u, %s);", number, row,
                    macro_argument(a, end));
    else if (self->is_either)
        writer_line(out, "REDCC_READ(%u, redcc__begin_%u, %s);", number, row,
                    macro_argument(a, bytes));
    else if (self->probes)
        writer_line(out, "redcc_probe_%s(&redcc__probe, &redcc__worker, %u, redcc__begin_%u, %s);",
                    is_update(item) ? "touch" : "read", number, row, bytes);
    else if (is_update(item))
        writer_line(out, "redcc_touch_span(&redcc__worker, %u, redcc__begin_%u, %s);", number, row,
                    end);
    else
        writer_line(out, "redcc_read(&redcc__worker, %u, redcc__begin_%u, %s);", number, row,
                    bytes);
}

/** The counter has its first value; afterwards it has the one that the loop leaves it with. */
static void tell_at_once(printer *p, const ir_node *loop) {
    inspector *self = (inspector *)p;
    const counted_loop *counted = &span_of(self, loop)->counted;
    const char *counter = origin_variable(p->arena, counted->counter);
    const row_list rows = rows_of_span(self, counted->body);
    for (unsigned i = 0; i < rows.count; i++)
        if (expression_mentions(rows.items[i].row, counted->counter)) {
            self->is_bare = rows.items[i].is_bare;
            writer_line(p->out, "const char *const redcc__begin_%u = (const char *)%s;", i,
                        row_address_text(self, rows.items[i].row, counted->counter));
        }
    for (unsigned i = 0; i < rows.count; i++) {
        const told_row *item = &rows.items[i];
        self->is_bare = item->is_bare;
        if (!expression_mentions(item->row, counted->counter))
            tell_row(self, item->row, is_update(item), number_of(item), NULL);
    }
    self->is_bare = is_bare(self->loop->facts, loop);
    writer_line(p->out, "%s = (__typeof__(%s))(%s%s);", counter, counter,
                row_text(self, counted->bound), counted->comparison == IR_OP_LESS ? " - 1" : "");
    for (unsigned i = 0; i < rows.count; i++)
        if (expression_mentions(rows.items[i].row, counted->counter))
            tell_up_to(self, &rows.items[i], i, counted->counter);
    if (!counted->counter_is_declared_in_header)
        writer_line(p->out, "%s++;", counter);
}

/** Nothing that the loop touches may stay untold. */
static void check_all_told(inspector *self) {
    const loop_facts *facts = self->loop->facts;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (!self->update_told[i])
            loop_obstacle(self->loop, facts->updates[i].target->range,
                          "the inspector cannot reach an update of '%s'",
                          facts->arrays[facts->updates[i].array].name);
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].extent == EXTENT_TOUCHED && !self->source_told[i] &&
            self->loop->source_number[i] != SOURCE_NOT_TOLD)
            loop_obstacle(self->loop, facts->sources[i].row->range,
                          "the inspector cannot reach a read of '%s'", facts->sources[i].name);
}

/* ---- the variables of the slice ------------------------------------------------------------ */

/** Is the variable needed by what was printed, or by an address that was told? */
static bool is_needed(const inspector *self, const ir_variable *variable) {
    const loop_facts *facts = self->loop->facts;
    if (self->is_mentioned[variable->id])
        return true;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (expression_mentions(facts->updates[i].row, variable))
            return true;
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].extent == EXTENT_TOUCHED && self->source_told[i] &&
            expression_mentions(facts->sources[i].row, variable))
            return true;
    return false;
}

/** The printer's hook for spellings: notes the variables. */
static const char *note_variable(const ir_node *node, void *context) {
    inspector *self = context;
    for (unsigned i = 0; node->kind == IR_VARIABLE && i < self->loop_count; i++)
        if (self->loops[i].counter == node->variable)
            return source_loop_counter(self->loop->arena, i);
    if (node->kind == IR_VARIABLE)
        self->is_mentioned[node->variable->id] = true;
    const char *name = forward_read_name(self->loop, node);
    if (name || !self->is_bare)
        return name;
    return wrapping_operation(self->loop->arena, node, note_variable, self);
}

static void declare_variables(const inspector *self, writer *out) {
    loop_text *loop = self->loop;
    const loop_facts *facts = loop->facts;
    const ir_variable *counter = facts->counted.counter;
    const char *unused = is_needed(self, counter) ? "" : " __attribute__((__unused__))";
    if (!loop->is_outlined)
        writer_line(out, "%s %s%s = (%s)(redcc__lower + %s);", loop->counter_type,
                    origin_declarator(loop->arena, counter), unused, loop->counter_type,
                    loop_iteration_offset(loop));
    for (unsigned i = 0; i < facts->private_count; i++) {
        const ir_variable *variable = facts->privates[i].variable;
        if (!facts->privates[i].is_declared_inside && is_needed(self, variable))
            writer_line(out, "%s%s;", private_declaration(loop, variable), stepped_value(loop, i));
    }
    declare_forwards(loop, out, true);
}

static void tell_gathers(printer *p) {
    inspector *self = (inspector *)p;
    if (self->is_either)
        write_gathers(self->loop, p->out, self->is_mentioned);
}

/** The statements follow the declarations, from `before` on, on their line: how much of the first
 *  one's indentation is to be left out. */
static size_t goes_on(const inspector *self, writer *out, size_t before, const writer *slice) {
    if (!self->is_either || self->printer.continues || out->out.length == before ||
        slice->out.length == 0)
        return 0;
    size_t indentation = 0;
    while (slice->out.data[indentation] == ' ')
        indentation++;
    out->out.data[out->out.length - 1] = ' ';
    return indentation;
}

/** The slice; for the text that does either, with the variables that it names. */
static void write_statements(loop_text *loop, writer *out, bool probes, bool is_either,
                             bool *is_mentioned) {
    const loop_facts *facts = loop->facts;
    inspector self = {.printer = {.arena = loop->arena,
                                  .keep = facts->in_slice,
                                  .before = before_statement,
                                  .is_at_once = is_at_once,
                                  .print_at_once = tell_at_once,
                                  .at_end = tell_gathers},
                      .loop = loop,
                      .probes = probes,
                      .is_either = is_either,
                      .update_told = ARENA_ARRAY(loop->arena, bool, facts->update_count + 1),
                      .source_told = ARENA_ARRAY(loop->arena, bool, facts->source_count + 1),
                      .is_mentioned = is_mentioned};
    self.printer.rename = note_variable;
    self.printer.context = &self;
    writer slice = {.depth = out->depth, .fills = is_either};
    self.printer.out = &slice;
    print_body(&self.printer, facts->counted.body);
    check_all_told(&self);
    if (self.printer.problem)
        loop_obstacle(loop, facts->loop->range, "%s", self.printer.problem);

    if (is_either)
        writer_fill(out, true);
    const size_t before = out->out.length;
    declare_variables(&self, out);
    if (is_either)
        writer_fill(out, false);
    const size_t indentation = goes_on(&self, out, before, &slice);
    if (probes)
        writer_line(out, "redcc_probe redcc__probe = {0, 0};");
    /* `continue` of the user's loop goes to the end of the slice, not past what follows it */
    if (self.printer.continues)
        writer_line(out, "do {");
    buffer_append(&out->out, slice.out.data ? slice.out.data + indentation : "",
                  slice.out.length - indentation);
    if (self.printer.continues)
        writer_line(out, "} while (0);");
    buffer_free(&slice.out);
}

void write_slice_statements(loop_text *loop, writer *out, bool *is_mentioned) {
    write_statements(loop, out, false, true, is_mentioned);
}

void write_inspected_iteration(loop_text *loop, writer *out, bool probes) {
    write_statements(loop, out, probes, false,
                     ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1));
    if (probes) {
        writer_line(out, "if (!redcc_is_alike(&redcc__probe))");
        writer_line(out, "    break;");
    } else {
        writer_line(out, "redcc_iteration_done(&redcc__worker);");
    }
}
