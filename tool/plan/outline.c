/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/outline.h"

#include <string.h>

#include "ir/ir_syntax.h"
#include "plan/lookup.h"
#include "plan/macros.h"
#include "plan/place.h"
#include "plan/stand_in.h"

enum { MOST_ARRAYS = 6 /* of the macros of loop.h */ };

/* ---- the place, and the function's name ---------------------------------------------------- */

static bool has_place(const loop_plan *plan) {
    const source *file = plan->unit->source;
    const ir_function *function = plan->facts->function;
    return function->range.begin <= plan->facts->loop->range.begin &&
           has_place_in_front(plan->arena, plan->unit, function) &&
           !has_directive(plan->unit, function->range.begin,
                          syntax_statement_end(file, plan->facts->loop), false);
}

/** A string that a macro makes up may be the function's name. */
static bool has_string_of_macro(const ir_node *node) {
    if (node->kind == IR_STRING && node->flags & IR_FROM_MACRO)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_string_of_macro(node->children[i]))
            return true;
    return false;
}

/** May the body ask what function it stands in? The tree has the answer as a string. */
static bool may_name_function(const loop_plan *plan) {
    static const char *const words[] = {"__func__", "__FUNCTION__", "__PRETTY_FUNCTION__"};
    const ir_node *body = plan->facts->counted.body;
    const source *file = plan->unit->source;
    const bool anywhere = has_macro(plan);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (holds_word(file, anywhere ? 0 : body->range.begin,
                       anywhere ? (uint32_t)file->length : body->range.end, words[i]))
            return true;
    return has_string_of_macro(body);
}

static bool is_of_file(const ir_variable *variable) {
    return variable->storage == IR_GLOBAL || variable->storage == IR_STATIC;
}

static bool has_address_taken(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS &&
        node->children[0]->kind == IR_VARIABLE && node->children[0]->variable == variable)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_address_taken(node->children[i], variable))
            return true;
    return false;
}

/** Of an array a pointer is handed over. */
static bool can_be_handed(const loop_plan *plan, const ir_variable *variable) {
    const ir_type *type = variable->type;
    if (variable->storage == IR_THREAD_LOCAL || type->is_volatile || type->is_atomic)
        return false;
    if (type->kind == IR_ARRAY)
        return type->target->spelling && type->target->size > 0 && can_be_pointer(plan, variable) &&
               !has_address_taken(plan->facts->counted.body, variable);
    return is_captured(plan->facts, variable) && type->spelling && type->kind != IR_OTHER_TYPE &&
           is_copied_in(variable);
}

static bool is_stand_in(const loop_plan *plan, const ir_variable *variable, bool of_body) {
    for (unsigned i = 0; of_body && i < plan->facts->array_count; i++)
        if (plan->is_shadowed[i] && plan->facts->arrays[i].base->variable == variable)
            return true;
    return false;
}

static bool has_thread_local(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->variables.captured_count; i++)
        if (facts->variables.captured[i]->storage == IR_THREAD_LOCAL)
            return true;
    return false;
}

/* ---- both ---------------------------------------------------------------------------------- */

handing handing_of(const loop_plan *plan, const ir_variable *variable, bool of_body) {
    const loop_facts *facts = plan->facts;
    if (variable == facts->counted.counter || is_declared_in(facts, variable) ||
        is_stand_in(plan, variable, of_body))
        return NOT_HANDED;
    const bool names_object = is_of_file(variable) && variable->type->kind == IR_ARRAY;
    if (can_be_handed(plan, variable))
        return names_object ? NOT_HANDED : HANDED;
    return is_of_file(variable) ? NOT_HANDED : CANNOT_BE_HANDED;
}

const char *plan_outline(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    if (leaves_values(facts) || facts->counted.steps_inside)
        return "the loop leaves more than its updates of arrays";
    if (facts->array_count > MOST_ARRAYS)
        return "it updates too many arrays";
    if (has_thread_local(facts))
        return "it reads an object that each thread has for itself";
    if (has_macro_of_header_words(plan->arena, plan->unit))
        return "a macro of the program would change what the macros of loop.h say";
    if (!has_place(plan))
        return "a directive stands between the function's beginning and the loop's end, or "
               "something "
               "in front of the function would be part of something else";
    if (may_name_function(plan))
        return "its body may ask for the name of the function it stands in";
    return NULL;
}
