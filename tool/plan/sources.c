/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/sources.h"

#include <assert.h>

#include "analysis/loop/executed.h"
#include "ir/ir_syntax.h"

/** Does the runtime need only one of two sources? It does if they have the same base, in case their
 * rows are recorded, and otherwise if they have the same range. */
static bool move_together(const loop_source *left, const loop_source *right) {
    if (left->extent != right->extent)
        return false;
    if (left->extent == EXTENT_TOUCHED)
        return left->base && right->base && syntax_same(left->base, right->base);
    return syntax_same(left->row, right->row) && source_ends_equal(left, right) &&
           left->bounds == right->bounds;
}

void plan_sources(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    logged_source *sources = ARENA_ARRAY(plan->arena, logged_source, facts->source_count + 1);
    int *numbers = ARENA_ARRAY(plan->arena, int, facts->source_count + 1);
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *fact = &facts->sources[i];
        assert(fact->is_subscript || fact->needs_guard);
        numbers[i] = SOURCE_NOT_LOGGED;
        if (!fact->needs_guard && !fact->is_subscript)
            continue;
        unsigned number = 0;
        while (number < plan->source_count && !move_together(sources[number].fact, fact))
            number++;
        if (number == plan->source_count)
            sources[plan->source_count++] = (logged_source){.fact = fact};
        sources[number].is_subscript |= fact->is_subscript;
        sources[number].is_scalar |= fact->is_scalar;
        sources[number].meets_scalars |= fact->meets_scalars;
        sources[number].meets_arrays |= fact->meets_arrays;
        numbers[i] = (int)number;
    }
    assert(plan->source_count <= facts->source_count);
    plan->sources = sources;
    plan->source_number = numbers;
}
