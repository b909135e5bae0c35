/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/emit.h"

#include <assert.h>
#include <string.h>

#include "analysis/invariants.h"
#include "emit/as_compiled.h"
#include "emit/blocks.h"
#include "emit/unfused.h"
#include "emit/write_loop.h"
#include "ir/ir_position.h"
#include "plan/contraction.h"
#include "plan/macros.h"
#include "plan/place.h"

static const char byte_order_mark[] = "\xef\xbb\xbf";

/** The prefix of names that the generated text declares. */
static const char reserved_prefix[] = "redcc__";

/** Does the file's first line end with CR LF? If so, each generated line does, too. */
static bool has_crlf(const source *s) {
    const char *end = memchr(s->text, '\n', s->length);
    return end && end > s->text && end[-1] == '\r';
}

static const char *prelude(arena *a, const ir_unit *unit, contraction where,
                           const plan_options *options, bool has_lanes) {
    const char *vectors =
        has_lanes ? "#ifdef REDCC_RUNTIME_H\n#include <redcc/lanes.h>\n#endif\n" : "";
    return arena_format(
        a,
        REDCC_BEGINNING REDCC_REQUIREMENT "1);\n"
                                          "%s"
                                          "#endif\n"
                                          "#endif\n"
                                          "#ifndef REDCC_RUNTIME_H\n"
                                          "#define REDCC_OVER(redcc_site)\n"
                                          "%s"
                                          "#endif\n"
                                          "%s%s"
                                          "#line 1 %s\n",
        options->linked ? "static const redcc_linkage *redcc__linked(void);\n" : "",
        where == CONTRACTION_OFF_IN_LOOPS ? "#define REDCC_UNFUSED\n" : "",
        where == CONTRACTION_OFF_IN_FILE ? contraction_directives(a, unit, has_lanes) : "", vectors,
        text_quoted(a, ir_position_of(unit, 0).file));
}

/** The reason why no loop of the file can be written, or NULL if there is none. */
static const char *obstacle_of_file(arena *a, const ir_unit *unit) {
    if (holds_word(unit->source, 0, (uint32_t)unit->source->length, reserved_prefix))
        return "the file uses names that begin with redcc__, which are reserved for what redcc "
               "writes";
    const char *macro = macro_name_in_head(unit);
    if (macro)
        return arena_format(a,
                            "the macro '%s', defined before the file begins, would change the "
                            "runtime's header",
                            macro);
    const char *name = taken_name(unit);
    if (name)
        return arena_format(a, "the program uses the name '%s' for something of its own", name);
    return NULL;
}

typedef VECTOR(written_loop) loop_list;

static bool overlaps_another(const loop_list *loops, ir_range range) {
    for (unsigned i = 0; i < loops->count; i++)
        if (range.begin < loops->items[i].replaced.end &&
            loops->items[i].replaced.begin < range.end)
            return true;
    return false;
}

static bool is_around(const ir_unit *unit, const ir_function *function, const ir_declared *tag,
                      ir_range loop) {
    if (tag->file)
        return true;
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *other = unit->functions[i];
        if (other != function && other->body && tag->offset >= other->body->range.begin &&
            tag->offset < other->body->range.end)
            return false;
    }
    return tag->offset < loop.begin;
}

/** Returns a type that the loop's text names but that is not declared at the loop; NULL if there is
 * none. */
static const ir_type *missing_type(const ir_unit *unit, const ir_function *function,
                                   const written_loop *loop) {
    for (unsigned i = 0; i < loop->origins.items.count; i++) {
        const ir_type *type = loop->origins.items.items[i].type;
        const ir_type *bottom = type;
        while (bottom && bottom->target)
            bottom = bottom->target;
        if (bottom && bottom->tag && !is_around(unit, function, bottom->tag, loop->replaced))
            return type;
    }
    return NULL;
}

/* ---- before a function ----------------------------------------------------------------------- */

static bool names_function(const ir_unit *unit, const ir_declared *declared) {
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->declared == declared)
            return true;
    return false;
}

/** Is the name declared before `place` outside of all functions, or in a header, or built in? */
static bool is_known_at(const ir_unit *unit, const ir_declared *declared, uint32_t place) {
    if (!declared)
        return false;
    if (declared->file || strncmp(declared->name, "__builtin_", 10) == 0)
        return true;
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *function = unit->functions[i];
        const uint32_t end = function->body ? function->body->range.end : function->range.end;
        if (!function->body && names_function(unit, declared))
            continue; /* this is g in `int f(void), g(void);` */
        if (function->is_in_main_file && function->declared != declared &&
            declared->offset >= function->range.begin && declared->offset < end)
            return false;
    }
    return declared->offset < place;
}

static bool is_declared_by(const origin_list *origins, const ir_declared *meant) {
    for (unsigned i = 0; i < origins->items.count; i++)
        if (origins->items.items[i].kind == ORIGIN_DECLARED &&
            origins->items.items[i].meant == meant)
            return true;
    return false;
}

/** Is the name declared in the piece itself, or above it? */
static bool is_within_reach(const ir_unit *unit, const written_loop *piece,
                            const ir_declared *declared) {
    const ir_range *body = &piece->copied;
    const bool is_inside = declared && !declared->file && declared->offset >= body->begin &&
                           declared->offset < body->end;
    return is_inside || is_declared_by(&piece->origins, declared) ||
           is_known_at(unit, declared, piece->replaced.begin);
}

/** Is each name in a copy of the user's bytes declared above the piece that contains the copy, or
 * in that piece? */
static bool copy_is_known(const ir_unit *unit, const written_loop *piece, const origin *copy) {
    const uint32_t end = copy->from + (copy->end - copy->begin);
    for (unsigned i = 0; i < unit->reference_count; i++) {
        const ir_reference *reference = &unit->references[i];
        if (reference->offset >= copy->from && reference->offset < end &&
            !is_within_reach(unit, piece, reference->declared))
            return false;
    }
    return true;
}

/** Does the text before a function use only names that are declared above that text or in it? */
static bool all_is_known(const ir_unit *unit, const written_loop *piece) {
    for (unsigned i = 0; i < piece->origins.items.count; i++) {
        const origin *o = &piece->origins.items.items[i];
        const ir_type *bottom = o->kind == ORIGIN_TYPE ? o->type : NULL;
        while (bottom && bottom->target)
            bottom = bottom->target;
        if (bottom && bottom->tag && !is_known_at(unit, bottom->tag, piece->replaced.begin))
            return false;
        if (o->kind == ORIGIN_NAME && !is_within_reach(unit, piece, o->meant))
            return false;
        if (o->kind == ORIGIN_COPY && !copy_is_known(unit, piece, o))
            return false;
    }
    return true;
}

/* ---- loops --------------------------------------------------------------------------------- */

static written_loop unmark(arena *a, const ir_unit *unit, const loop_piece *piece,
                           unsigned number) {
    written_loop result = {.verdict = number, .replaced = piece->replaced};
    result.text =
        origin_unmark(a, piece->text, strlen(piece->text), has_crlf(unit->source), &result.origins);
    return result;
}

/** Inserts the piece so that the list stays in the order of positions. */
static void insert(arena *a, loop_list *loops, written_loop loop) {
    VECTOR_PUSH(a, loops, loop);
    unsigned at = loops->count - 1;
    for (; at > 0 && loops->items[at - 1].replaced.begin > loop.replaced.begin; at--)
        loops->items[at] = loops->items[at - 1];
    loops->items[at] = loop;
}

static loop_form first_form(const loop_text *start, unsigned number, bool has_lanes) {
    const bool is_asked = start->plan->no_lanes != LANES_NOT_ASKED;
    const bool is_without = start->options->no_lanes && start->options->no_lanes[number];
    return is_asked && has_lanes && !is_without ? FORM_LANES : FORM_BINNED;
}

/** Adds the text of one loop. Returns false, with the obstacle in *why, if it cannot be written. */
static bool add_loop(const loop_text *start, loop_form form, const loop_verdict *verdict,
                     unsigned number, loop_list *loops, reason *why) {
    arena *a = start->arena;
    const ir_unit *unit = start->unit;
    loop_piece front = {0}, block = {0};
    if (!write_loop(*start, &form, &front, &block, why))
        return false;
    written_loop moved = unmark(a, unit, &front, number);
    moved.copied = verdict->facts->counted.body->range;
    if (!all_is_known(unit, &moved)) {
        *why = (reason){.message = "it names something that is declared in its function",
                        .range = verdict->loop->range};
        return false;
    }
    written_loop loop = unmark(a, unit, &block, number);
    if (overlaps_another(loops, loop.replaced)) {
        *why = (reason){.message = "another loop's text is part of its own",
                        .range = verdict->loop->range};
        return false;
    }
    const ir_type *missing = missing_type(unit, verdict->facts->function, &loop);
    if (missing) {
        const char *message = arena_format(
            a, "it needs the type '%s', which is not declared around it", missing->spelling);
        *why = (reason){.message = message, .range = verdict->loop->range};
        return false;
    }
    loop.has_lanes = moved.has_lanes = form == FORM_LANES;
    insert(a, loops, moved);
    insert(a, loops, loop);
    return true;
}

/** For each function with a loop for which is_unfused is set, adds, directly before the function,
 * the text that turns contraction off in it. */
static void unfuse_functions(arena *a, const ir_unit *unit, const analysis_result *analysis,
                             const bool *is_unfused, loop_list *loops) {
    const ir_function *last = NULL;
    for (unsigned i = 0; i < loops->count; i++) {
        const written_loop *it = &loops->items[i];
        const unsigned number = it->verdict;
        const ir_function *function = analysis->verdicts[number].facts->function;
        const bool is_in_front = it->replaced.begin == it->replaced.end;
        if (is_in_front || function == last || !is_unfused[number])
            continue;
        last = function;
        loop_piece piece;
        piece.text = unfused_function(a, unit, function, &piece.replaced.begin);
        piece.replaced.end = piece.replaced.begin;
        insert(a, loops, unmark(a, unit, &piece, number));
        i++; /* the insertion has moved this loop's piece up by one */
    }
}

/** Joins the prelude, the unchanged bytes and the pieces into the whole file; sets the pieces'
 * positions in it. */
static void join(arena *a, const ir_unit *unit, contraction where, const plan_options *options,
                 bool has_lanes, loop_list *loops, emit_result *result) {
    const source *s = unit->source;
    const char *head = prelude(a, unit, where, options, has_lanes);
    uint32_t copied = strncmp(s->text, byte_order_mark, 3) == 0 ? 3 : 0;
    buffer out = {0};
    buffer_append(&out, s->text, copied);
    buffer_text(&out, origin_unmark(a, head, strlen(head), has_crlf(s), NULL));
    for (unsigned i = 0; i < loops->count; i++) {
        written_loop *loop = &loops->items[i];
        assert(copied <= loop->replaced.begin && loop->replaced.begin <= loop->replaced.end);
        buffer_append(&out, s->text + copied, loop->replaced.begin - copied);
        loop->begin = (uint32_t)out.length;
        buffer_text(&out, loop->text);
        loop->end = (uint32_t)out.length;
        copied = loop->replaced.end;
    }
    assert(copied <= s->length);
    buffer_append(&out, s->text + copied, s->length - copied);
    if (options->linked)
        buffer_format(&out, "\n#ifdef REDCC_RUNTIME_H\n%s#endif\n", options->linked);
    result->text = arena_copy(a, out.data, out.length);
    result->length = out.length;
    buffer_free(&out);
}

/** Asserts that the pieces are disjoint and in the order of the file, that each belongs to a
 * verdict to be written, and that the origins of a piece lie in its text. */
static void assert_pieces(const ir_unit *unit, const analysis_result *analysis,
                          const loop_list *loops) {
    (void)unit, (void)analysis;
    for (unsigned i = 0; i < loops->count; i++) {
        const written_loop *piece = &loops->items[i];
        assert(piece->verdict < analysis->verdict_count);
        assert(verdict_is_written(&analysis->verdicts[piece->verdict]));
        assert(piece->replaced.end <= unit->source->length && piece->text);
        assert(i == 0 || loops->items[i - 1].replaced.end <= piece->replaced.begin);
        const size_t length = strlen(piece->text);
        for (unsigned k = 0; k < piece->origins.items.count; k++)
            assert(piece->origins.items.items[k].end <= length);
        (void)length;
    }
}

static const loop_plan **plan_loops(arena *a, const ir_unit *unit, const ir_unit *seen,
                                    const analysis_result *analysis, const plan_options *options) {
    const loop_plan **plans = ARENA_ARRAY(a, const loop_plan *, analysis->verdict_count + 1);
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        const loop_verdict *verdict = &analysis->verdicts[i];
        if (verdict->kind != VERDICT_TRANSFORM)
            continue;
        analysis_assert_verdict(unit, verdict);
        plans[i] = plan_loop(a, unit, seen, verdict->facts, options);
    }
    return plans;
}

/** A file that is being written; `whole` and `seen` are `whole` and `unit` of each loop_text. */
typedef struct file_text {
    arena *arena;
    const ir_unit *whole, *seen;
    const analysis_result *analysis;
    const plan_options *options;
    const loop_plan **plans; /* indexed by verdict */
    lanes_outcome *lanes;
    reason *obstacles;
    const char *obstacle; /* the reason why no loop is written, or NULL */
} file_text;

/** Writes the file's loops, with lanes if `has_lanes` and possible. Returns whether some loop has
 * lanes. */
static bool write_loops(const file_text *f, bool has_lanes, const bool *is_unfused,
                        loop_list *loops) {
    bool are_written = false;
    for (unsigned i = 0; i < f->analysis->verdict_count; i++) {
        const loop_plan *plan = f->plans[i];
        if (!plan)
            continue;
        const bool is_asked = plan->no_lanes != LANES_NOT_ASKED;
        const loop_text start = {.arena = f->arena,
                                 .whole = f->whole,
                                 .unit = f->seen,
                                 .facts = plan->facts,
                                 .plan = plan,
                                 .options = f->options,
                                 .is_unfused = is_unfused[i],
                                 .lanes.outcome = is_asked ? &f->lanes[i] : NULL};
        f->obstacles[i] = plan->obstacle;
        if (plan->obstacle.message)
            continue;
        add_loop(&start, first_form(&start, i, has_lanes), &f->analysis->verdicts[i], i, loops,
                 &f->obstacles[i]);
        are_written |= is_asked && f->lanes[i].why == LANES_WRITTEN;
    }
    return are_written;
}

/** May a loop of the file have lanes, according to the plans? Sets f->lanes[] for each verdict:
 * LANES_WRITTEN, or the plan's reason for no lanes. */
static bool may_have_lanes(const file_text *f) {
    bool may = false;
    for (unsigned i = 0; i < f->analysis->verdict_count; i++) {
        const loop_plan *plan = f->plans[i];
        f->lanes[i] = plan ? (lanes_outcome){plan->no_lanes, plan->facts->loop->range}
                           : (lanes_outcome){.why = LANES_NOT_ASKED};
        may |=
            f->lanes[i].why == LANES_WRITTEN && !(f->options->no_lanes && f->options->no_lanes[i]);
    }
    return may;
}

/** Adds the pieces of a loop that is executed in fixed blocks (block_pieces). */
static void add_blocks(const file_text *f, unsigned number, loop_list *loops) {
    const loop_verdict *verdict = &f->analysis->verdicts[number];
    const loop_text start = {.arena = f->arena,
                             .whole = f->whole,
                             .unit = f->whole,
                             .facts = verdict->facts,
                             .options = f->options};
    block_pieces pieces;
    if (!write_blocks(start, &pieces, &f->obstacles[number]))
        return;
    const ir_range all = {pieces.head.replaced.begin, pieces.tail.replaced.end};
    if (overlaps_another(loops, all)) {
        f->obstacles[number] = (reason){.message = "another loop's text is part of its own",
                                        .range = verdict->loop->range};
        return;
    }
    const loop_piece *const all_pieces[] = {&pieces.front, &pieces.head, &pieces.inner,
                                            &pieces.tail};
    for (unsigned i = 0; i < sizeof all_pieces / sizeof *all_pieces; i++)
        if (all_pieces[i]->text)
            insert(f->arena, loops, unmark(f->arena, f->whole, all_pieces[i], number));
}

static void write_file(const file_text *f, emit_result *result) {
    arena *a = f->arena;
    bool has_lanes = may_have_lanes(f);
    for (;;) {
        loop_list loops = {0};
        bool *is_unfused = ARENA_ARRAY(a, bool, f->analysis->verdict_count + 1);
        const contraction where =
            contraction_of(a, f->whole, f->analysis, f->options, has_lanes, is_unfused);
        const bool are_written = write_loops(f, has_lanes, is_unfused, &loops);
        if (has_lanes &&
            !are_written) { /* no loop has lanes: repeat without the prelude's text for lanes */
            has_lanes = false;
            continue;
        }
        for (unsigned i = 0; !f->obstacle && i < f->analysis->verdict_count; i++)
            if (f->analysis->verdicts[i].kind == VERDICT_BLOCKS)
                add_blocks(f, i, &loops);
        unfuse_functions(a, f->whole, f->analysis, is_unfused, &loops);
        result->loop_count = loops.count;
        result->loops = loops.items;
        assert_pieces(f->whole, f->analysis, &loops);
        if (loops.count > 0)
            join(a, f->whole, where, f->options, has_lanes, &loops, result);
        return;
    }
}

static bool some_loop_is_written(const analysis_result *analysis) {
    bool is_any = false;
    for (unsigned i = 0; i < analysis->verdict_count; i++)
        is_any |= verdict_is_written(&analysis->verdicts[i]);
    return is_any;
}

emit_result emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                      const plan_options *options) {
    if (!some_loop_is_written(analysis))
        return (emit_result){.text = unit->source->text,
                             .length = unit->source->length,
                             .obstacles = ARENA_ARRAY(a, reason, analysis->verdict_count + 1)};
    const char *obstacle = options->obstacle ? options->obstacle : obstacle_of_file(a, unit);
    file_text file = {.arena = a,
                      .whole = unit,
                      .seen = unit_as_compiled(a, unit, analysis),
                      .analysis = analysis,
                      .options = options,
                      .obstacle = obstacle,
                      .lanes = ARENA_ARRAY(a, lanes_outcome, analysis->verdict_count + 1),
                      .obstacles = ARENA_ARRAY(a, reason, analysis->verdict_count + 1)};
    assert(options->order <= ORDER_ANY);
    const char **in_order = ARENA_ARRAY(a, const char *, analysis->verdict_count + 1);
    emit_result result = {.text = unit->source->text,
                          .length = unit->source->length,
                          .obstacles = file.obstacles,
                          .lanes = file.lanes,
                          .in_order = in_order};
    file.plans = obstacle ? ARENA_ARRAY(a, const loop_plan *, analysis->verdict_count + 1)
                          : plan_loops(a, unit, file.seen, analysis, options);
    for (unsigned i = 0; i < analysis->verdict_count; i++)
        in_order[i] = file.plans[i] ? file.plans[i]->execution.in_order : NULL;
    write_file(&file, &result);
    for (unsigned i = 0; obstacle && i < analysis->verdict_count; i++)
        if (verdict_is_written(&analysis->verdicts[i]))
            file.obstacles[i] =
                (reason){.message = obstacle, .range = analysis->verdicts[i].loop->range};
    return result;
}
