/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/foreign.h"

#include <string.h>

/* ---- from file to file ---------------------------------------------------------------------- */

void foreign_write(buffer *out, const exported_functions *functions) {
    for (unsigned i = 0; i < functions->count; i++)
        buffer_format(out, "%u %s\n", (unsigned)functions->items[i].kind, functions->items[i].name);
}

void foreign_read(arena *a, foreign_functions *all, const char *file, const char *text) {
    if (!all->by_name)
        all->by_name = map_new(a);
    while (text[0] && text[1] == ' ') {
        const exported_kind kind = (exported_kind)(text[0] - '0');
        const char *name = text + 2;
        const size_t length = strcspn(name, "\n");
        foreign_function **known = (foreign_function **)map_at(all->by_name, name, length);
        if (!*known)
            *known = ARENA_NEW(a, foreign_function);
        (*known)->kind = kind;
        (*known)->file = file;
        (*known)->definitions++;
        text = name + length + (name[length] == '\n');
    }
}

/* ---- in a file ------------------------------------------------------------------------------ */

/* NULL: nothing that may be used. */
static const foreign_function *find(const foreign_functions *all, const ir_function *function) {
    if (!all->by_name || function->body || function->is_static)
        return NULL;
    const foreign_function *known = map_get(all->by_name, function->name, strlen(function->name));
    return known && known->definitions == 1 && known->kind != EXPORTED_NOTHING ? known : NULL;
}

/* Whatever its declaration here says of attributes, an asm label may make it another function. */
static const foreign_function *find_usable(const foreign_functions *all,
                                           const ir_function *function) {
    return function->has_other_attributes || function->is_renamed ? NULL : find(all, function);
}

const analysis_options *foreign_apply(arena *a, const foreign_functions *all, ir_unit *unit,
                                      const analysis_options *options) {
    VECTOR(const char *) pure = {0};
    for (unsigned i = 0; i < options->pure_count; i++)
        VECTOR_PUSH(a, &pure, options->pure[i]);
    for (unsigned i = 0; i < unit->function_count; i++) {
        ir_function *function = unit->functions[i];
        const foreign_function *known = find_usable(all, function);
        if (!known)
            continue;
        function->is_same_in_threads = true;
        if (known->kind == EXPORTED_CONST)
            function->is_attribute_const = true;
        else if (known->kind == EXPORTED_PURE)
            function->is_attribute_pure = true;
        else
            VECTOR_PUSH(a, &pure, function->name);
    }
    analysis_options *result = ARENA_NEW(a, analysis_options);
    *result = *options;
    result->pure_count = pure.count;
    result->pure = pure.items;
    return result;
}

/* ---- what a verdict rests on ---------------------------------------------------------------- */

typedef struct call_search {
    arena *memory;
    const foreign_functions *all;
    bool *is_visited; /* [function_count] */
    ir_range place;   /* of the call in the loop that leads to those in callees */
    VECTOR(foreign_call) found;
} call_search;

static bool visit(ir_node *node, void *context) {
    call_search *search = context;
    if (node->kind != IR_FUNCTION)
        return true;
    const ir_function *function = node->function;
    if (search->is_visited[function->id])
        return true;
    search->is_visited[function->id] = true;
    const ir_range before = search->place;
    if (before.begin == before.end)
        search->place = node->range;
    const foreign_function *known = find_usable(search->all, function);
    if (known) {
        const foreign_call call = {function->name, known->file, exported_word(known->kind),
                                   search->place};
        VECTOR_PUSH(search->memory, &search->found, call);
    }
    if (function->body)
        ir_walk(function->body, visit, search);
    search->place = before;
    return true;
}

void foreign_note(arena *a, const foreign_functions *all, const ir_unit *unit,
                  const analysis_result *analysis, loop_verdict *verdicts) {
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        if (verdicts[i].kind != VERDICT_TRANSFORM)
            continue;
        call_search search = {
            .memory = a, .all = all, .is_visited = ARENA_ARRAY(a, bool, unit->function_count + 1)};
        ir_walk((ir_node *)verdicts[i].loop, visit, &search);
        verdicts[i].foreign = search.found.items;
        verdicts[i].foreign_count = search.found.count;
    }
}
