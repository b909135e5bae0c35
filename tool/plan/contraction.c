/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Prevents compilers from contracting a multiplication and an addition into an operation with one
 * rounding. Unless any order is permitted, the serial and the parallel form of a loop must give the
 * same bits, so neither may be contracted. An inspector must not compute other subscripts than its
 * executor, either.
 *
 * Usually contraction is forbidden in the functions that contain loops and in the generated text.
 * It is forbidden in the whole file if a loop calls a function of the file with a contractible
 * expression: gcc may inline the callee into one form of the loop, and call it, contracted, in
 * another. The same holds if a function cannot get the attribute that forbids contraction
 * (may_have_attribute), if a loop has lanes, if the file may select another processor
 * (`target`), or if a macro changes the pragma.
 */
#include "plan/contraction.h"

#include <assert.h>
#include <string.h>

#include "plan/place.h"

/** Floating-point operations of a loop or of functions that it calls, directly or indirectly. */
typedef struct reach {
    bool *is_seen; /* indexed by function */
    bool multiplies, adds;
} reach;

static bool is_arithmetic_of_other_kind(const ir_type *type) {
    return !type || type->kind == IR_FLOATING || type->kind == IR_COMPLEX ||
           type->kind == IR_OTHER_TYPE;
}

static void note_operation(reach *r, const ir_node *node) {
    const ir_type *type = node->kind == IR_ASSIGN && node->child_count > 1 &&
                                  !is_arithmetic_of_other_kind(node->children[0]->type)
                              ? node->children[1]->type /* `i += x` is computed in the type of x */
                              : node->type;
    if (!is_arithmetic_of_other_kind(type))
        return;
    const bool is_complex = !type || type->kind != IR_FLOATING; /* a complex product adds as well */
    const bool is_product = node->op == IR_OP_MULTIPLY || (is_complex && node->op == IR_OP_DIVIDE);
    r->multiplies |= is_product;
    r->adds |= node->op == IR_OP_ADD || node->op == IR_OP_SUBTRACT || (is_product && is_complex) ||
               node->op >= IR_OP_PRE_INCREMENT;
}

static void collect_operations(reach *r, const ir_node *node);

static void follow_call(reach *r, const ir_node *call) {
    const ir_node *callee = call->children[0];
    if (callee->kind != IR_FUNCTION) { /* a pointer, perhaps to a function of this file */
        r->multiplies = r->adds = true;
    } else if (callee->function->body && !callee->function->linkage.import &&
               !r->is_seen[callee->function->id]) { /* functions of other files are compiled
                                                     * separately */
        r->is_seen[callee->function->id] = true;
        collect_operations(r, callee->function->body);
    }
}

static void collect_operations(reach *r, const ir_node *node) {
    if (node->kind == IR_OPAQUE)
        r->multiplies = r->adds = true;
    if (node->kind == IR_BINARY || node->kind == IR_ASSIGN || node->kind == IR_UNARY)
        note_operation(r, node);
    if (node->kind == IR_CALL)
        follow_call(r, node);
    for (unsigned i = 0; i < node->child_count; i++)
        collect_operations(r, node->children[i]);
}

/** Collects the operations of called functions only. Those of the loop do not matter here, because
 * contraction is forbidden in the loop itself. */
static void collect_calls(reach *r, const ir_node *node) {
    if (node->kind == IR_CALL)
        follow_call(r, node);
    for (unsigned i = 0; i < node->child_count; i++)
        collect_calls(r, node->children[i]);
}

static bool calls_what_contracts(arena *a, const ir_unit *unit, const loop_facts *facts) {
    reach r = {.is_seen = ARENA_ARRAY(a, bool, unit->function_count + 1)};
    collect_calls(&r, facts->loop);
    return r.multiplies && r.adds;
}

static bool may_be_contracted(arena *a, const ir_unit *unit, const loop_facts *facts) {
    reach r = {.is_seen = ARENA_ARRAY(a, bool, unit->function_count + 1)};
    collect_operations(&r, facts->loop);
    return r.multiplies || r.adds; /* the other half of a contraction may be outside of the loop */
}

/* ---- places -------------------------------------------------------------------------------- */

/** May the function get an attribute that forbids contraction? False if it is declared inline,
 * because gcc does not inline a function into another if only one of them may be contracted. Also
 * false if nothing can be inserted before it, or if it begins with a directive or with its name,
 * before which C allows no attribute. */
static bool may_have_attribute(const ir_unit *unit, const ir_function *function) {
    const uint32_t begin = function->range.begin;
    assert(function->body);
    return has_place_in_front(unit, function) &&
           !holds_word(unit->source, begin, function->body->range.begin, "inline") &&
           !source_starts_with(unit->source->text + begin, function->name) &&
           !has_directive(unit, begin, function->body->range.begin, false);
}

bool may_name_targets(const ir_unit *unit) {
    bool is_found = unit->text.names_target ||
                    holds_word(unit->source, 0, (uint32_t)unit->source->length, "target");
    for (unsigned i = 0; i < unit->text.header_pragma_count; i++)
        is_found |= strstr(unit->text.header_pragmas[i], "target") != NULL;
    return is_found;
}

static bool has_macro_of_pragma(const ir_unit *unit) {
    static const char *const words[] = {"clang", "fp", "contract", "off"};
    for (size_t i = 0; unit->text.macros && i < sizeof words / sizeof *words; i++)
        if (map_get(unit->text.macros, words[i], strlen(words[i])))
            return true;
    return false;
}

contraction contraction_of(arena *a, const ir_unit *unit, const analysis_result *analysis,
                           const plan_options *options, bool has_lanes, bool *is_forbidden) {
    bool matters = false;
    bool is_local = !has_lanes && !may_name_targets(unit) && !has_macro_of_pragma(unit);
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        const loop_facts *facts = analysis->verdicts[i].facts;
        if (analysis->verdicts[i].kind != VERDICT_TRANSFORM || !may_be_contracted(a, unit, facts))
            continue;
        is_forbidden[i] = true;
        matters |= options->order != ORDER_ANY || facts->slice.has_floating_work;
        is_local = is_local && !calls_what_contracts(a, unit, facts) &&
                   may_have_attribute(unit, facts->function);
    }
    if (matters && is_local)
        return CONTRACTION_OFF_IN_LOOPS;
    memset(is_forbidden, 0, sizeof *is_forbidden * analysis->verdict_count);
    return matters ? CONTRACTION_OFF_IN_FILE : CONTRACTION_ALLOWED;
}
