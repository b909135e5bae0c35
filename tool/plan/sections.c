/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/sections.h"

#include <assert.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/base/openmp_loop.h"
#include "plan/bins.h"
#include "plan/execution.h"
#include "support/buffer.h"

static const openmp_item *clause_of(const loop_plan *plan, const ir_variable *variable) {
    assert(plan->facts->variables.openmp);
    const openmp_loop *openmp = plan->facts->variables.openmp;
    for (unsigned i = 0; i < openmp->item_count; i++)
        if (openmp->items[i].kind == OPENMP_REDUCTION &&
            openmp_variable(plan->unit, plan->facts->loop, plan->facts->function,
                            openmp->items[i].text) == variable)
            return &openmp->items[i];
    return NULL;
}

static const ir_node *enumerator_in(const ir_node *node, const char *name) {
    const ir_node *found = node->kind == IR_NUMBER && node->flags & IR_HAS_VALUE && node->text &&
                                   strcmp(node->text, name) == 0
                               ? node
                               : NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = enumerator_in(node->children[i], name);
    return found;
}

/* Returns a use of the enumerator `name` in a function of the file. This node has the enumerator's
 * value. Returns NULL if no function uses such an enumerator, or if a function itself declares the
 * name as an enumerator, type or tag. */
static const ir_node *enumerator_of(const ir_unit *unit, const char *name) {
    const ir_node *found = NULL;
    if (unit->text.inner_names && map_get(unit->text.inner_names, name, strlen(name)))
        return NULL;
    for (unsigned i = 0; i < unit->function_count && !found; i++)
        if (unit->functions[i]->body)
            found = enumerator_in(unit->functions[i]->body, name);
    return found;
}

/* Returns the text for a name in the expression: an integer variable's name itself, or the value of
 * an enumerator. NULL if it is neither. */
static const char *value_of(const loop_plan *plan, const char *name) {
    const ir_variable *variable =
        openmp_variable(plan->unit, plan->facts->loop, plan->facts->function, name);
    if (variable)
        return variable->type->kind == IR_INTEGER && !variable->type->is_volatile &&
                       !variable->type->is_atomic
                   ? name
                   : NULL;
    const ir_node *constant = enumerator_of(plan->unit, name);
    return constant ? arena_format(plan->arena, "(%lld)", (long long)constant->value) : NULL;
}

/* Returns the expression with enumerators replaced by their values, if it consists of integer
 * variables, enumerators, numbers, + - * and parentheses. Otherwise returns NULL. Such an
 * expression can be evaluated before the loop, because it has no effect and does not trap. */
static const char *simple_expression(const loop_plan *plan, const char *text) {
    buffer out = {0};
    size_t length;
    bool is_simple = !strstr(text, "++") && !strstr(text, "--");
    for (const char *at = openmp_token(text, &length); is_simple && length > 0;
         at = openmp_token(at + length, &length)) {
        const char *const token = arena_copy(plan->arena, at, length);
        const bool is_plain = isdigit((unsigned char)*at) || strchr("+-*()", *at);
        const char *const written = is_plain                   ? token
                                    : openmp_is_name(text, at) ? value_of(plan, token)
                                                               : NULL;
        is_simple = written != NULL;
        buffer_format(&out, "%s%s", out.length ? " " : "", is_simple ? written : "");
    }
    const bool is_some = out.length > 0;
    const char *const result = buffer_take(plan->arena, &out);
    return is_simple && is_some ? result : NULL;
}

/* Do the brackets after the first pair, separated by "][", name whole rows of this type, such as
 * "0:3" for rows of 3 elements? */
static bool are_whole(const char *rest, const ir_type *row) {
    for (; rest; row = row->target) {
        assert(source_starts_with(rest, "]["));
        rest += strlen("][");
        if (!row || row->kind != IR_ARRAY || row->count < 1)
            return false;
        const char *const colon = strchr(rest, ':');
        const char *const next = strstr(rest, "][");
        char *end;
        if (!colon || (next && next < colon) || strspn(rest, " \t0") != (size_t)(colon - rest) ||
            strtoll(colon + 1, &end, 10) != row->count ||
            strspn(end, " \t") != (next ? (size_t)(next - end) : strlen(end)))
            return false;
        rest = next;
    }
    return !row || row->kind != IR_ARRAY; /* else brackets are missing */
}

/* Sets *it to the array's section in the clause. Returns false if the array has none, or the
 * clause's text does not show it. */
static bool find_section(const loop_plan *plan, const reduction_array *array, array_section *it) {
    const ir_node *base = array->base;
    const openmp_item *item =
        base && base->kind == IR_VARIABLE ? clause_of(plan, base->variable) : NULL;
    if (!item || array->is_scattered || array->order_is_kept)
        return false;
    const ir_type *type = base->variable->type;
    if (!item->section) {
        *it = (array_section){"0", arena_format(plan->arena, "%lld", (long long)type->count)};
        return type->kind == IR_ARRAY && type->count > 0;
    }
    const char *const rest = strstr(item->section, "][");
    const size_t first = rest ? (size_t)(rest - item->section) : strlen(item->section);
    const char *const text = arena_copy(plan->arena, item->section, first);
    const char *const colon = strchr(text, ':');
    if (!colon || (type->kind != IR_ARRAY && type->kind != IR_POINTER) ||
        !are_whole(rest, type->target))
        return false;
    const char *const lower = arena_copy(plan->arena, text, (size_t)(colon - text));
    it->lower = lower[strspn(lower, " \t")] ? simple_expression(plan, lower) : "0";
    it->length = simple_expression(plan, colon + 1);
    return it->lower && it->length;
}

static bool asks_sequential(const loop_plan *plan) {
    return plan->options->order_is_explicit && plan->options->order == ORDER_SERIAL;
}

const array_section *plan_sections(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const openmp_loop *openmp = facts->variables.openmp;
    if (!openmp || openmp->has_locks || asks_sequential(plan) || !facts->inspector.exists ||
        !may_be_reordered(facts) || facts->array_count == 0)
        return NULL;
    array_section *sections = ARENA_ARRAY(plan->arena, array_section, facts->array_count);
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!find_section(plan, &facts->arrays[i], &sections[i]))
            return NULL;
    return sections;
}

/* The reason why protected updates keep the order of the loop, or NULL. */
static const char *why_in_order(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    const bins_plan *bins = plan->bins;
    if (asks_sequential(plan))
        return "--order=serial";
    for (unsigned i = 0; i < facts->array_count; i++)
        if (facts->arrays[i].is_interleaved)
            return arena_format(plan->arena,
                                "memory between the updated elements of '%s' holds other data",
                                facts->arrays[i].name);
    if (facts->slice.exits)
        return "an iteration may end the loop, or print";
    if (!may_be_reordered(facts))
        return "its results depend on the order";
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!may_be_copied(plan, &facts->arrays[i]))
            return "a sanitizer checks signed sums for overflow";
    if (!bins)
        return plan->no_bins;
    if (bins->is_checked)
        return "what it updates may overlap subscripts or conditions of its reads; declare "
               "pointers to updated arrays restrict";
    for (unsigned i = 0; i < bins->stream_count; i++)
        if (span_of_stream(bins, i))
            return "an inner loop updates consecutive elements";
    return facts->array_count > 0 ? NULL : "it updates no array";
}

void plan_unordered(loop_plan *plan) {
    const openmp_loop *openmp = plan->facts->variables.openmp;
    if (!openmp || !openmp->has_locks)
        return;
    plan->execution.in_order = why_in_order(plan);
    plan->execution.is_unordered = !plan->execution.in_order;
}

bool is_reordered(const loop_plan *plan) {
    return plan->execution.sections || plan->execution.is_unordered;
}
