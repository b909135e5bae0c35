/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The executor's body: the user's bytes, with edits. The bases of the reduction arrays are replaced
 * if they are not shadowed. In owner-checked runs a check that the thread owns the element precedes
 * each update. A statement is printed from the IR if macro-expanded text in it must change, or if
 * it records a value (an operand, a forwarded store, a live-out).
 */
#include "emit/body/body.h"

#include <string.h>

#include "analysis/base/loop_exits.h"
#include "analysis/base/loop_loads.h"
#include "emit/base/forward.h"
#include "emit/base/names.h"
#include "emit/base/own.h"
#include "emit/base/step.h"
#include "emit/base/wrapping.h"
#include "emit/bins/bins.h"
#include "emit/body/copy.h"
#include "emit/body/live_out.h"
#include "emit/body/omitted.h"
#include "emit/body/own.h"
#include "emit/body/scalars.h"
#include "emit/body/series.h"
#include "emit/text/edit.h"
#include "emit/text/layout.h"
#include "emit/text/origin.h"
#include "emit/text/print.h"
#include "ir/ir_position.h"
#include "ir/ir_syntax.h"
#include "plan/inner_iterations.h"
#include "plan/lanes.h"
#include "plan/lookup.h"
#include "plan/outline.h"
#include "plan/place.h"
#include "plan/tiles.h"
#include "plan/unroll.h"

/* ---- the printer's hooks ------------------------------------------------------------------- */

/** Does the update need braces after the `if` that checks ownership? A single expression statement
 * needs none. */
static bool needs_braces(const reduction_update *update) {
    return update->last || update->statement->kind != IR_EXPRESSION;
}

/** Returns the text before an update: the ownership check; in the form for bins, the code that
 * appends a record; in tiles, braces and perhaps a check for the row's first tile. */
static const char *owner_check(loop_text *loop, const reduction_update *update) {
    if (loop->tiles) /* the thread makes all updates of its tiles */
        return tiles_begin_with(loop->tiles, update->statement)
                   ? arena_format(loop->arena, "{ if (redcc__tile->is_first) { %s",
                                  needs_braces(update) ? "{ " : "")
               : needs_braces(update) ? "{ { "
                                      : "{ ";
    const char *target = text_operand(loop->arena, update->target, local_name, loop);
    if (!target) {
        loop_obstacle(loop, update->target->range, "an updated element cannot be spelled");
        return "";
    }
    const char *address = macro_argument(loop->arena, arena_format(loop->arena, "&%s", target));
    const char *brace = needs_braces(update) ? "{ " : "";
    if (loop->bins)
        return arena_format(loop->arena, "{ %s %s", bins_update(loop, update, address, local_name),
                            brace);
    return arena_format(loop->arena, "{ REDCC_UPDATE(%u, %s) %s", update->array, address, brace);
}

static const char *owner_check_end(const loop_text *loop, const reduction_update *update) {
    if (loop->tiles && tiles_begin_with(loop->tiles, update->statement))
        return needs_braces(update) ? "} } }" : "} }";
    return needs_braces(update) ? "} }" : "}";
}

/** If the statement updates a scalar (`s += e`), prints a statement that stores the operand
 * instead, and returns true. */
static bool print_operand(body_copy *copy, const ir_node *statement) {
    loop_text *loop = copy->loop;
    const int number = scalar_update_at(loop->facts, statement);
    if (number < 0)
        return false;
    const ir_node *value = loop->facts->scalars[number].value;
    const char *text = value ? text_expression(loop->arena, value, local_name, loop) : "1";
    if (!text)
        loop_obstacle(loop, statement->range, "an operand cannot be spelled a second time");
    const bool is_once = loop->tiles && tiles_begin_with(loop->tiles, statement);
    if (is_once)
        writer_line(copy->printer.out, "{ if (redcc__tile->is_first)");
    write_operand(loop, copy->printer.out, (unsigned)number, text ? text : "0");
    if (is_once)
        writer_line(copy->printer.out, "}");
    return true;
}

/** If the statement is a forwarded store (`o[t] = e`), prints the assignment of e to the variable
 * that later reads use, then the store of the variable, and returns true. */
static bool print_forward(body_copy *copy, const ir_node *statement) {
    loop_text *loop = copy->loop;
    writer *out = copy->printer.out;
    const forwarded_store *store = forward_stored_by(loop->facts, statement);
    if (!store)
        return false;
    const reduction_update *update = loop_update_at(loop->facts, statement);
    write_forward(loop, out, store, local_name, loop);
    writer_line(out, "%s", owner_check(loop, update));
    write_forwarded_store(loop, out, store, local_name, loop);
    writer_line(out, "%s", owner_check_end(loop, update));
    return true;
}

/** If the statement assigns a conditional live-out (`k = e`), prints the statement and code that
 * records that this iteration assigned k, and returns true. */
static bool print_noted(body_copy *copy, const ir_node *statement) {
    const int number = conditional_live_out_of(copy->loop->facts, statement);
    if (number < 0 || copy->within == statement)
        return false;
    writer_line(copy->printer.out, "{");
    copy->within = statement;
    print_statement(&copy->printer, statement);
    copy->within = NULL;
    write_note(copy->loop, copy->printer.out, (unsigned)number);
    writer_line(copy->printer.out, "}");
    return true;
}

/** If the statement is an inner loop whose updates are recorded before it in bins (a nest or a
 * span: bins_appends), prints code that appends their records, then the loop, and returns true. */
static bool print_appends(body_copy *copy, const ir_node *statement) {
    const char *appends = copy->within == statement || copy->loop->tiles
                              ? NULL
                              : bins_appends(copy->loop, statement, local_name);
    if (!appends)
        return false;
    writer_line(copy->printer.out, "{ %s", appends);
    copy->within = statement;
    print_statement(&copy->printer, statement);
    copy->within = NULL;
    writer_line(copy->printer.out, "}");
    return true;
}

static bool print_checked(printer *p, const ir_node *statement) {
    body_copy *copy = (body_copy *)p;
    if (is_step(copy->loop, statement) || print_appends(copy, statement) ||
        print_operand(copy, statement) || print_forward(copy, statement) ||
        print_noted(copy, statement))
        return true;
    if (copy->within == statement)
        return false;
    const reduction_update *update = loop_update_at(copy->loop->facts, statement);
    if (!update)
        return false;
    if (update->last)
        loop_obstacle(copy->loop, statement->range,
                      "an update of several statements cannot be spelled a second time");
    writer_line(p->out, "%s", owner_check(copy->loop, update));
    copy->within = statement;
    print_statement(p, statement);
    copy->within = NULL;
    writer_line(p->out, "%s", owner_check_end(copy->loop, update));
    return true;
}

/* ---- names --------------------------------------------------------------------------------- */

/** Does the range contain the name of a variable passed by address? */
static bool holds_pointed(const loop_text *loop, ir_range range) {
    for (unsigned i = 0; i < loop->unit->variable_count; i++)
        if (loop->outline.by_address[i] &&
            holds_word(loop->unit->source, range.begin, range.end, loop->unit->variables[i]->name))
            return true;
    return false;
}

/** Is the node an enumerator declared in the function before the body, or a sizeof with a renamed
 * operand? If so, the copy of the body contains the node's value instead. */
static bool is_known_within(const loop_text *loop, const ir_node *node) {
    if (!(node->flags & IR_HAS_VALUE) || node->flags & IR_FROM_MACRO)
        return false;
    if (node->kind == IR_SIZEOF)
        return holds_pointed(loop, node->range);
    if (node->kind != IR_NUMBER)
        return false;
    const ir_unit *unit = loop->unit;
    const ir_range body = loop->facts->function->body->range;
    for (unsigned i = 0; i < unit->reference_count; i++)
        if (unit->references[i].offset == node->range.begin) {
            const ir_declared *declared = unit->references[i].declared;
            return !declared->file && declared->offset >= body.begin &&
                   declared->offset < loop->facts->counted.body->range.begin;
        }
    return false;
}

/** Returns the text that replaces the node, or NULL if there is none. Sets *is_base to whether the
 * node is an array's base. */
static const char *replacement_name(const loop_text *loop, const ir_node *node, bool *is_base) {
    const int array = loop_array_of_base(loop->facts, node);
    *is_base = array >= 0;
    if (node->kind == IR_VARIABLE && loop_loads_has(loop->facts->variables.loads, node->variable))
        return node->variable->name;
    if (array >= 0)
        return loop->arrays[array].is_shadowed ? NULL : loop->arrays[array].local;
    if (is_known_within(loop, node)) /* text_expression writes the value */
        return text_expression(loop->arena, node, NULL, NULL);
    if (node->kind == IR_STRING)
        return says_function_name(loop->plan, node) ? node->text : NULL;
    const char *name = own_name(loop, node);
    if (!name)
        name = forward_read_name(loop, node);
    return name ? name : pointed_name(loop, node);
}

/** Visits each node in the body that must be replaced by another name. */
static void visit_names(body_copy *copy, const ir_node *node,
                        void (*visit)(body_copy *, const ir_node *, const char *name)) {
    bool is_base;
    if (is_clipped(copy->loop, node))
        return;
    const char *name = replacement_name(copy->loop, node, &is_base);
    if (name)
        visit(copy, node, name);
    if (name || is_base)
        return;
    for (unsigned i = 0; i < node->child_count; i++)
        visit_names(copy, node->children[i], visit);
}

static void print_name_in_macro(body_copy *copy, const ir_node *node, const char *name) {
    (void)name;
    if (node->flags & IR_FROM_MACRO)
        print_instead(copy, syntax_enclosing_statement(node, copy->loop->facts->counted.body));
}

static void replace_name(body_copy *copy, const ir_node *node, const char *name) {
    if (!is_printed(copy, node))
        replace_bytes(copy, node->range.begin, node->range.end, name);
}

/* ---- owner checks -------------------------------------------------------------------------- */

static void choose_noted(body_copy *copy, const ir_node *node) {
    if (conditional_live_out_of(copy->loop->facts, node) >= 0)
        print_instead(copy, node);
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        choose_noted(copy, node->children[i]);
}

/** Prints statements with calls of accessors (functions that return an element): each call is
 * written as that element. Also prints loops whose conditions were moved. */
static void choose_accessors(body_copy *copy, const ir_node *node) {
    const bool is_changed = node->flags & (IR_FROM_CALL | IR_OPENED);
    if (is_changed)
        print_instead(copy, syntax_enclosing_statement(node, copy->loop->facts->counted.body));
    for (unsigned i = 0; !is_changed && i < node->child_count; i++)
        choose_accessors(copy, node->children[i]);
}

static void choose_printed_updates(body_copy *copy) {
    const loop_facts *facts = copy->loop->facts;
    for (unsigned i = 0; i < facts->update_count; i++) {
        const ir_node *statement = facts->updates[i].statement;
        if (statement->kind == IR_DECLARATOR)
            statement = statement->parent;
        if (syntax_editable_statement(statement, facts->counted.body) != statement)
            print_instead(copy, statement);
    }
}

static void choose_printed_nests(body_copy *copy, const ir_node *node) {
    const ir_node *body = copy->loop->facts->counted.body;
    if (node->kind == IR_FOR && bins_appends(copy->loop, node, local_name) &&
        syntax_editable_statement(node, body) != node)
        print_instead(copy, node);
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        choose_printed_nests(copy, node->children[i]);
}

static void append_nests(body_copy *copy, const ir_node *node) {
    loop_text *loop = copy->loop;
    const char *appends = node->kind == IR_FOR && !is_printed(copy, node)
                              ? bins_appends(loop, node, local_name)
                              : NULL;
    if (appends) {
        edit_insert(loop->arena, &copy->edits, node->range.begin,
                    arena_format(loop->arena, "{ %s", appends));
        edit_insert(loop->arena, &copy->edits, syntax_statement_end(loop->unit->source, node),
                    " }");
    }
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        append_nests(copy, node->children[i]);
}

/** Is the node in a loop of the iteration that is not unrolled? */
static bool is_in_long_loop(const body_copy *copy, const ir_node *node) {
    while (node != copy->loop->facts->counted.body) {
        node = node->parent;
        if (ir_is_loop(node) && !is_unrolled_in_body(node))
            return true;
    }
    return false;
}

/** Makes the loop's step hide the counter's value from the compiler. In plain iterations the step
 * has no such effect, and in tiles it is unchanged. Otherwise compilers would also unroll loops
 * with updates in the other forms of the body, which would be slow to compile. But in an iteration
 * with a long loop, owner-checked iterations can be a large part of the work: in CoMD's loop over
 * pairs of cells they are a third, and rolled loops cost 5 % of the time. */
static void keep_others_rolled(body_copy *copy, const ir_node *node) {
    const ir_node *step = node->children[2];
    const char *const text = copy->loop->unit->source->text;
    uint32_t at = step->range.begin;
    if (copy->loop->tiles || step->kind == IR_EMPTY || step->children[0]->kind != IR_VARIABLE ||
        !lane_has_update(copy->loop->facts, node) || is_in_long_loop(copy, node))
        return;
    while (at > node->range.begin && strchr(" \t\r\n", text[at - 1]))
        at--;
    const char *counter =
        text_operand(copy->loop->arena, step->children[0], local_name, copy->loop);
    if (counter && at > node->range.begin && text[at - 1] == ';') /* not in a macro's expansion */
        edit_insert(copy->loop->arena, &copy->edits, step->range.begin,
                    arena_format(copy->loop->arena, "REDCC_ROLLED(%s), ", counter));
}

static void unroll_loops(body_copy *copy, const ir_node *node) {
    if (is_unrolled_in_body(node) && !is_printed(copy, node) &&
        takes_pragma(copy->loop->plan, node)) {
        edit_insert(copy->loop->arena, &copy->edits, node->range.begin, "REDCC_UNROLLED ");
        keep_others_rolled(copy, node);
    }
    for (unsigned i = 0; !ir_is_expression(node) && i < node->child_count; i++)
        unroll_loops(copy, node->children[i]);
}

static void check_owners(body_copy *copy) {
    loop_text *loop = copy->loop;
    for (unsigned i = 0; i < loop->facts->update_count; i++) {
        const reduction_update *update = &loop->facts->updates[i];
        const ir_node *first = update->statement;
        const ir_node *last = update->last ? update->last : first;
        if (first->kind == IR_DECLARATOR)
            first = first->parent;
        if (update->last && (is_printed(copy, first) || is_printed(copy, last)))
            loop_obstacle(loop, first->range,
                          "an update of several statements cannot be spelled a second time");
        if (is_printed(copy, first))
            continue;
        edit_insert(loop->arena, &copy->edits, first->range.begin, owner_check(loop, update));
        edit_insert(loop->arena, &copy->edits, syntax_statement_end(loop->unit->source, last),
                    arena_format(loop->arena, " %s", owner_check_end(loop, update)));
    }
}

/* ---- the copy ------------------------------------------------------------------------------ */

static const char *printed_text(body_copy *copy, const ir_node *statement) {
    writer line = {.on_one_line = true};
    copy->printer.out = &line;
    print_statement(&copy->printer, statement);
    return writer_text(copy->loop->arena, &line);
}

/** The body's text, with the user's parts marked. */
static const char *copied_text(body_copy *copy) {
    loop_text *loop = copy->loop;
    const ir_node *body = loop->facts->counted.body;
    const source *text = loop->unit->source;
    if (loop->facts->slice.exits && loop->facts->slice.exits->open)
        VECTOR_PUSH(loop->arena, &copy->printed, body);
    if (body->range.begin <= loop->facts->loop->range.begin) /* one macro expands to header and
                                                              * body */
        VECTOR_PUSH(loop->arena, &copy->printed, body);
    for (unsigned i = 0; i < loop->facts->scalar_count; i++)
        print_instead(copy, loop->facts->scalars[i].statement);
    for (unsigned i = 0; i < loop->facts->forward_count; i++)
        print_instead(copy, loop->facts->forwards[i].statement);
    if (has_conditional_live_outs(loop->facts))
        choose_noted(copy, body);
    visit_names(copy, body, print_name_in_macro);
    choose_accessors(copy, body);
    print_around_omitted(copy);
    choose_printed_updates(copy);
    if (!loop->tiles)
        choose_printed_nests(copy, body);
    visit_names(copy, body, replace_name);
    if (!loop->tiles) {
        skip_inner_iterations(copy, body);
        append_nests(copy, body);
    }
    clip_columns(copy);
    check_owners(copy);
    leave_columns(copy);
    if (!loop->lanes.is_wanted) /* with lanes, the code for lanes is unrolled instead */
        unroll_loops(copy, body);
    if (is_printed(copy, body))
        return printed_text(copy, body);

    drop_omitted(copy);
    for (unsigned i = 0; i < copy->printed.count; i++) {
        const ir_node *statement = copy->printed.items[i];
        replace_bytes(copy, statement->range.begin, syntax_statement_end(text, statement),
                      printed_text(copy, statement));
    }
    buffer out = {0};
    if (!edit_apply_marked(&out, text->text, body->range.begin, syntax_statement_end(text, body),
                           &copy->edits))
        loop_obstacle(loop, body->range, "the changes to its text overlap");
    return buffer_take(loop->arena, &out);
}

static bool reads_below(const ir_node *node, const ir_variable *variable, const ir_node *left_out) {
    if (node->kind == IR_VARIABLE && node->variable == variable)
        return true;
    if (node == left_out)
        return false;
    unsigned first = 0;
    if (node->kind == IR_ASSIGN && node->op == IR_OP_NONE &&
        ir_child(node, 0)->kind == IR_VARIABLE && !ir_value_is_used(node))
        first = 1; /* the variable is only written */
    for (unsigned i = first; i < node->child_count; i++)
        if (reads_below(node->children[i], variable, left_out))
            return true;
    return false;
}

bool body_reads(const loop_facts *facts, const ir_variable *variable) {
    return reads_below(facts->counted.body, variable, body_increment(facts));
}

/** A hook that spells an own element itself, and not the variable that replaces it. */
static const char *element_name(const ir_node *node, void *context) {
    const loop_text *loop = context;
    const int array = loop_array_of_base(loop->facts, node);
    return array >= 0 ? loop->arrays[array].local : pointed_name(loop, node);
}

static void declare_variables(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->variables.private_count; i++) {
        const private_variable *item = &facts->variables.privates[i];
        if (item->is_declared_inside)
            continue;
        writer_line(out, "%s%s%s;", private_declaration(loop, item),
                    body_reads(facts, item->variable) ? "" : " __attribute__((__unused__))",
                    stepped_value(loop, i));
    }
    declare_own(loop, out, false, element_name, loop);
    declare_forwards(loop, out, false);
    declare_repeated_operands(loop, out);
}

static const char *pragma_in_body(const ir_node *loop) {
    return is_unrolled_in_body(loop) ? "REDCC_UNROLLED " : "";
}

void write_iteration(loop_text *loop, writer *out) {
    const ir_node *body = loop->facts->counted.body;
    body_copy copy = {.printer = {.arena = loop->arena,
                                  .rename = local_name,
                                  .context = loop,
                                  .before = print_checked,
                                  .in_front_of_for = loop->lanes.is_wanted ? NULL : pragma_in_body},
                      .loop = loop};
    declare_variables(loop, out);
    note_no_operands(loop, out);
    loop_exits_hide(loop->facts->slice.exits, true);
    const char *text = copied_text(&copy);
    if (copy.printer.problem)
        loop_obstacle(loop, body->range, "%s", copy.printer.problem);
    const char *blanks = loop_column_blanks(loop, body->range.begin);
    buffer_format(&out->out, "%s\n%s", loop_line_directive(loop, body->range.begin), blanks);
    const bool continues = ir_continues(body);
    loop_exits_hide(loop->facts->slice.exits, false);
    const char *head = continues ? "do " : "";
    buffer_text(&out->out, head);
    layout_copy(&out->out, text, ir_position_of(loop->unit, body->range.begin).line,
                (unsigned)(strlen(blanks) + strlen(head)));
    buffer_text(&out->out, continues ? " while (0);\n" : "\n");
    keep_own(loop, out);
    note_live_outs(loop, out);
    if (loop->tiles)
        leave_series(loop, out);
}
