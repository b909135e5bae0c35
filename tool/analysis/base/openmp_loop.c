/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reads the directives. Once the loop is analysed, reduction/protection.c compares them with it. */
#include "analysis/base/openmp_loop.h"

#include <string.h>

#include "analysis/base/loop_text.h"
#include "analysis/base/openmp_nest.h"
#include "analysis/base/stateful.h"

/* ---- the directives ------------------------------------------------------------------------ */

static bool is_compiled(const ir_directive *d) {
    return !d->is_skipped && d->kind == IR_DIRECTIVE_PRAGMA && directive_is_openmp(d);
}

static bool has_devices(const ir_unit *unit) {
    for (unsigned i = 0; i < unit->directive_count; i++)
        if (is_compiled(&unit->directives[i]) && strstr(unit->directives[i].text, "target"))
            return true;
    for (unsigned i = 0; i < unit->text.header_pragma_count; i++)
        if (strstr(unit->text.header_pragmas[i], "target"))
            return true;
    return false;
}

openmp_kept openmp_kept_for_devices(const ir_unit *unit) {
    static const openmp_kept kept = {"code for devices in the file",
                                     "move the code with 'omp target' or 'declare target' to "
                                     "another file, or compile without -fopenmp"};
    return has_devices(unit) ? kept : (openmp_kept){0};
}

static openmp_kept with_text(arena *a, const char *what, const ir_directive *d) {
    return (openmp_kept){.text =
                             arena_format(a, "%s, in '%s'", what, openmp_plain_text(a, d->text))};
}

/* A clause whose effect exists only with its directive, as text; NULL if there is none. */
static const char *only_by_directive(arena *a, const openmp_directive *read) {
    for (unsigned i = 0; i < read->item_count; i++) {
        const openmp_item *item = &read->items[i];
        if (item->kind == OPENMP_OTHER_CLAUSE)
            return arena_format(a, "the clause '%s'", item->text);
        if (item->kind == OPENMP_OF_REGION)
            return arena_format(a, "the clause '%s(%s)'", item->word, item->text);
        if (item->kind == OPENMP_REDUCTION && item->op == REDUCTION_NONE)
            return "a reduction by another operator, or with a modifier";
    }
    return NULL;
}

static void note_above(arena *a, openmp_loop *result, const openmp_directive *read,
                       const ir_directive *d) {
    if (read->construct > OPENMP_FOR)
        result->kept = with_text(a, "the construct, which is no 'parallel for' or 'for'", d);
    result->is_of_team = read->construct == OPENMP_FOR;
    result->items = read->items;
    result->item_count = read->item_count;
}

/* The name of a function of OpenMP's library that the loop uses; NULL if there is none. */
static const char *openmp_function_in(const ir_node *node) {
    if (node->kind == IR_FUNCTION && strncmp(node->function->name, "omp_", 4) == 0)
        return node->function->name;
    const char *found = NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = openmp_function_in(node->children[i]);
    return found;
}

static bool is_thread_number(const ir_node *node) {
    return node->kind == IR_FUNCTION && strcmp(node->function->name, "omp_get_thread_num") == 0;
}

bool openmp_knows_thread(const openmp_directive *d, const ir_node *node) {
    return openmp_schedule_of(d) == OPENMP_STATIC && ir_any(node, is_thread_number);
}

/* Why a loop that contains locks but has no directive above it must keep its directives. */
static const char *kept_around(arena *a, const ir_unit *unit, const ir_node *loop) {
    for (const ir_node *outer = loop->parent; outer; outer = outer->parent) {
        const openmp_loop *around = ir_is_loop(outer) ? openmp_of_loop(a, unit, outer) : NULL;
        if (around)
            return around->kept.text ? around->kept.text : "the loop around it stays as it is";
    }
    return "a lock in a loop without a directive of its own";
}

const openmp_loop *openmp_of_loop(arena *a, const ir_unit *unit, const ir_node *loop) {
    if (!unit->dialect.has_openmp || !unit->source)
        return NULL;
    openmp_loop *result = ARENA_NEW(a, openmp_loop);
    unsigned above = 0, all = 0;
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, loop));
         i < unit->directive_count && unit->directives[i].range.begin < loop->range.end; i++) {
        const ir_directive *d = &unit->directives[i];
        if (!is_compiled(d))
            continue;
        all++;
        const bool is_above = d->range.end <= loop->range.begin;
        above += is_above;
        if (!directive_is_openmp_pragma(d)) {
            result->kept = with_text(a, "a directive that is not written as one", d);
            return result;
        }
        const openmp_directive read =
            is_above ? openmp_read_above(a, unit, d, loop) : openmp_read(a, unit, d);
        const char *kept = read.kept ? read.kept : only_by_directive(a, &read);
        if (is_above)
            note_above(a, result, &read, d);
        else if (read.construct <= OPENMP_PARALLEL)
            result->kept = with_text(a, "a region in the loop", d);
        result->has_locks |= !is_above;
        result->has_critical |= !is_above && read.construct != OPENMP_ATOMIC;
        if (kept)
            result->kept = with_text(a, kept, d);
        if (result->kept.text)
            return result;
    }
    if (all == 0)
        return NULL;
    const char *function = openmp_function_in(loop);
    if (above == 0)
        result->kept.text = kept_around(a, unit, loop);
    else if (above > 1)
        result->kept.text = "several directives above the loop";
    else if (function)
        result->kept = (openmp_kept){
            arena_format(a, "the loop asks %s", function),
            stateful_is_lock(function) ? "write #pragma omp critical in place of the lock" : NULL};
    else
        result->kept = openmp_kept_for_devices(unit);
    return result;
}

/* ---- variables ----------------------------------------------------------------------------- */

static const ir_variable *declared_by(const ir_node *declaration, const char *name) {
    for (unsigned i = 0; declaration->kind == IR_DECLARATION && i < declaration->child_count; i++) {
        const ir_variable *variable = declaration->children[i]->variable;
        if (variable && strcmp(variable->name, name) == 0)
            return variable;
    }
    return NULL;
}

const ir_variable *openmp_variable(const ir_unit *unit, const ir_node *loop,
                                   const ir_function *function, const char *name) {
    for (const ir_node *inner = loop; inner->parent; inner = inner->parent) {
        const ir_node *outer = inner->parent;
        const bool is_scope = outer->kind == IR_BLOCK || outer->kind == IR_FOR;
        for (unsigned i = outer->child_count; is_scope && i-- > 0;)
            if (outer->children[i]->id < inner->id && declared_by(outer->children[i], name))
                return declared_by(outer->children[i], name);
    }
    for (unsigned i = 0; i < function->parameter_count; i++)
        if (strcmp(function->parameters[i]->name, name) == 0)
            return function->parameters[i];
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (!unit->variables[i]->function && strcmp(unit->variables[i]->name, name) == 0)
            return unit->variables[i];
    return NULL;
}

bool openmp_keeps_value(const ir_unit *unit, const openmp_loop *above, const ir_node *loop,
                        const ir_variable *variable) {
    if (!unit->dialect.replaces_openmp || !above || above->kept.text)
        return false;
    bool keeps = openmp_counter(loop) == variable;
    for (unsigned i = 0; i < above->item_count; i++) {
        const openmp_item *item = &above->items[i];
        if (item->kind > OPENMP_LASTPRIVATE ||
            openmp_variable(unit, loop, variable->function, item->text) != variable)
            continue;
        if (item->kind == OPENMP_LASTPRIVATE)
            return false;
        keeps = true;
    }
    return keeps;
}
