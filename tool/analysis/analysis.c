/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Analyses all loops of a unit, taking the user's pragmas into account. */
#include "analysis/analysis.h"

#include <string.h>

#include "analysis/invariants.h"
#include "analysis/nest.h"
#include "ir/ir_position.h"

typedef struct pragma_use {
    const user_pragma *pragma;
    bool is_found;
} pragma_use;

static bool find_pure_call(ir_node *node, void *context) {
    pragma_use *use = context;
    use->is_found |= node->kind == IR_FUNCTION && pragma_names(use->pragma, node->function->name);
    return !use->is_found;
}

static bool concerns(const user_pragma *pragma, const ir_node *loop) {
    if (pragma->word != PRAGMA_PURE)
        return pragma->loop == loop;
    pragma_use use = {.pragma = pragma};
    ir_walk((ir_node *)loop, find_pure_call, &use);
    return use.is_found;
}

static void note_pragmas(const analyser *an, loop_verdict *verdict) {
    VECTOR(user_pragma) found = {0};
    for (unsigned i = 0; i < an->pragmas->count; i++)
        if (concerns(&an->pragmas->items[i], verdict->loop))
            VECTOR_PUSH(an->memory, &found, an->pragmas->items[i]);
    verdict->pragmas = found.items;
    verdict->pragma_count = found.count;
}

/* The options, with the functions added that pragmas declare pure. */
static const analysis_options *with_pragmas(arena *a, const analysis_options *options,
                                            const user_pragmas *pragmas) {
    VECTOR(const char *) pure = {0};
    for (unsigned i = 0; i < options->pure_count; i++)
        VECTOR_PUSH(a, &pure, options->pure[i]);
    for (unsigned i = 0; i < pragmas->count; i++)
        for (unsigned k = 0; k < pragmas->items[i].name_count; k++)
            if (pragmas->items[i].word == PRAGMA_PURE)
                VECTOR_PUSH(a, &pure, pragmas->items[i].names[k]);
    analysis_options *all = ARENA_NEW(a, analysis_options);
    *all = *options;
    all->pure_count = pure.count;
    all->pure = pure.items;
    return all;
}

/* Is the function an unused static one that #line places in another file? The compiler generates no
 * code for it. */
static bool is_unused_of_header(const ir_unit *unit, const ir_function *function) {
    const source *s = unit->source;
    const ir_range range = function->range;
    if (!s || !function->linkage.is_static || function->reference_count > 0 ||
        range.begin >= range.end || strcmp(ir_position_of(unit, range.begin).file, s->path) == 0)
        return false;
    return !source_has_name(s->text, range.begin, function->name) &&
           !source_has_name(s->text + range.end, s->length - range.end, function->name);
}

/* Is the function's body in the main file, or in one of the program's own headers? False if another
 * file defines it, or is_unused_of_header holds. */
static bool is_of_program(const ir_unit *unit, const ir_function *function) {
    if (!function->body)
        return false;
    return function->is_in_main_file ? !is_unused_of_header(unit, function)
                                     : !function->is_from_system && !function->linkage.import;
}

analysis_result analyse_listing(arena *a, const ir_unit *unit, const analysis_options *given,
                                updating_calls *calls) {
    static const analysis_options no_options;
    const user_pragmas pragmas = pragmas_of_unit(a, unit);
    const analysis_options *options = with_pragmas(a, given ? given : &no_options, &pragmas);
    must_write *prover = must_write_new(a, unit, options);
    variable_facts *facts = variable_facts_new(a, unit, prover);
    analyser an = {.memory = a,
                   .unit = unit,
                   .options = options,
                   .prover = prover,
                   .facts = facts,
                   .effects = effects_new(a, unit, options, facts),
                   .rules = {.facts = facts,
                             .strict_aliasing = unit->dialect.strict_aliasing,
                             .assume_noalias = options->assume_noalias},
                   .text = unit_text_new(a, unit),
                   .pragmas = &pragmas};
    loop_search loops = {.an = &an, .calls = calls};
    for (unsigned i = 0; i < unit->function_count; i++)
        if (is_of_program(unit, unit->functions[i]))
            check_loops(&loops, unit->functions[i]);
    for (unsigned i = 0; i < loops.verdicts.count; i++)
        note_pragmas(&an, &loops.verdicts.items[i]);
    const analysis_result result = {loops.verdicts.count, loops.verdicts.items};
    analysis_assert_result(unit, &result);
    return result;
}

analysis_result analyse(arena *a, const ir_unit *unit, const analysis_options *options) {
    return analyse_listing(a, unit, options, NULL);
}
