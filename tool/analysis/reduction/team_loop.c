/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/team_loop.h"

#include <string.h>

#include "analysis/base/expression.h"
#include "analysis/base/library.h"
#include "analysis/base/loop_text.h"

typedef struct team_loop {
    const analyser *an;
    const ir_function *function;
    const ir_node *loop;
    const openmp_directive *directive;
    const ir_variable *counter;
    const ir_node *region;  /* the statement under `parallel`; NULL if the region is in a
                             * caller */
    openmp_directive above; /* the `parallel` directive */
    bool is_outermost;
} team_loop;

/* ---- the region ---------------------------------------------------------------------------- */

/* The last compiled OpenMP directive directly above the statement; NULL if there is none. */
static const ir_directive *directive_above(const ir_unit *unit, const ir_node *statement) {
    const ir_directive *last = NULL;
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, statement));
         i < unit->directive_count && unit->directives[i].range.begin < statement->range.begin;
         i++) {
        const ir_directive *d = &unit->directives[i];
        if (!d->is_skipped && directive_is_openmp_pragma(d))
            last = d;
    }
    return last;
}

/* Finds the innermost `parallel` around the loop. Clears is_outermost if there is another directive
 * around that `parallel`. */
static void find_region(team_loop *it) {
    const ir_unit *unit = it->an->unit;
    for (const ir_node *node = it->loop->parent; node && node != it->function->body;
         node = node->parent) {
        const ir_directive *d = directive_above(unit, node);
        it->is_outermost &= !d || !it->region;
        if (!d || it->region || !strstr(d->text, "parallel"))
            continue;
        it->region = node;
        it->above = openmp_read(it->an->memory, unit, d);
    }
}

static bool is_in(ir_range inner, ir_range outer) {
    return inner.begin >= outer.begin && inner.end <= outer.end;
}

/* Does each thread have its own copy of the variable? */
static bool is_private(const team_loop *it, const ir_variable *variable) {
    if (variable->storage == IR_THREAD_LOCAL)
        return true;
    for (unsigned i = 0; i < it->above.item_count; i++)
        if ((it->above.items[i].kind <= OPENMP_LASTPRIVATE ||
             it->above.items[i].kind == OPENMP_REDUCTION) &&
            openmp_variable(it->an->unit, it->region, it->function, it->above.items[i].text) ==
                variable)
            return true;
    return variable_is_automatic(variable) &&
           (!it->region || is_in(variable->range, it->region->range));
}

/* ---- the guarantees of a static schedule ---------------------------------------------------- */

static const ir_variable *named_by(const team_loop *it, const openmp_item *item) {
    return openmp_variable(it->an->unit, it->loop, it->function, item->text);
}

/* Is the variable the loop's counter, named by a clause of the loop, or declared in the loop? */
static bool is_of_loop(const team_loop *it, const ir_variable *variable) {
    for (unsigned i = 0; i < it->directive->item_count; i++)
        if (it->directive->items[i].kind <= OPENMP_REDUCTION &&
            named_by(it, &it->directive->items[i]) == variable)
            return true;
    return variable == it->counter ||
           (variable->function == it->function && is_in(variable->range, it->loop->range));
}

/* A private variable in which a thread may keep a value from one loop to the next; NULL if there is
 * none. */
static const char *kept_by_thread(const team_loop *it, const ir_node *node) {
    if (node->kind == IR_VARIABLE && is_private(it, node->variable) &&
        !is_of_loop(it, node->variable))
        return node->variable->name;
    const char *found = NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = kept_by_thread(it, node->children[i]);
    return found;
}

/* Does the node, apart from the loop, name a function that may distribute iterations, or a
 * thread-local variable from which a thread may learn its number? */
static bool may_call_loops(const team_loop *it, const ir_node *node) {
    if (node == it->loop)
        return false;
    if (node->kind == IR_FUNCTION && strncmp(node->function->name, "omp_", 4) != 0 &&
        !library_find(it->an->unit, node->function))
        return true;
    if (node->kind == IR_VARIABLE && node->variable->storage == IR_THREAD_LOCAL)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (may_call_loops(it, node->children[i]))
            return true;
    return false;
}

/* Does a compiled directive of the region, other than the loop's own, contain the word, or may a
 * macro produce one that does? */
static bool region_has_word(const team_loop *it, const char *word) {
    const ir_unit *unit = it->an->unit;
    const ir_range region = it->region->range;
    const ir_range before = {region.begin, loop_text_begin(unit, it->loop)};
    const ir_range behind = {it->loop->range.begin, region.end};
    return directives_name(unit, before, word) || directives_name(unit, behind, word) ||
           text_pragma_macro(it->an->memory, unit, region);
}

/* Is this the only loop that the region's team shares? */
static bool is_alone(const team_loop *it) {
    return it->region && !may_call_loops(it, it->region) && !region_has_word(it, "for");
}

/* ---- the verdict --------------------------------------------------------------------------- */

/* Does the region share the function's variables even if no clause names them? */
static bool is_shared_by_default(const team_loop *it) {
    for (unsigned i = 0; i < it->above.item_count; i++)
        if (strcmp(it->above.items[i].word, "default") == 0 &&
            !strstr(it->above.items[i].text, "shared"))
            return false;
    return true;
}

static const char *reduced_by_region(const team_loop *it) {
    for (unsigned i = 0; i < it->above.item_count; i++) {
        const openmp_item *item = &it->above.items[i];
        const ir_variable *variable =
            item->kind == OPENMP_REDUCTION
                ? openmp_variable(it->an->unit, it->region, it->function, item->text)
                : NULL;
        if (variable && expression_mentions(it->loop, variable))
            return variable->name;
    }
    return NULL;
}

static team_facts facts_of(const team_loop *it) {
    const bool shares = is_shared_by_default(it);
    const bool takes_turns = openmp_schedule_of(it->directive) == OPENMP_BY_TURNS;
    return (team_facts){.shares_frame = it->region && it->is_outermost && shares,
                        .may_be_early =
                            !takes_turns && (!it->region || may_call_loops(it, it->region) ||
                                             region_has_word(it, "nowait")),
                        .names_all = !shares,
                        .reduced = reduced_by_region(it)};
}

const char *team_of_loop(const analyser *an, const ir_function *function, const ir_node *loop,
                         const openmp_directive *directive, const ir_variable *counter,
                         team_facts *facts) {
    team_loop it = {.an = an,
                    .function = function,
                    .loop = loop,
                    .directive = directive,
                    .counter = counter,
                    .is_outermost = true};
    find_region(&it);
    if (it.above.kept)
        return arena_format(an->memory, "its region has %s", it.above.kept);
    if (file_names(an->unit, "cancel")) /* threads that `cancel` ends do not reach the barriers */
        return "'cancel' in the file";
    for (unsigned i = 0; i < directive->item_count; i++) {
        const openmp_item *item = &directive->items[i];
        const ir_variable *variable = item->kind == OPENMP_REDUCTION ? named_by(&it, item) : NULL;
        /* a pointer to the reduced array may be private to each thread */
        if (variable && variable->type->kind != IR_POINTER && is_private(&it, variable))
            return arena_format(an->memory, "'%s' is not shared by the team", variable->name);
    }
    *facts = facts_of(&it);
    const char *own = openmp_schedule_of(directive) == OPENMP_STATIC && !is_alone(&it)
                          ? kept_by_thread(&it, loop)
                          : NULL;
    return own ? arena_format(an->memory,
                              "by 'schedule(static)' each thread may keep values of its "
                              "iterations in '%s' for another loop",
                              own)
               : NULL;
}
