/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/sections.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/base/openmp_loop.h"
#include "emit/text/origin.h"

/* What the clause says of one array. */
typedef struct section {
    const char *lower, *length; /* expressions, in units of *array */
} section;

static const openmp_item *clause_of(const loop_text *loop, const ir_variable *variable) {
    const openmp_loop *openmp = loop->facts->variables.openmp;
    for (unsigned i = 0; i < openmp->item_count; i++)
        if (openmp->items[i].kind == OPENMP_REDUCTION &&
            openmp_variable(loop->unit, loop->facts->loop, loop->facts->function,
                            openmp->items[i].text) == variable)
            return &openmp->items[i];
    return NULL;
}

/* The constant that a name denotes in all functions of the file; NULL: it denotes none, or one of a
 * single function. */
static const ir_node *enumerator_in(const ir_node *node, const char *name) {
    const ir_node *found = node->kind == IR_NUMBER && node->flags & IR_HAS_VALUE && node->text &&
                                   strcmp(node->text, name) == 0
                               ? node
                               : NULL;
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = enumerator_in(node->children[i], name);
    return found;
}

static const ir_node *enumerator_of(const ir_unit *unit, const char *name) {
    const ir_node *found = NULL;
    if (unit->text.inner_names && map_get(unit->text.inner_names, name, strlen(name)))
        return NULL;
    for (unsigned i = 0; i < unit->function_count && !found; i++)
        if (unit->functions[i]->body)
            found = enumerator_in(unit->functions[i]->body, name);
    return found;
}

/* The value of a name, as text; NULL: it is neither an integer variable nor an enumerator. */
static const char *value_of(const loop_text *loop, const char *name) {
    const ir_variable *variable =
        openmp_variable(loop->unit, loop->facts->loop, loop->facts->function, name);
    if (variable)
        return variable->type->kind == IR_INTEGER && !variable->type->is_volatile &&
                       !variable->type->is_atomic
                   ? origin_variable(loop->arena, variable)
                   : NULL;
    const ir_node *constant = enumerator_of(loop->unit, name);
    return constant ? arena_format(loop->arena, "(%lld)", (long long)constant->value) : NULL;
}

/* An expression of variables, numbers and operators, its names marked. It has no effect and can be
 * evaluated before the loop: nothing traps or reads other memory. NULL: it is another one. */
static const char *simple_expression(const loop_text *loop, const char *text) {
    buffer out = {0};
    size_t length;
    bool is_simple = !strstr(text, "++") && !strstr(text, "--");
    for (const char *at = openmp_token(text, &length); is_simple && length > 0;
         at = openmp_token(at + length, &length)) {
        const char *const token = arena_copy(loop->arena, at, length);
        const bool is_plain = isdigit((unsigned char)*at) || strchr("+-*()", *at);
        const char *const written = is_plain                   ? token
                                    : openmp_is_name(text, at) ? value_of(loop, token)
                                                               : NULL;
        is_simple = written != NULL;
        buffer_format(&out, "%s%s", out.length ? " " : "", is_simple ? written : "");
    }
    const bool is_some = out.length > 0;
    const char *const result = buffer_take(loop->arena, &out);
    return is_simple && is_some ? result : NULL;
}

/* Do the "]["-separated brackets after the first one select whole rows of this type? */
static bool are_whole(const char *rest, const ir_type *row) {
    for (; rest; row = row->target) {
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
    return !row || row->kind != IR_ARRAY; /* a part of the rows */
}

/* Returns false if the text does not show the section. */
static bool find_section(const loop_text *loop, const reduction_array *array, section *it) {
    const ir_node *base = array->base;
    const openmp_item *item =
        base && base->kind == IR_VARIABLE ? clause_of(loop, base->variable) : NULL;
    if (!item || array->is_scattered || array->order_is_kept)
        return false;
    const ir_type *type = base->variable->type;
    if (!item->section) {
        *it = (section){"0", arena_format(loop->arena, "%lld", (long long)type->count)};
        return type->kind == IR_ARRAY && type->count > 0;
    }
    const char *const rest = strstr(item->section, "][");
    const size_t first = rest ? (size_t)(rest - item->section) : strlen(item->section);
    const char *const text = arena_copy(loop->arena, item->section, first);
    const char *const colon = strchr(text, ':');
    if (!colon || (type->kind != IR_ARRAY && type->kind != IR_POINTER) ||
        !are_whole(rest, type->target))
        return false;
    const char *const lower = arena_copy(loop->arena, text, (size_t)(colon - text));
    it->lower = lower[strspn(lower, " \t")] ? simple_expression(loop, lower) : "0";
    it->length = simple_expression(loop, colon + 1);
    return it->lower && it->length;
}

bool is_sectioned(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    const bool asks_sequential =
        loop->options->order_is_explicit && loop->options->order == ORDER_SERIAL;
    section unused;
    if (!facts->variables.openmp || facts->variables.openmp->has_locks || asks_sequential ||
        !facts->inspector.exists || loop->plan->execution.needs_order)
        return false;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!find_section(loop, &facts->arrays[i], &unused))
            return false;
    return facts->array_count > 0;
}

result_order order_of_loop(loop_text *loop) {
    const result_order order = loop->options->order;
    return order == ORDER_SERIAL && is_sectioned(loop) ? ORDER_FIXED : order;
}

void write_sections(loop_text *loop, writer *out) {
    if (!is_sectioned(loop))
        return;
    writer_line(out, "REDCC_SECTIONS(%u);", loop->facts->array_count);
    for (unsigned i = 0; i < loop->facts->array_count; i++) {
        const reduction_array *array = &loop->facts->arrays[i];
        section it;
        find_section(loop, array, &it);
        writer_line(out, "REDCC_SECTION(%u, %s, %s, %s);", i,
                    origin_variable(loop->arena, array->base->variable), it.lower, it.length);
    }
}
