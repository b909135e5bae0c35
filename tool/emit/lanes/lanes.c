/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Writes the function that executes several iterations at once: first the computations of all of
 * them, and then their updates, iteration by iteration. plan/lanes.h explains why this is sound.
 */
#include "emit/lanes/lanes.h"

#include "emit/base/names.h"
#include "emit/lanes/vectoriser.h"
#include "emit/text/origin.h"
#include "emit/text/print.h"
#include "plan/lane_calls.h"
#include "plan/lookup.h"
#include "plan/unroll.h"

/* ---- updates --------------------------------------------------------------------------------- */

typedef struct update_printer {
    printer printer; /* must come first: print_update casts the printer to an update_printer */
    vectoriser *l;
} update_printer;

static bool print_update(printer *p, const ir_node *statement) {
    vectoriser *l = ((update_printer *)p)->l;
    const reduction_update *update = loop_update_at(l->loop->facts, statement);
    if (!update)
        return false;
    const char *target = text_operand(p->arena, update->target, lane_rename, l);
    const char *text = text_expression(p->arena, statement->children[0], lane_rename, l);
    if (!target || !text) {
        lane_problem(&l->in, NO_LANES_SPELLING, statement);
        return true;
    }
    writer_line(p->out, "{");
    p->out->depth++;
    writer_line(p->out, "REDCC_UPDATE(%u, %s)", update->array,
                macro_argument(p->arena, arena_format(p->arena, "&%s", target)));
    writer_line(p->out, "%s;", text);
    p->out->depth--;
    writer_line(p->out, "}");
    return true;
}

static const char *pragma_of_updates(const ir_node *loop) {
    return is_unrolled_lane_update(loop) ? "REDCC_UNROLLED_PLAIN " : "";
}

static void write_update(vectoriser *l, const ir_node *statement, writer *out) {
    lane_note_place(&l->in, statement);
    lane_check_updates(&l->in, statement);
    update_printer self = {.printer = {.arena = l->loop->arena, .out = out, .before = print_update},
                           .l = l};
    self.printer.rename = lane_rename;
    self.printer.context = l;
    self.printer.in_front_of_for = pragma_of_updates;
    print_statement(&self.printer, statement);
    if (self.printer.problem)
        lane_problem(&l->in, NO_LANES_SPELLING, statement);
}

/* ---- the function ---------------------------------------------------------------------------- */

static void declare_outer(vectoriser *l) {
    const loop_facts *facts = l->loop->facts;
    const ir_variable *counter = facts->counted.counter;
    arena *a = l->loop->arena;
    for (unsigned i = 0; i < facts->variables.private_count; i++) {
        const ir_variable *variable = facts->variables.privates[i].variable;
        if (facts->variables.privates[i].is_declared_inside || !lane_mentions(l->in.body, variable))
            continue;
        lane_declare(l, variable);
    }
    writer_line(l->out, "int redcc__l;");
    writer_line(l->out, "(void)redcc__checked;");
    lane_declare(l, counter);
    writer_line(l->out,
                "REDCC_EACH_LANE %s[redcc__l] = (%s)(redcc__lower + %lld * "
                "redcc__block->k[redcc__l]);",
                origin_variable(a, counter), lane_type(l, counter->type),
                (long long)facts->counted.step);
}

/** Writes the updates twice: with ownership checks, and without them. Most lanes need no checks. */
static void write_updates(vectoriser *l, const char *updates) {
    if (l->mask)
        writer_line(l->out, "REDCC_EACH_ITERATION if (%s[redcc__l]) {", l->mask);
    else
        writer_line(l->out, "REDCC_EACH_ITERATION {");
    writer_line(l->out, "    if (!redcc__block->checked[redcc__l]) {");
    writer_line(l->out, "        enum { redcc__checked = 0 };");
    buffer_text(&l->out->out, updates);
    writer_line(l->out, "    } else {");
    writer_line(l->out, "        enum { redcc__checked = 1 };");
    buffer_text(&l->out->out, updates);
    writer_line(l->out, "    }");
    writer_line(l->out, "}");
}

/** Writes `if (...) continue;`: lanes for which the condition holds become inactive. */
static void write_exit(vectoriser *l, const ir_node *condition) {
    if (lane_is_uniform(&l->in, condition)) {
        writer_line(l->out, "if (%s)", lane_condition(l, condition));
        writer_line(l->out, "    return;");
        return;
    }
    l->mask = lane_new_mask(l, arena_format(l->loop->arena, "~%s", lane_mask(l, condition)));
    writer_line(l->out, "if (!redcc_any(%s))", l->mask);
    writer_line(l->out, "    return;");
}

static void write_block(vectoriser *l, const ir_node *block);

/** Writes a block's last statement, an `if` with updates. Variables set in it need no select (a
 * choice by mask between old and new value), because values of inactive lanes are not used after
 * the `if`. */
static void write_last_part(vectoriser *l, const ir_node *node) {
    const char *const outer = l->mask;
    if (lane_is_uniform(&l->in, node->children[0])) {
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

/** Writes the block's computations, and then its updates. */
static void write_block(vectoriser *l, const ir_node *block) {
    const loop_facts *facts = l->loop->facts;
    writer updates = {.depth = l->out->depth + 2};
    bool is_pending = false;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *statement = block->children[i];
        const bool updates_here = lane_has_update(facts, statement);
        if (statement == body_increment(facts))
            continue; /* each lane's counter is computed, after a step at the body's beginning */
        if (!is_pending && lane_is_exit(statement))
            write_exit(l, statement->children[0]);
        else if (!is_pending && updates_here && i + 1 == block->child_count &&
                 lane_is_part(facts, statement))
            write_last_part(l, statement);
        else if (updates_here) {
            write_update(l, statement, &updates);
            is_pending = true;
        } else
            lane_statement(l, statement);
    }
    lane_check_order(&l->in, block);
    if (is_pending)
        write_updates(l, writer_text(l->loop->arena, &updates));
}

/** Returns the text of the function, preceded by the vector forms of functions that it calls.
 * Returns NULL if it cannot be written. */
static const char *function_text(loop_text *loop, const char *name, bool *is_kept) {
    const loop_facts *facts = loop->facts;
    arena *a = loop->arena;
    lane_clone_list clones = {0};
    writer front = {0}, text = {.depth = 1};
    unsigned mask_count = 0;
    vectoriser l = {.in = {.plan = loop->plan,
                           .body = facts->counted.body,
                           .class_of = ARENA_ARRAY(a, lane_class, loop->unit->variable_count + 1),
                           .place = facts->loop->range,
                           .outcome = loop->lanes.outcome},
                    .loop = loop,
                    .clones = &clones,
                    .front = &front,
                    .out = &text,
                    .is_kept = is_kept,
                    .mask_count = &mask_count};
    lane_classify(&l.in);
    lane_check_worth(&l.in);
    lane_check_errors(&l.in);
    declare_outer(&l);
    write_block(&l, l.in.body);
    writer_line(&front,
                "REDCC_LANES_BODY %s(REDCC_BODY_PARAMETERS_%u, const redcc_block *const "
                "redcc__block, const redcc_int redcc__lower%s) {",
                name, facts->array_count, loop->outline.body_parameters);
    writer_line(&front, "    REDCC_LANES_BY_CALLS");
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
    if (text) /* a second time: only now does is_kept say which variables need an initial value */
        text = function_text(loop, name, is_kept);
    if (!text)
        return;
    loop->lanes.name = name;
    loop->lanes.arguments =
        arena_format(a, "REDCC_BODY_ARGUMENTS_%u, &redcc__block, redcc__lower%s",
                     loop->facts->array_count, loop->outline.body_arguments);
    writer_line(out, "#if REDCC_WIDTH");
    writer_line(out, "REDCC_QUIET_LANES");
    buffer_text(&out->out, text);
    writer_line(out, "#endif");
}
