/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/regular.h"

#include "analysis/base/loop_text.h"
#include "analysis/base/openmp_nest.h"
#include "analysis/loop/candidate.h"
#include "analysis/loop/conflict.h"

static ir_node *loop_around(const ir_node *node) {
    ir_node *outer = node->parent;
    while (outer && !ir_is_loop(outer))
        outer = outer->parent;
    return outer;
}

/* Does the loop change a variable by which the element is chosen? */
static bool is_chosen_in(const analyser *an, const ir_node *loop, const ir_node *target) {
    bool is_chosen =
        target->kind == IR_VARIABLE && variable_written_in(an->facts, loop, target->variable);
    for (unsigned i = 0; !is_chosen && i < target->child_count; i++)
        is_chosen = is_chosen_in(an, loop, target->children[i]);
    return is_chosen;
}

/* Two iterations that update one and the same element have no conflict by conflict.h either. */
static bool has_own_elements(const analyser *an, const ir_node *loop, const ir_node *target) {
    return conflict_of(an->facts, loop, target) == CONFLICT_NONE && !candidate_is_tiny(loop) &&
           is_chosen_in(an, loop, target);
}

/* The innermost loop around `loop` whose iterations have elements of their own. */
static ir_node *own_around(const analyser *an, const ir_node *loop, const ir_node *target) {
    ir_node *outer = loop_around(loop);
    while (outer && !has_own_elements(an, outer, target))
        outer = loop_around(outer);
    return outer;
}

/* The outermost loop inside `loop` whose iterations have elements of their own. */
static ir_node *own_inside(const analyser *an, const ir_node *loop, const ir_node *target) {
    ir_node *found = NULL;
    for (ir_node *inner = loop_around(target); inner && inner != loop; inner = loop_around(inner))
        if (has_own_elements(an, inner, target))
            found = inner;
    return found;
}

bool regular_is_parallel(const analyser *an, const ir_node *loop, const ir_node *target) {
    bool is_parallel = false;
    for (const ir_node *outer = own_around(an, loop, target); outer && !is_parallel;
         outer = own_around(an, outer, target))
        is_parallel = an->unit->dialect.has_openmp && loop_text_openmp_above(an->unit, outer);
    return is_parallel;
}

const char *regular_advice(const analyser *an, const ir_node *loop, const ir_node *target) {
    ir_node *outer = own_around(an, loop, target);
    if (outer)
        return arena_format(an->memory,
                            "each iteration of %s around it updates elements of its own: write "
                            "#pragma omp parallel for above that loop, with private() for the "
                            "variables it sets and reduction() for its sums",
                            analysis_loop_text(an, outer));
    ir_node *inner = own_inside(an, loop, target);
    if (!inner || openmp_inner_loop(loop) == inner)
        return NULL;
    return arena_format(an->memory,
                        "each iteration of %s inside it updates elements of its own: write #pragma "
                        "omp parallel for above that loop, with private() for the variables it "
                        "sets",
                        analysis_loop_text(an, inner));
}
