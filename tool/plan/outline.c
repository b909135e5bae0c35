/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/outline.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/loop_text.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"
#include "plan/macros.h"
#include "plan/place.h"
#include "plan/stand_in.h"

enum { MOST_ARRAYS = 6 /* as many as the macros of loop.h allow */ };

/* ---- the place, and the function's name ---------------------------------------------------- */

/** Does a directive in bytes [begin, end) change the meaning of a copy? Conditional directives do
 *  not, because the copy contains only the branches that are compiled (as_compiled.h). */
static bool changes_copies(const ir_unit *unit, uint32_t begin, uint32_t end) {
    assert(begin <= end);
    for (unsigned i = loop_text_first_directive(unit, begin);
         i < unit->directive_count && unit->directives[i].range.begin < end; i++) {
        const ir_directive *d = &unit->directives[i];
        const bool is_pragma =
            d->kind == IR_DIRECTIVE_PRAGMA && (is_pragma_of(d, "redcc") || is_pragma_of(d, "omp"));
        if (!directive_can_be_left_out(unit, d) && !is_pragma)
            return true;
    }
    return false;
}

static bool has_place(const loop_plan *plan) {
    const source *file = plan->unit->source;
    const ir_function *function = plan->facts->function;
    return function->range.begin <= plan->facts->loop->range.begin &&
           has_place_in_front(plan->unit, function) &&
           !changes_copies(plan->unit, function->range.begin,
                           syntax_statement_end(file, plan->facts->loop));
}

static const char *const words_for_name[] = {"__func__", "__FUNCTION__", "__PRETTY_FUNCTION__"};

/** May a macro of the file use __func__, the name of the enclosing function? */
static bool may_macro_name_function(const loop_plan *plan) {
    for (unsigned i = 0; has_macro(plan) && i < plan->unit->directive_count; i++) {
        const char *text = plan->unit->directives[i].text;
        for (size_t k = 0; text && k < sizeof words_for_name / sizeof *words_for_name; k++)
            if (strstr(text, words_for_name[k]))
                return true;
    }
    return false;
}

static unsigned count_names(const loop_plan *plan, const ir_node *node) {
    unsigned count = says_function_name(plan, node) && !(node->flags & IR_FROM_MACRO);
    for (unsigned i = 0; i < node->child_count; i++)
        count += count_names(plan, node->children[i]);
    return count;
}

/** May the body use __func__ in a part that the tree does not contain, such as a sizeof? */
static bool may_name_function(const loop_plan *plan) {
    const ir_node *body = plan->facts->counted.body;
    const char *text = plan->unit->source->text;
    unsigned count = 0;
    for (uint32_t at = body->range.begin; at < body->range.end; at++)
        for (size_t k = 0; k < sizeof words_for_name / sizeof *words_for_name; k++)
            count += source_starts_with(text + at, words_for_name[k]);
    return may_macro_name_function(plan) || count != count_names(plan, body);
}

bool says_function_name(const loop_plan *plan, const ir_node *node) {
    const char *name = plan->facts->function->name;
    const size_t length = strlen(name);
    if (node->kind != IR_STRING)
        return false;
    if (!(node->flags & IR_FROM_MACRO))
        assert(node->range.begin < plan->unit->source->length);
    return plan->unit->source->text[node->range.begin] == '_';
    return node->text && strlen(node->text) == length + 2 &&
           strncmp(node->text + 1, name, length) == 0;
}

static bool is_of_file(const ir_variable *variable) {
    return variable->storage == IR_GLOBAL || variable->storage == IR_STATIC;
}

/** Is the variable declared in the function's body, and not as a parameter? */
static bool is_of_function(const loop_facts *facts, const ir_variable *variable) {
    const ir_range body = facts->function->body->range;
    return variable->range.begin < variable->range.end && variable->range.begin >= body.begin &&
           variable->range.begin < body.end;
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

/** Can the variable be passed by value? Arrays are passed as a pointer. */
static bool can_be_passed(const loop_plan *plan, const ir_variable *variable) {
    const ir_type *type = variable->type;
    if (type->is_volatile || type->is_atomic)
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

/* ---- by address ---------------------------------------------------------------------------- */

/** Can the variable be passed by its address? Its names in the tree are replaced. A name that the
 *  tree does not contain would be undeclared in the written text, which the self-check rejects. */
static bool can_be_pointed_to(const ir_variable *variable) {
    const ir_type *type = variable->type;
    return type->spelling && type->size > 0 && type->kind != IR_OTHER_TYPE && !type->is_volatile &&
           !type->is_atomic;
}

static bool is_declared_in_body(const loop_facts *facts, const ir_variable *variable) {
    const ir_range body = facts->counted.body->range;
    return variable->range.begin < variable->range.end && variable->range.begin >= body.begin &&
           variable->range.begin < body.end;
}

passing passing_of(const loop_plan *plan, const ir_variable *variable, bool of_body) {
    assert(!of_body || plan->is_shadowed);
    const loop_facts *facts = plan->facts;
    if (variable == facts->counted.counter || is_declared_in(facts, variable) ||
        is_declared_in_body(facts, variable) || is_stand_in(plan, variable, of_body))
        return NOT_PASSED;
    const bool names_object = is_of_file(variable) && !is_of_function(facts, variable) &&
                              variable->type->kind == IR_ARRAY;
    if (can_be_passed(plan, variable))
        return names_object ? NOT_PASSED : PASSED_BY_VALUE;
    if (is_of_file(variable) && !is_of_function(facts, variable))
        return NOT_PASSED;
    return can_be_pointed_to(variable) ? PASSED_BY_ADDRESS : CANNOT_BE_PASSED;
}

const char *plan_outline(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    if (facts->array_count > MOST_ARRAYS)
        return "it updates too many arrays";
    const char *macro = macro_of_header_words(plan->arena, plan->unit);
    if (macro)
        return arena_format(plan->arena, "the macro '%s' would change the text that is written",
                            macro);
    if (!has_place(plan))
        return "there is a directive between the function's beginning and the loop's end, or "
               "text inserted before the function would be part of another construct";
    if (may_name_function(plan))
        return "its body may use the name of its function";
    return NULL;
}
