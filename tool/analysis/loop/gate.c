/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/gate.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/base/expression.h"
#include "analysis/base/loop_text.h"
#include "analysis/base/openmp_loop.h"
#include "analysis/base/openmp_nest.h"
#include "analysis/base/step_inside.h"
#include "analysis/loop/conflict.h"

/* ---- the source text ------------------------------------------------------------------------- */

/* Skips blanks, comments, empty statements, directives, and text that is not compiled (a
 * compilation that does compile it uses the original loop: as_compiled.h). Returns the beginning of
 * any other text, or `to`. */
static uint32_t skip_to_text(const analyser *an, uint32_t from, uint32_t to) {
    const ir_unit *unit = an->unit;
    while ((from = source_skip_blanks(unit->source, from, to)) < to) {
        const unsigned next = loop_text_first_directive(unit, from);
        if (next < unit->directive_count && unit->directives[next].range.begin == from)
            from = loop_text_end_of_branch(unit, next);
        else if (unit->source->text[from] == ';')
            from++;
        else
            return from;
    }
    return to;
}

/* A macro that may expand to a pragma, before the loop in the statement that contains it:
 * `if (n > 3) IVDEP for (...)`. NULL if there is none. */
static const char *pragma_macro_before(const loop_analysis *j, uint32_t to) {
    const ir_unit *unit = j->an->unit;
    const ir_range above = {j->loop->parent->range.begin, to};
    return text_pragma_macro(j->an->memory, unit, above);
}

/* Finds text, which must be a macro or a _Pragma, between the preceding statement and the loop.
 * This macro may apply to the loop, and a compiler may require a loop after it. */
static reason check_text_before(const loop_analysis *j, uint32_t text_begin) {
    const source *s = j->an->unit->source;
    const ir_node *block = j->loop->parent;
    if (!s || !block || block->range.begin >= block->range.end)
        return (reason){0};
    const uint32_t to = text_begin;
    if (block->kind != IR_BLOCK) {
        const char *macro = pragma_macro_before(j, to);
        return macro ? analysis_reason(j, REASON_DIRECTIVE_IN_RANGE, j->loop, macro) : (reason){0};
    }
    uint32_t from = block->range.begin;
    /* if no brace begins here, the brace comes from a macro, perhaps together with other text */
    static const char *const braces[] = {"{", "<%", "?\?<"};
    for (unsigned i = 0; i < sizeof braces / sizeof *braces; i++)
        if (strncmp(s->text + from, braces[i], strlen(braces[i])) == 0)
            from += (uint32_t)strlen(braces[i]);
    for (unsigned i = 0; i < block->child_count && block->children[i] != j->loop; i++)
        if (block->children[i]->range.end > from)
            from = block->children[i]->range.end;
    const uint32_t at = skip_to_text(j->an, from, to);
    if (at >= to)
        return (reason){0};
    uint32_t end = at;
    while (end < to && s->text[end] != '\n' && end - at < 40)
        end++;
    return analysis_reason(j, REASON_DIRECTIVE_IN_RANGE, j->loop,
                           arena_copy(j->an->memory, s->text + at, end - at));
}

static reason openmp_reason(const loop_analysis *j, const ir_directive *d) {
    return analysis_reason(j, REASON_EXISTING_OPENMP, j->loop,
                           arena_format(j->an->memory, "'%s'", d->text));
}

static reason openmp_kept_reason(const loop_analysis *j, openmp_kept kept) {
    reason why = analysis_reason(j, REASON_EXISTING_OPENMP, j->loop, kept.text);
    if (kept.advice)
        why.advice = kept.advice;
    return why;
}

/* Finds an OpenMP directive that must stay, of the loop or of a nest around it. Directives that
 * this compilation ignores do not count, nor do those that redcc can replace according to their
 * text. */
static reason check_openmp(const loop_analysis *j, uint32_t text_begin) {
    const ir_unit *unit = j->an->unit;
    const ir_directive *above = loop_text_openmp_above(unit, j->loop);
    const bool is_replaced = unit->dialect.replaces_openmp;
    const openmp_loop *openmp = is_replaced ? j->an->openmp : NULL;
    if (above && !directive_is_ignored_openmp(unit, above) &&
        (!openmp || above->is_skipped || above->range.begin < text_begin))
        return openmp_reason(j, above);
    const char *nest = openmp_about_nest(j->an->memory, unit, j->loop);
    if (nest)
        return analysis_reason(j, REASON_EXISTING_OPENMP, j->loop,
                               arena_format(j->an->memory, "'%s', of a loop around it", nest));
    return openmp && openmp->kept.text ? openmp_kept_reason(j, openmp->kept) : (reason){0};
}

static reason check_directives(const loop_analysis *j) {
    const ir_unit *unit = j->an->unit;
    const char *fenv_access = unit_text_fenv_access(j->an->text);
    if (fenv_access)
        return analysis_reason(j, REASON_FENV_ACCESS, j->loop, fenv_access);
    const uint32_t begin = loop_text_begin(unit, j->loop);
    const reason why = check_openmp(j, begin);
    if (why.id != REASON_NONE)
        return why;
    const ir_directive *obstacle = loop_text_obstacle(unit, j->loop);
    if (obstacle && directive_is_openmp(obstacle))
        return openmp_reason(j, obstacle);
    if (obstacle)
        return analysis_reason(j, REASON_DIRECTIVE_IN_RANGE, j->loop,
                               obstacle->text ? obstacle->text : "#");
    const char *macro =
        text_pragma_macro(j->an->memory, unit, (ir_range){begin, j->loop->range.end});
    return macro ? analysis_reason(j, REASON_DIRECTIVE_IN_RANGE, j->loop, macro)
                 : check_text_before(j, begin);
}

/* ---- names ----------------------------------------------------------------------------------- */

static bool is_from_macro(const ir_node *node) {
    return node->flags & IR_FROM_MACRO;
}

reason check_text(const loop_analysis *j) {
    const source *s = j->an->unit->source;
    const ir_node *loop = j->loop;
    assert(ir_is_loop(loop) && j->function->body);
    if (j->an->unit->dialect.refusing_option)
        return analysis_reason(j, REASON_OPTION, loop, j->an->unit->dialect.refusing_option);
    if (j->function->has_errors)
        return analysis_reason(j, REASON_ERRORS, loop, j->function->name);
    if (loop->flags & IR_FROM_MACRO)
        return analysis_reason(j, REASON_IN_MACRO, loop, "the loop");
    if (loop->range.begin >= loop->range.end)
        return analysis_reason(j, REASON_NO_RANGE, loop, "the loop");
    if (j->an->unit->text.includes_itself)
        return analysis_reason(j, REASON_SELF_INCLUDED, loop, s ? s->path : "the file");
    const reason why = check_directives(j);
    if (why.id != REASON_NONE)
        return why;
    const ir_range everything = {0, s ? s->length : 0};
    const bool is_anywhere =
        ir_any(loop, is_from_macro) || loop_text_has_branches(j->an->unit, loop);
    if ((is_anywhere && j->an->unit->text.names_counter) ||
        unit_text_has_counter(j->an->text, is_anywhere ? everything : loop->range))
        return analysis_reason(j, REASON_COUNTER_MACRO, loop, "__COUNTER__");
    const char *name;
    bool is_setjmp;
    const ir_node *obstacle = unit_text_obstacle(j->an->text, j->function, &name, &is_setjmp);
    if (!obstacle)
        return (reason){0};
    return analysis_reason(j, is_setjmp ? REASON_SETJMP : REASON_NAME, obstacle, name);
}

/* ---- jumps ----------------------------------------------------------------------------------- */

/* Checks a node for jumps. `loops_and_switches` and `switches` count the statements of these kinds
 * between `node` and the analysed loop. A case label outside of any inner switch belongs to a
 * switch around the loop, which then jumps into the loop. */
static reason check_jump(const loop_analysis *j, const ir_node *node, unsigned loops_and_switches,
                         unsigned switches) {
    assert(switches <= loops_and_switches);
    switch (node->kind) {
    case IR_BREAK:
        if (!loops_and_switches)
            return analysis_reason(j, REASON_BREAK, node, NULL);
        break;
    case IR_RETURN:
        return analysis_reason(j, REASON_RETURN, node, NULL);
    case IR_GOTO:
    case IR_LABEL:
        return analysis_reason(j, REASON_GOTO, node, NULL);
    case IR_CASE:
    case IR_DEFAULT:
        if (!switches)
            return analysis_reason(j, REASON_GOTO, node, NULL);
        break;
    default:
        break;
    }
    if (ir_is_loop(node) || node->kind == IR_SWITCH)
        loops_and_switches++;
    if (node->kind == IR_SWITCH)
        switches++;
    reason why = {0};
    for (unsigned i = 0; i < node->child_count && why.id == REASON_NONE; i++)
        why = check_jump(j, node->children[i], loops_and_switches, switches);
    return why;
}

reason check_jumps(const loop_analysis *j) {
    reason why = {0};
    for (unsigned i = 0; i < j->loop->child_count && why.id == REASON_NONE; i++)
        why = check_jump(j, j->loop->children[i], 0, 0);
    return why;
}

/* ---- accesses -------------------------------------------------------------------------------- */

static bool is_errno(const ir_node *node) {
    return node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
           strcmp(node->children[0]->function->name, "__errno_location") == 0;
}

/* Does any function of the file read errno? The loop's caller may be one of them. */
static bool file_reads_errno(const ir_unit *unit) {
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->body && ir_any(unit->functions[i]->body, is_errno))
            return true;
    return false;
}

/* Refuses the loop if it uses the value of an update by an operator, and the updated element is one
 * that iterations share. */
static reason check_values(const loop_analysis *j, const access_list *found) {
    for (unsigned i = 0; i < found->items.count; i++) {
        const access *a = &found->items.items[i];
        if (a->kind == ACCESS_UPDATE && !a->callee && a->form.has_operator &&
            ir_value_is_used(a->lvalue->parent) &&
            conflict_is_shared(j->an->facts, j->loop, a->lvalue))
            return analysis_reason(j, REASON_UPDATE_VALUE_USED, a->lvalue->parent,
                                   analysis_name(j, a->lvalue));
    }
    return (reason){0};
}

/* Advice on a function with an OpenMP directive that the loop calls. */
static const char *advice_on_called_openmp(const loop_analysis *j) {
    if (!j->an->unit->dialect.has_openmp)
        return "remove the directive, or write the update in the loop's own text, under the "
               "directive";
    return j->an->openmp
               ? "if it protects an update, write the update in the loop's own text, under the "
                 "directive"
               : "if one thread executes the loop, remove the directive; otherwise write the "
                 "update "
                 "in the loop's own text, under it, and #pragma omp parallel for above the loop";
}

static reason first_problem(const loop_analysis *j, const access_list *list) {
    if (!list->problems.count)
        return (reason){0};
    const access_problem *p = &list->problems.items[0];
    reason why = analysis_reason(j, p->why, p->node, p->name);
    if (p->why == REASON_EXISTING_OPENMP)
        why.advice = advice_on_called_openmp(j);
    return why;
}

/* The reason for which the values that the header sets cannot be computed twice. Generated code
 * computes them, and the original loop computes them again if it runs instead. */
static reason check_lower(const loop_analysis *j) {
    access_list list = {0};
    if (j->counted.lower)
        access_collect(j->an->effects, j->counted.lower, &list);
    for (unsigned i = 0; i < j->counted.start_count; i++)
        access_collect(j->an->effects, j->counted.starts[i].value, &list);
    return first_problem(j, &list);
}

/* Checks the bound. Generated code computes the bound once, but the sequential loop computes it
 * before each iteration. The bound may therefore call only functions that write nothing and whose
 * results are repeatable. Memory that the bound reads is checked for changes like all reads of the
 * loop. */
static reason check_bound(const loop_analysis *j) {
    access_list list = {0};
    access_collect(j->an->effects, j->counted.bound, &list);
    bool is_repeatable = expression_is_plain(j->counted.bound) ||
                         (!list.has_floating_work && !list.has_unrepeatable_work);
    for (unsigned i = 0; i < list.items.count && !list.problems.count; i++)
        is_repeatable &= list.items.items[i].kind == ACCESS_READ;
    if (is_repeatable)
        return (reason){0};
    return analysis_reason(j, REASON_TRIP_COUNT, j->counted.bound, j->counted.counter->name);
}

/* Refuses a loop that may access its counter through a pointer, which is possible if the counter's
 * address is taken. */
static reason check_counter(const loop_analysis *j, const access_result *result) {
    const ir_variable *counter = j->counted.counter;
    const location where = {.object = counter, .type = counter->type};
    for (unsigned i = 0; counter->address_taken && i < result->count; i++) {
        const loop_access *a = &result->accesses[i];
        const bool is_by_name = a->access.kind == ACCESS_READ && !a->access.callee &&
                                a->access.lvalue && a->access.lvalue->kind == IR_VARIABLE &&
                                a->access.lvalue->variable == counter;
        if (!is_by_name && locations_overlap(&j->an->rules, &a->where, &where) != OVERLAP_NO)
            return analysis_reason(j, REASON_COUNTER_MODIFIED, a->access.node, counter->name);
    }
    return (reason){0};
}

/* Finds reasons that do not depend on where the accesses are in memory. */
static reason check_all(const loop_analysis *j, const access_list *found) {
    const ir_unit *unit = j->an->unit;
    reason why = check_values(j, found);
    if (why.id == REASON_NONE)
        why = first_problem(j, found);
    if (why.id == REASON_NONE && found->ends.count && !j->left_out.exits)
        why = analysis_reason(j, REASON_NO_RETURN, found->ends.items[0], "assert");
    if (why.id != REASON_NONE)
        return why;
    if (unit->dialect.inexact_option && !j->an->options->any_order)
        return analysis_reason(j, REASON_INEXACT_OPTION, j->loop, unit->dialect.inexact_option);
    if (found->may_set_errno && unit->dialect.math_errno && file_reads_errno(unit))
        return analysis_reason(j, REASON_ERRNO, j->loop, found->errno_setter);
    return (reason){0};
}

static loop_access access_in_loop(const loop_analysis *j, const access *found) {
    loop_access a = {.access = *found, .where = {.is_inexact = true}};
    if (a.access.lvalue && !a.access.callee)
        a.access.lvalue = lvalue_before_steps(j->an->memory, a.access.lvalue);
    if (a.access.lvalue)
        a.where = location_of(j->an->facts, a.access.lvalue, j->loop);
    if (!a.where.type || a.access.callee)
        a.where.type = a.access.type;
    return a;
}

access_result check_accesses(const loop_analysis *j) {
    access_result result = {.why = check_lower(j)};
    if (result.why.id == REASON_NONE)
        result.why = check_bound(j);
    if (result.why.id != REASON_NONE)
        return result;
    access_collect(j->an->effects, j->counted.bound, &result.found);
    access_collect(j->an->effects, j->counted.body, &result.found);
    result.why = check_all(j, &result.found);
    if (result.why.id != REASON_NONE)
        return result;
    result.count = result.found.items.count;
    result.accesses = ARENA_ARRAY(j->an->memory, loop_access, result.count + 1);
    for (unsigned i = 0; i < result.count; i++)
        result.accesses[i] = access_in_loop(j, &result.found.items.items[i]);
    result.why = check_counter(j, &result);
    return result;
}
