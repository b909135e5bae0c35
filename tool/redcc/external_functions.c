/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/external_functions.h"

#include <string.h>

#include "analysis/base/external.h"

/* ---- from file to file ---------------------------------------------------------------------- */

void external_write(buffer *out, const exported_functions *functions) {
    for (unsigned i = 0; i < functions->count; i++)
        buffer_format(out, "%u %s\n", (unsigned)functions->items[i].kind, functions->items[i].name);
}

void external_read(arena *a, external_functions *all, const char *file, const char *text) {
    if (!all->by_name)
        all->by_name = map_new(a);
    while (text[0] && text[1] == ' ') {
        const exported_kind kind = (exported_kind)(text[0] - '0');
        const char *name = text + 2;
        const size_t length = strcspn(name, "\n");
        external_function **known = (external_function **)map_at(all->by_name, name, length);
        if (!*known) {
            *known = ARENA_NEW(a, external_function);
            VECTOR_PUSH(a, &all->names, arena_copy(a, name, length));
        }
        (*known)->kind = kind;
        (*known)->file = file;
        (*known)->definitions++;
        text = name + length + (name[length] == '\n');
    }
}

/* ---- in a file ------------------------------------------------------------------------------ */

const map *external_known(arena *a, const external_functions *all) {
    map *known = map_new(a);
    for (unsigned i = 0; i < all->names.count; i++) {
        const char *name = all->names.items[i];
        external_function *function = map_get(all->by_name, name, strlen(name));
        if (function->definitions == 1 && function->kind != EXPORTED_NOTHING)
            *map_at(known, name, strlen(name)) = &function->kind;
    }
    return known;
}

/* ---- facts on which a verdict depends -------------------------------------------------------- */

typedef struct call_search {
    arena *memory;
    const external_functions *all;
    const analysis_options *options;
    bool *is_visited; /* [function_count] */
    ir_range place;   /* the call in the loop that leads to the function, perhaps through other
                       * functions */
    VECTOR(external_call) found;
} call_search;

/* Does the user assert that the function is pure (--pure)? Then no other file is needed. */
static bool is_given(const analysis_options *options, const ir_function *function) {
    for (unsigned i = 0; i < options->pure_count; i++)
        if (strcmp(options->pure[i], function->name) == 0)
            return true;
    return false;
}

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
    if (external_kind(search->options, function) != EXPORTED_NOTHING &&
        !is_given(search->options, function)) {
        const external_function *known =
            map_get(search->all->by_name, function->name, strlen(function->name));
        const external_call call = {function->name, known->file, exported_word(known->kind),
                                    search->place};
        VECTOR_PUSH(search->memory, &search->found, call);
    }
    if (function->body)
        ir_walk(function->body, visit, search);
    search->place = before;
    return true;
}

void external_note(arena *a, const external_functions *all, const analysis_options *options,
                   const ir_unit *unit, const analysis_result *analysis, loop_verdict *verdicts) {
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        if (verdicts[i].kind != VERDICT_TRANSFORM)
            continue;
        call_search search = {.memory = a,
                              .all = all,
                              .options = options,
                              .is_visited = ARENA_ARRAY(a, bool, unit->function_count + 1)};
        ir_walk((ir_node *)verdicts[i].loop, visit, &search);
        verdicts[i].external_calls = search.found.items;
        verdicts[i].external_call_count = search.found.count;
    }
}
