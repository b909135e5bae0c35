/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/fixed_blocks.h"

#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/loop_text.h"
#include "analysis/base/openmp_loop.h"
#include "analysis/base/openmp_nest.h"
#include "analysis/base/reason.h"
#include "analysis/loop/candidate.h"
#include "analysis/reduction/team_loop.h"

typedef struct search {
    const analyser *an;
    const ir_function *function;
    ir_node *loop;
    openmp_kept why; /* the first reason against fixed blocks */
} search;

static void refuse(search *s, const char *format, const char *name) {
    if (!s->why.text)
        s->why.text = arena_format(s->an->memory, format, name);
}

static const ir_variable *variable_of(const search *s, const char *name) {
    return openmp_variable(s->an->unit, s->loop, s->function, name);
}

/* ---- the directive ------------------------------------------------------------------------- */

static bool reduces_scalar(const search *s, const openmp_item *item) {
    const ir_variable *variable =
        item->kind == OPENMP_REDUCTION && !item->section ? variable_of(s, item->text) : NULL;
    return variable && variable->type->kind != IR_ARRAY;
}

/* Returns the number of compiled OpenMP directives above the loop, and sets *last to the last of
 * them. Sets *unread if a macro produces one of them. */
static unsigned directives_above(const search *s, const ir_directive **last, bool *unread) {
    const ir_unit *unit = s->an->unit;
    unsigned count = 0;
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, s->loop));
         i < unit->directive_count && unit->directives[i].range.end <= s->loop->range.begin; i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->is_skipped || d->kind != IR_DIRECTIVE_PRAGMA || !directive_is_openmp(d))
            continue;
        *unread |= !directive_is_openmp_pragma(d);
        *last = d;
        count++;
    }
    return count;
}

/* May a directive that is not understood reduce something? This is decided by searching its
 * text. */
static bool may_reduce(const openmp_directive *read, const ir_directive *d) {
    return read->kept && strstr(d->text, "reduction") != NULL;
}

static bool is_accepted(const ir_variable *variable) {
    const ir_type *type = variable->type;
    return (type->kind == IR_INTEGER || type->kind == IR_BOOLEAN || type->kind == IR_FLOATING) &&
           !type->is_volatile && !type->is_atomic && variable->storage != IR_THREAD_LOCAL;
}

static void check_item(search *s, const openmp_item *item, fixed_blocks *blocks) {
    const ir_variable *counter = NULL;
    if (item->kind <= OPENMP_REDUCTION && !(counter = variable_of(s, item->text)))
        refuse(s, "a clause with '%s', which is no variable", item->text);
    else if (item->kind == OPENMP_REDUCTION && !reduces_scalar(s, item))
        refuse(s, "'%s', an array, is reduced together with a scalar", item->text);
    else if (item->kind == OPENMP_REDUCTION && !is_accepted(counter))
        refuse(s, "'%s' is reduced, which is no plain number", item->text);
    else if (item->kind == OPENMP_OTHER_CLAUSE)
        refuse(s, "the clause '%s'", item->text);
    else if (strcmp(item->word, "allocate") == 0) /* the clause names private copies, which no other
                                                   * clause of the generated directive would
                                                   * create */
        refuse(s, "the clause 'allocate(%s)'", item->text);
    else if (item->kind == OPENMP_SCHEDULE)
        blocks->is_balanced = strstr(item->text, "static") != NULL;
}

static void read_items(search *s, fixed_blocks *blocks) {
    const openmp_directive *read = &blocks->directive;
    blocked_scalar *scalars = ARENA_ARRAY(s->an->memory, blocked_scalar, read->item_count + 1);
    blocks->is_balanced = true;
    for (unsigned i = 0; i < read->item_count; i++) {
        const openmp_item *item = &read->items[i];
        check_item(s, item, blocks);
        if (reduces_scalar(s, item))
            scalars[blocks->scalar_count++] =
                (blocked_scalar){variable_of(s, item->text), item->word};
    }
    blocks->scalars = scalars;
}

/* ---- the loop ------------------------------------------------------------------------------ */

/* The position after the bracket that closes the loop's header; 0 if the header is not plain
 * text. */
static uint32_t header_end(const source *text, const ir_node *loop) {
    uint32_t at = loop->range.begin;
    if (strncmp(text->text + at, "for", 3) != 0 || source_is_name_byte(text->text[at + 3]))
        return 0;
    unsigned depth = 0;
    for (at = source_skip_blanks(text, at + 3, loop->range.end); at < loop->range.end;
         at = source_skip_blanks(text, at, loop->range.end)) {
        const char c = text->text[at];
        if (depth == 0 && c != '(')
            return 0;
        depth += c == '(';
        if (c == ')' && --depth == 0)
            return at + 1;
        at = c == '"' || c == '\'' ? source_skip_quoted(text, at, loop->range.end) : at + 1;
    }
    return 0;
}

/* Does a directive, which may be a conditional one, begin in the range? */
static bool has_directive_in(const ir_unit *unit, ir_range range) {
    const unsigned next = loop_text_first_directive(unit, range.begin);
    return next < unit->directive_count && unit->directives[next].range.begin < range.end;
}

static bool is_integer(const ir_node *node) {
    return node && (node->type->kind == IR_INTEGER || node->type->kind == IR_BOOLEAN);
}

/* Does the header only count by a constant step from one integer to another? */
static bool is_plain_count(const counted_result *found, const ir_node *loop) {
    const counted_loop *counted = &found->loop;
    return found->is_counted && loop->kind == IR_FOR && !counted->stride && !counted->ahead &&
           counted->start_count == 0 && !counted->bound_variable && !counted->ends_below &&
           !counted->steps_first && !counted_steps_by_statement(loop, counted) &&
           is_integer(counted->lower) && is_integer(counted->bound) &&
           counted->counter->type->kind == IR_INTEGER && counted->counter->type->size <= 8 &&
           !counted->counter->type->is_volatile;
}

static counted_loop check_header(search *s, fixed_blocks *blocks) {
    const ir_unit *unit = s->an->unit;
    const counted_result found = counted_recognise_analysed(s->loop);
    blocks->counter = found.loop.counter;
    blocks->header = (ir_range){s->loop->range.begin, header_end(unit->source, s->loop)};
    if (!is_plain_count(&found, s->loop))
        refuse(s, "%s",
               "the loop's header, which does more than count by a constant step from one integer "
               "to another");
    else if (blocks->header.end == 0 || has_directive_in(unit, blocks->header))
        refuse(s, "%s", "the loop's header, which a macro makes");
    return found.loop;
}

/* The inner loop of a `collapse` clause, if blocks can divide it as well; otherwise NULL. */
static const nested_blocks *find_inner(const search *s, const fixed_blocks *blocks) {
    const ir_unit *unit = s->an->unit;
    ir_node *loop =
        openmp_depth(&blocks->directive) > 1 ? (ir_node *)openmp_inner_loop(s->loop) : NULL;
    if (!loop)
        return NULL;
    const counted_result found = counted_recognise_analysed(loop);
    const ir_range header = {loop->range.begin, header_end(unit->source, loop)};
    if (!is_plain_count(&found, loop) || header.end == 0 ||
        has_directive_in(unit, (ir_range){blocks->header.end, header.end}) ||
        expression_mentions(found.loop.lower, blocks->counter) ||
        expression_mentions(found.loop.bound, blocks->counter))
        return NULL;
    nested_blocks *inner = ARENA_NEW(s->an->memory, nested_blocks);
    *inner = (nested_blocks){header, found.loop, candidate_is_short(unit, ir_loop_body(loop))};
    return inner;
}

/* Is the function, judging by its text, inline but not static? C does not permit static data in it.
 * `__inline__` counts as inline, `noinline` does not. */
static bool is_shared_inline(const ir_function *function, const source *text) {
    if (function->linkage.is_static)
        return false;
    for (uint32_t i = function->range.begin; i + 6 <= function->body->range.begin; i++)
        if (strncmp(text->text + i, "inline", 6) == 0 &&
            (i == 0 || text->text[i - 1] == '_' || !source_is_name_byte(text->text[i - 1])))
            return true;
    return false;
}

/* Does a group of conditional directives contain the function's beginning but not the loop?
 * Compiled with other macros, the function may begin differently, with other types. */
static bool begins_under_condition(const search *s) {
    const ir_unit *unit = s->an->unit;
    int depth = 0;
    for (unsigned i = loop_text_first_directive(unit, s->function->range.begin);
         i < unit->directive_count && unit->directives[i].range.begin < s->loop->range.begin; i++) {
        depth += unit->directives[i].kind == IR_DIRECTIVE_IF;
        depth -= unit->directives[i].kind == IR_DIRECTIVE_ENDIF;
        if (depth < 0)
            return true;
    }
    return false;
}

static void check_body(search *s, const fixed_blocks *blocks) {
    const ir_unit *unit = s->an->unit;
    const ir_range range = s->loop->range;
    if (directives_name(unit, range, "cancel") || directives_name(unit, range, "ordered") ||
        directives_name(unit, range, "scan"))
        refuse(s, "%s", "a directive in the loop that speaks of its iterations");
    if (text_pragma_macro(s->an->memory, unit, s->loop->range))
        refuse(s, "%s", "a macro in the loop that may make a directive");
    if (openmp_knows_thread(&blocks->directive, blocks->directive.construct == OPENMP_FOR
                                                    ? s->function->body
                                                    : s->loop))
        refuse(s, "%s", "the loop asks omp_get_thread_num, and its schedule fixes the answer");
    if (begins_under_condition(s))
        refuse(s, "'%s' has several beginnings", s->function->name);
    if (!s->why.text)
        s->why = openmp_kept_for_devices(unit);
    if (is_shared_inline(s->function, unit->source))
        refuse(s, "'%s' is inline but not static: it cannot hold static data", s->function->name);
    if (s->function->has_errors || unit->dialect.refusing_option)
        refuse(s, "%s", "the function, which is not understood");
}

static const char *lock_in(const ir_unit *unit, ir_range range) {
    return directives_name(unit, range, "critical") ? "critical"
           : directives_name(unit, range, "atomic") ? "atomic"
                                                    : NULL;
}

/* Adds a private clause for the counter if it is declared outside of the loop. The original
 * directive needs none, but the generated directive is above a loop over blocks. */
static void name_counter(const search *s, fixed_blocks *blocks, const counted_loop *counted) {
    openmp_directive *read = &blocks->directive;
    VECTOR(openmp_item) items = {0};
    const openmp_item own = {OPENMP_PRIVATE, REDUCTION_NONE,
                             counted->counter ? counted->counter->name : NULL, NULL, "private"};
    bool is_named = !counted->counter || counted->counter_is_declared_in_header;
    for (unsigned i = 0; i < read->item_count; i++) {
        is_named |= read->items[i].kind <= OPENMP_REDUCTION &&
                    variable_of(s, read->items[i].text) == counted->counter;
        VECTOR_PUSH(s->an->memory, &items, read->items[i]);
    }
    if (!is_named)
        VECTOR_PUSH(s->an->memory, &items, own);
    read->items = items.items;
    read->item_count = items.count;
}

/* ---- the verdict --------------------------------------------------------------------------- */

static loop_facts *facts_of(const search *s, const counted_loop *counted,
                            const fixed_blocks *blocks) {
    loop_facts *facts = ARENA_NEW(s->an->memory, loop_facts);
    facts->loop = s->loop;
    facts->function = (ir_function *)s->function;
    facts->counted = *counted;
    facts->has_short_iterations = candidate_is_short(s->an->unit, ir_loop_body(s->loop));
    facts->variables.openmp = openmp_of_loop(s->an->memory, s->an->unit, s->loop);
    facts->variables.blocks = blocks;
    return facts;
}

void blocks_note_refusal(const analyser *an, const loop_verdict *verdict,
                         const loop_verdict *before) {
    if (before->kind != VERDICT_REFUSE)
        return;
    fixed_blocks *blocks = ARENA_NEW(an->memory, fixed_blocks);
    *blocks = *verdict->facts->variables.blocks;
    blocks->unordered =
        arena_format(an->memory, "%s: %s", reason_code(before->why.id), before->why.message);
    verdict->facts->variables.blocks = blocks;
}

bool blocks_of_loop(const analyser *an, ir_function *function, ir_node *loop,
                    loop_verdict *verdict) {
    search s = {.an = an, .function = function, .loop = loop};
    const ir_directive *above = NULL;
    bool unread = false;
    const unsigned count = directives_above(&s, &above, &unread);
    if (count == 0 || !strstr(above->text, "reduction"))
        return false;
    fixed_blocks *blocks = ARENA_NEW(an->memory, fixed_blocks);
    if (!unread)
        blocks->directive = openmp_read_above(an->memory, an->unit, above, loop);
    read_items(&s, blocks);
    if (!unread && blocks->scalar_count == 0 && !may_reduce(&blocks->directive, above))
        return false;
    if (unread || blocks->directive.kept)
        s.why.text = unread ? "a directive that is not written as one" : blocks->directive.kept;
    else if (count > 1)
        s.why.text = "several directives above the loop";
    else if (blocks->directive.construct > OPENMP_FOR)
        s.why.text = "the construct, which is no 'parallel for' or 'for'";
    const counted_loop counted = check_header(&s, blocks);
    blocks->inner = s.why.text ? NULL : find_inner(&s, blocks);
    name_counter(&s, blocks, &counted);
    check_body(&s, blocks);
    blocks->lock = lock_in(an->unit, loop->range);
    if (!s.why.text && blocks->directive.construct == OPENMP_FOR)
        s.why.text =
            team_of_loop(an, function, loop, &blocks->directive, counted.counter, &blocks->team);
    *verdict = (loop_verdict){.kind = s.why.text ? VERDICT_REFUSE : VERDICT_BLOCKS,
                              .loop = loop,
                              .function = function,
                              .facts = facts_of(&s, &counted, blocks)};
    if (s.why.text)
        verdict->why = reason_make(an->memory, REASON_EXISTING_OPENMP,
                                   arena_format(an->memory, "%s, in '%s'", s.why.text,
                                                openmp_plain_text(an->memory, above->text)),
                                   loop->range);
    if (s.why.advice)
        verdict->why.advice = s.why.advice;
    return true;
}
