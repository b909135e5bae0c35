/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Collects the pragmas of a unit, and finds the loops that follow them. */
#include <assert.h>
#include <string.h>

#include "analysis/base/pragma.h"

typedef struct collection {
    arena *memory;
    const ir_unit *unit;
    VECTOR(user_pragma) pragmas;
    VECTOR(pragma_problem) problems;
} collection;

static void add_problem(collection *c, uint32_t offset, const char *message) {
    const pragma_problem problem = {offset, message};
    VECTOR_PUSH(c->memory, &c->problems, problem);
}

static void read_all(collection *c) {
    for (unsigned i = 0; i < c->unit->directive_count; i++) {
        const ir_directive *d = &c->unit->directives[i];
        if (d->kind != IR_DIRECTIVE_PRAGMA || d->is_skipped || !d->text)
            continue;
        user_pragma pragma;
        uint32_t offset = 0;
        const char *problem = pragma_parse(c->memory, d->text, &pragma, &offset);
        if (problem)
            add_problem(c, d->range.begin + offset, problem);
        if (problem || pragma.word == PRAGMA_OTHER)
            continue;
        pragma.range = d->range;
        VECTOR_PUSH(c->memory, &c->pragmas, pragma);
    }
}

/* ---- the loop of a pragma ------------------------------------------------------------------ */

/* Assigns the loop to the pragmas above it that only other pragmas separate from it. */
static void bind_loop(collection *c, const ir_node *loop) {
    uint32_t to = loop->range.begin;
    unsigned k = c->unit->directive_count;
    while (k > 0 && c->unit->directives[k - 1].range.end > to)
        k--;
    for (; k > 0; k--) {
        const ir_directive *d = &c->unit->directives[k - 1];
        if (d->kind != IR_DIRECTIVE_PRAGMA ||
            source_skip_blanks(c->unit->source, d->range.end, to) < to)
            return;
        for (unsigned i = 0; i < c->pragmas.count; i++)
            if (c->pragmas.items[i].range.begin == d->range.begin)
                c->pragmas.items[i].loop = loop;
        to = d->range.begin;
    }
}

static bool visit(ir_node *node, void *context) {
    if (ir_is_loop(node) && node->range.begin < node->range.end)
        bind_loop(context, node);
    return true;
}

/* ---- names in pragmas ------------------------------------------------------------------------ */

typedef struct name_search {
    const char *name;
    bool is_found;
} name_search;

static bool find_name(ir_node *node, void *context) {
    name_search *search = context;
    const ir_variable *v = node->kind == IR_VARIABLE ? node->variable : NULL;
    search->is_found |= v && (v->storage == IR_LOCAL || v->storage == IR_PARAMETER) &&
                        strcmp(v->name, search->name) == 0;
    return !search->is_found;
}

static void check(collection *c, const user_pragma *pragma) {
    if (pragma->word == PRAGMA_PURE)
        return;
    if (!pragma->loop) {
        add_problem(c, pragma->range.begin,
                    arena_format(c->memory, "'redcc %s' is not above a loop", pragma->text));
        return;
    }
    for (unsigned i = 0; i < pragma->name_count; i++) {
        name_search search = {.name = pragma->names[i]};
        ir_walk((ir_node *)pragma->loop, find_name, &search);
        if (!search.is_found)
            add_problem(c, pragma->range.begin,
                        arena_format(c->memory, "'%s' is no local variable that the loop uses",
                                     search.name));
    }
}

user_pragmas pragmas_of_unit(arena *a, const ir_unit *unit) {
    collection c = {.memory = a, .unit = unit};
    read_all(&c);
    for (unsigned i = 0; i < unit->function_count && c.pragmas.count > 0; i++)
        if (unit->functions[i]->body && unit->functions[i]->is_in_main_file)
            ir_walk(unit->functions[i]->body, visit, &c);
    for (unsigned i = 0; i < c.pragmas.count; i++)
        check(&c, &c.pragmas.items[i]);
    return (user_pragmas){c.pragmas.count, c.pragmas.items, c.problems.count, c.problems.items};
}

const user_pragma *pragma_above(const user_pragmas *all, const ir_node *loop, pragma_word word) {
    assert(ir_is_loop(loop));
    for (unsigned i = 0; i < all->count; i++)
        if (all->items[i].loop == loop && all->items[i].word == word)
            return &all->items[i];
    return NULL;
}

bool pragma_names(const user_pragma *pragma, const char *name) {
    for (unsigned i = 0; pragma && i < pragma->name_count; i++)
        if (strcmp(pragma->names[i], name) == 0)
            return true;
    return false;
}
