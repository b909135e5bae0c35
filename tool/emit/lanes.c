/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The function that executes several iterations at once: what they compute, for all of them, and
 * then their updates, iteration by iteration. No iteration reads what another one of them updates
 * (or the loop could not run in parallel), so that the updates may come last; each element gets
 * them in the order in which it got them before.
 */
#include "emit/lanes.h"

#include "emit/lifter.h"
#include "emit/outline.h"
#include "emit/print.h"
#include "plan/lookup.h"
#include "plan/unroll.h"

static bool has_place(ir_range range) {
    return range.begin < range.end;
}

void lane_note_place(lifter *l, const ir_node *node) {
    if (has_place(node->range))
        l->place = node->range;
}

void lane_problem(const lifter *l, lane_reason why, const ir_node *node) {
    lanes_outcome *outcome = l->loop->lanes.outcome;
    if (outcome->why == LANES_WRITTEN)
        *outcome = (lanes_outcome){why, node && has_place(node->range) ? node->range : l->place};
}

/* ---- what updates ---------------------------------------------------------------------------- */

static bool has_update(const loop_facts *facts, const ir_node *statement) {
    for (unsigned i = 0; i < facts->update_count; i++)
        if (ir_contains(statement, facts->updates[i].statement))
            return true;
    return false;
}

static bool mentions(const ir_node *node, const ir_variable *variable) {
    if (node->variable == variable && (node->kind == IR_VARIABLE || node->kind == IR_DECLARATOR))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions(node->children[i], variable))
            return true;
    return false;
}

/** The variable that this node assigns, steps or declares, or NULL; *other is set where it assigns
 *  something else. */
static const ir_variable *assigned_by(const ir_node *node, bool *other) {
    if (node->kind == IR_DECLARATOR)
        return node->variable;
    if (node->kind != IR_ASSIGN && !ir_is_increment(node))
        return NULL;
    const ir_variable *root = ir_root_variable(node->children[0]);
    *other |= node->children[0]->kind != IR_VARIABLE;
    return root;
}

bool lane_begins_with(const ir_node *loop, const ir_variable *variable) {
    bool other = false;
    const ir_node *first = loop->children[0];
    if (first->kind == IR_DECLARATION) {
        for (unsigned i = 0; i < first->child_count; i++)
            if (first->children[i]->variable == variable && first->children[i]->child_count > 0)
                return true;
        return false;
    }
    return first->kind == IR_ASSIGN && first->op == IR_OP_NONE &&
           assigned_by(first, &other) == variable;
}

/** Is each mention of the variable within a `for` that gives it its first value? Then it does not
 *  matter which of two such loops comes first. */
bool lane_is_counter_only(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_FOR && lane_begins_with(node, variable))
        return true;
    if (node->kind == IR_DECLARATOR && node->variable == variable)
        return node->child_count == 0;
    if (node->kind == IR_VARIABLE && node->variable == variable)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!lane_is_counter_only(node->children[i], variable))
            return false;
    return true;
}

typedef struct update_check {
    lifter *l;
    const ir_node *body;
} update_check;

/** It is executed once for each lane: beside the element it must change nothing. */
static void check_update(lifter *l, const ir_node *statement) {
    const ir_node *value = statement->kind == IR_EXPRESSION ? statement->children[0] : NULL;
    bool is_plain = value && (value->kind == IR_ASSIGN || value->kind == IR_UNARY);
    for (unsigned i = 0; is_plain && i < value->child_count; i++)
        is_plain =
            lane_is_plain(value->children[i]) && !lane_has_whole_lifted(l, value->children[i]);
    if (!is_plain)
        lane_problem(l, NO_LANES_UPDATE, statement);
}

/** Around and beside updates: nothing but counters is assigned, nothing jumps. */
static bool check_update_node(ir_node *node, void *context) {
    const update_check *check = context;
    lifter *l = check->l;
    bool other = false;
    if (loop_update_at(l->loop->facts, node)) {
        check_update(l, node);
        return false;
    }
    if (lane_is_real(node->type) && lane_lifted_element(l, node))
        return false;
    if (node->kind == IR_VARIABLE && l->class_of[node->variable->id] == LANE_LIFTED)
        lane_problem(l, NO_LANES_ARRAY_AS_POINTER, node);
    const ir_variable *variable = assigned_by(node, &other);
    if (other || node->kind == IR_CALL || node->kind == IR_OPAQUE || node->kind == IR_CONTINUE ||
        node->kind == IR_BREAK || node->kind == IR_GOTO || node->kind == IR_LABEL ||
        node->kind == IR_SWITCH || node->kind == IR_WHILE || node->kind == IR_DO ||
        node->kind == IR_RETURN)
        lane_problem(l, NO_LANES_BESIDE_UPDATE, node);
    if (variable && (l->class_of[variable->id] != LANE_UNIFORM || !lane_is_own(l, variable) ||
                     !lane_is_counter_only(check->body, variable)))
        lane_problem(l, NO_LANES_BESIDE_UPDATE, node);
    return true;
}

/** May what the node does change the variable: assign to it, declare it anew, or hand it on? */
static bool may_change(const ir_node *node, const ir_variable *variable) {
    bool other = false;
    if (assigned_by(node, &other) == variable)
        return true;
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
        ir_root_variable(node->children[0]) == variable)
        return true;
    if (node->kind == IR_OPAQUE && mentions(node, variable))
        return true;
    if (variable->type->kind == IR_ARRAY)
        return mentions(node, variable);
    for (unsigned i = 0; i < node->child_count; i++)
        if (may_change(node->children[i], variable))
            return true;
    return false;
}

/** What comes below an update must not change what it reads: it is made later. */
static void check_order(lifter *l, const ir_node *body) {
    for (unsigned i = 0; i < l->loop->unit->variable_count; i++) {
        const ir_variable *variable = l->loop->unit->variables[i];
        if (!lane_is_own(l, variable) || lane_is_counter_only(l->scope, variable))
            continue;
        bool is_read = false;
        for (unsigned k = 0; k < body->child_count; k++) {
            const ir_node *statement = body->children[k];
            if (has_update(l->loop->facts, statement))
                is_read |= mentions(statement, variable);
            else if (is_read && may_change(statement, variable))
                lane_problem(l, NO_LANES_USED_BELOW, statement);
        }
    }
}

typedef struct update_printer {
    printer printer; /* first: the printer's hook gets at the rest through it */
    lifter *l;
} update_printer;

static bool print_update(printer *p, const ir_node *statement) {
    lifter *l = ((update_printer *)p)->l;
    const reduction_update *update = loop_update_at(l->loop->facts, statement);
    if (!update)
        return false;
    const char *target = text_operand(p->arena, update->target, lane_rename, l);
    const char *text = text_expression(p->arena, statement->children[0], lane_rename, l);
    if (!target || !text) {
        lane_problem(l, NO_LANES_SPELLING, statement);
        return true;
    }
    writer_line(p->out, "{ REDCC_UPDATE(%u, %s) %s; }", update->array,
                macro_argument(p->arena, arena_format(p->arena, "&%s", target)), text);
    return true;
}

static const char *pragma_of_updates(const ir_node *loop) {
    return is_unrolled_lane_update(loop) ? "REDCC_UNROLLED_PLAIN " : "";
}

static void write_update(lifter *l, const ir_node *statement, writer *out) {
    update_check check = {l, l->scope};
    lane_note_place(l, statement);
    ir_walk((ir_node *)statement, check_update_node, &check);
    update_printer self = {.printer = {.arena = l->loop->arena, .out = out, .before = print_update},
                           .l = l};
    self.printer.rename = lane_rename;
    self.printer.context = l;
    self.printer.in_front_of_for = pragma_of_updates;
    print_statement(&self.printer, statement);
    if (self.printer.problem)
        lane_problem(l, NO_LANES_SPELLING, statement);
}

/* ---- the function ---------------------------------------------------------------------------- */

/** Is an array updated that the lanes cannot name? */
static bool has_unnamed_array(const loop_text *loop) {
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].is_scattered || !loop->arrays[i].local)
            return true;
    return false;
}

static bool has_other_values(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_stepped)
            return true;
    return facts->scalar_count > 0 || facts->forward_count > 0 || has_sought_values(facts) ||
           has_last_values(facts);
}

bool may_have_lanes(const loop_text *loop) {
    const loop_facts *facts = loop->facts;
    const lane_reason why =
        has_other_values(facts)             ? NO_LANES_OTHER_VALUES
        : loop->options->order == ORDER_ANY ? NO_LANES_ANY_ORDER
        : facts->counted.counter->type->kind == IR_POINTER || facts->counted.stride
            ? NO_LANES_COUNTER
        : facts->counted.body->kind != IR_BLOCK ? NO_LANES_BODY
        : has_unnamed_array(loop)               ? NO_LANES_SCATTERED
                                                : LANES_WRITTEN;
    *loop->lanes.outcome = (lanes_outcome){why, facts->loop->range};
    return why == LANES_WRITTEN;
}

static void declare_outer(lifter *l) {
    const loop_facts *facts = l->loop->facts;
    const ir_variable *counter = facts->counted.counter;
    arena *a = l->loop->arena;
    for (unsigned i = 0; i < facts->variables.private_count; i++) {
        const ir_variable *variable = facts->variables.privates[i].variable;
        if (facts->variables.privates[i].is_declared_inside || !mentions(l->scope, variable))
            continue;
        lane_declare(l, variable);
    }
    writer_line(l->out, "int redcc__l;");
    writer_line(l->out, "(void)redcc__guarded;");
    lane_declare(l, counter);
    writer_line(l->out,
                "REDCC_EACH_LANE %s[redcc__l] = (%s)(redcc__lower + %lld * "
                "redcc__block->k[redcc__l]);",
                origin_variable(a, counter), lane_type(l, counter->type),
                (long long)facts->counted.step);
}

/** Most lanes need not ask who owns what: for them compilers have a text without conditions. */
static void write_updates(lifter *l, const char *updates) {
    if (l->mask)
        writer_line(l->out, "REDCC_EACH_LANE if (%s[redcc__l]) {", l->mask);
    else
        writer_line(l->out, "REDCC_EACH_LANE {");
    writer_line(l->out, "    if (!redcc__block->guarded[redcc__l]) {");
    writer_line(l->out, "        enum { redcc__guarded = 0 };");
    buffer_text(&l->out->out, updates);
    writer_line(l->out, "    } else {");
    writer_line(l->out, "        enum { redcc__guarded = 1 };");
    buffer_text(&l->out->out, updates);
    writer_line(l->out, "    }");
    writer_line(l->out, "}");
}

/** `if (...) continue;`? */
static bool is_exit(const ir_node *statement) {
    if (statement->kind != IR_IF || statement->child_count > 2)
        return false;
    const ir_node *branch = statement->children[1];
    if (branch->kind == IR_BLOCK && branch->child_count == 1)
        branch = branch->children[0];
    return branch->kind == IR_CONTINUE;
}

/** Lanes for which the condition holds have done all that they do. */
static void write_exit(lifter *l, const ir_node *condition) {
    if (lane_is_uniform(l, condition)) {
        writer_line(l->out, "if (%s)", lane_condition(l, condition));
        writer_line(l->out, "    return;");
        return;
    }
    l->mask = lane_new_mask(l, arena_format(l->loop->arena, "~%s", lane_mask(l, condition)));
    writer_line(l->out, "if (!redcc_any(%s))", l->mask);
    writer_line(l->out, "    return;");
}

/** An `if` that computes and updates. */
static bool is_part(const loop_facts *facts, const ir_node *statement) {
    if (statement->kind != IR_IF || statement->child_count > 2 ||
        statement->children[1]->kind != IR_BLOCK)
        return false;
    const ir_node *branch = statement->children[1];
    for (unsigned i = 0; i < branch->child_count; i++)
        if (!has_update(facts, branch->children[i]))
            return true;
    return false;
}

static void write_block(lifter *l, const ir_node *block);

/** The last of what is done: nothing that the other lanes hold is of use any more. */
static void write_last_part(lifter *l, const ir_node *node) {
    const char *const outer = l->mask;
    if (lane_is_uniform(l, node->children[0])) {
        writer_line(l->out, "if (%s) {", lane_condition(l, node->children[0]));
    } else {
        l->mask = lane_new_mask(l, lane_mask(l, node->children[0]));
        writer_line(l->out, "if (redcc_any(%s)) {", l->mask);
    }
    l->out->depth++;
    write_block(l, node->children[1]);
    l->out->depth--;
    writer_line(l->out, "}");
    l->mask = outer;
}

/** What is computed, and then the updates. */
static void write_block(lifter *l, const ir_node *block) {
    const loop_facts *facts = l->loop->facts;
    writer updates = {.depth = l->out->depth + 2};
    bool is_pending = false;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *statement = block->children[i];
        const bool updates_here = has_update(facts, statement);
        if (!is_pending && is_exit(statement))
            write_exit(l, statement->children[0]);
        else if (!is_pending && updates_here && i + 1 == block->child_count &&
                 is_part(facts, statement))
            write_last_part(l, statement);
        else if (updates_here) {
            write_update(l, statement, &updates);
            is_pending = true;
        } else
            lane_statement(l, statement);
    }
    check_order(l, block);
    if (is_pending)
        write_updates(l, writer_text(l->loop->arena, &updates));
}

/** The text, once for each width that is asked for. */
static void write_copies(const loop_text *loop, writer *out, const char *text) {
    for (unsigned width = 2; width <= 8; width *= 2) {
        if (loop->options->lanes > 1 && loop->options->lanes != width)
            continue;
        writer_line(out, "#if REDCC_WIDTHS & %u", width);
        writer_line(out, "#undef redcc_width");
        writer_line(out, "#define redcc_width %u", width);
        writer_line(out, "#include <redcc/lanes_width.h>");
        buffer_text(&out->out, text);
        writer_line(out, "#endif");
    }
}

/** The function, behind those that it calls; NULL: it cannot be written. */
static const char *function_text(loop_text *loop, const char *name, bool *is_kept) {
    const loop_facts *facts = loop->facts;
    arena *a = loop->arena;
    lane_clone_list clones = {0};
    writer front = {0}, text = {.depth = 1};
    unsigned mask_count = 0;
    lifter l = {.loop = loop,
                .scope = facts->counted.body,
                .class_of = ARENA_ARRAY(a, lane_class, loop->unit->variable_count + 1),
                .clones = &clones,
                .front = &front,
                .out = &text,
                .is_kept = is_kept,
                .mask_count = &mask_count,
                .place = facts->loop->range};
    lane_classify(&l);
    declare_outer(&l);
    write_block(&l, l.scope);
    writer_line(
        &front,
        "REDCC_LANES_BODY REDCC_WIDE(%s)(REDCC_BODY_PARAMETERS_%u, const redcc_block *const "
        "redcc__block, const redcc_int redcc__lower%s) {",
        name, facts->array_count, loop->outline.body_parameters);
    buffer_text(&front.out, writer_text(a, &text));
    writer_line(&front, "}");
    const char *whole = writer_text(a, &front);
    return loop->lanes.outcome->why == LANES_WRITTEN ? whole : NULL;
}

void write_lanes(loop_text *loop, writer *out) {
    arena *a = loop->arena;
    if (!loop->lanes.is_wanted || !loop->outline.possible)
        return;
    const char *name = arena_format(a, "redcc__%s", loop_lanes_name(loop));
    bool *is_kept = ARENA_ARRAY(a, bool, loop->unit->variable_count + 1);
    const char *text = function_text(loop, name, is_kept);
    if (text) /* now it is known which variables need a first value */
        text = function_text(loop, name, is_kept);
    if (!text)
        return;
    loop->lanes.name = name;
    loop->lanes.arguments =
        arena_format(a, "REDCC_BODY_ARGUMENTS_%u, &redcc__block, redcc__lower%s",
                     loop->facts->array_count, loop->outline.body_arguments);
    write_copies(loop, out, text);
}
