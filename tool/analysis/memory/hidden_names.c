/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/hidden_names.h"

#include <stdlib.h>
#include <string.h>

#include "analysis/base/expression.h"

struct hidden_names {
    const ir_unit *unit;
    const char **names; /* names of all functions' local variables, sorted */
    unsigned count;
};

static int compare_names(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

hidden_names *hidden_names_new(arena *a, const ir_unit *unit) {
    hidden_names *all = ARENA_NEW(a, hidden_names);
    all->unit = unit;
    all->names = ARENA_ARRAY(a, const char *, unit->variable_count + 1);
    for (unsigned i = 0; i < unit->variable_count; i++) {
        const ir_variable *variable = unit->variables[i];
        if (variable->name && !variable->is_unnamed &&
            (variable_is_automatic(variable) || variable->storage == IR_STATIC_LOCAL ||
             (variable->storage == IR_THREAD_LOCAL && variable->function)))
            all->names[all->count++] = variable->name;
    }
    qsort(all->names, all->count, sizeof all->names[0], compare_names);
    return all;
}

bool hidden_names_has(const hidden_names *names, const ir_variable *global) {
    if (names->unit->text.inner_names &&
        map_get(names->unit->text.inner_names, global->name, strlen(global->name)))
        return true;
    return bsearch(&global->name, names->names, names->count, sizeof names->names[0],
                   compare_names) != NULL;
}
