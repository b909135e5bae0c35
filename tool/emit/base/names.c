/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/base/names.h"

#include <string.h>

#include "emit/text/origin.h"
#include "ir/ir_position.h"

/** The last identifier of a base expression: for `s->b` it is `b`. */
static const char *short_name(const ir_node *base) {
    if (base->kind == IR_MEMBER && base->field && base->field->name[0])
        return base->field->name;
    if (base->kind == IR_VARIABLE)
        return base->variable->name;
    return "array";
}

static bool is_one_of(const char *const *names, unsigned count, const char *name) {
    for (unsigned i = 0; i < count; i++)
        if (strcmp(names[i], name) == 0)
            return true;
    return false;
}

static void name_arrays(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    array_text *arrays = ARENA_ARRAY(loop->arena, array_text, facts->array_count);
    const char **names = ARENA_ARRAY(loop->arena, const char *, facts->array_count + 1);
    for (unsigned i = 0; i < facts->array_count; i++) {
        const ir_node *base = facts->arrays[i].base;
        const char *name = short_name(base);
        while (is_one_of(names, i, name))
            name = arena_format(loop->arena, "%s_%u", name, i);
        names[i] = name;
        array_text *text = &arrays[i];
        if (facts->arrays[i].is_scattered)
            continue; /* the array needs no name: the body reaches its elements through pointers */
        text->base = loop_operand(loop, base);
        text->is_shadowed = loop->plan->is_shadowed[i];
        text->declarator = text->is_shadowed ? origin_declarator(loop->arena, base->variable)
                                             : arena_format(loop->arena, "redcc__to_%s", name);
        text->local = text->is_shadowed ? origin_variable(loop->arena, base->variable)
                                        : arena_format(loop->arena, "redcc__to_%s", name);
    }
    loop->arrays = arrays;
}

static void name_counter(loop_text *loop) {
    const counted_loop *counted = &loop->facts->counted;
    if (counted->counter->type->spelling)
        loop->counter_type = origin_type(loop->arena, counted->counter->type);
    else
        loop_obstacle(loop, loop->facts->loop->range, "the type of its counter has no name");
    if (!loop->counter_type)
        loop->counter_type = "int";
}

void set_names(loop_text *loop) {
    name_arrays(loop);
    name_counter(loop);
}

/* ---- declarations -------------------------------------------------------------------------- */

/** Returns the type's spelling for a parameter or variable of a generated function. `restrict`
 * becomes __restrict__, which compilers accept in every C standard. A `restrict` at the end of the
 * spelling qualifies the parameter itself. It is dropped, with the blank before it. */
static const char *spelling_of(arena *a, const ir_type *type) {
    static const char word[] = "restrict";
    enum { LENGTH = sizeof word - 1 };
    buffer out = {0};
    for (const char *at = type->spelling; *at;) {
        const bool is_word = strncmp(at, word, LENGTH) == 0 && !source_is_name_byte(at[LENGTH]) &&
                             (at == type->spelling || !source_is_name_byte(at[-1]));
        if (is_word && at[LENGTH])
            buffer_text(&out, "__restrict__");
        else if (!is_word)
            buffer_byte(&out, *at);
        at += is_word ? LENGTH : 1;
    }
    while (out.length > 0 && out.data[out.length - 1] == ' ')
        buffer_shorten(&out, 1);
    return buffer_take(a, &out);
}

static const char *declared(loop_text *loop, const ir_type *type, const char *spelling,
                            const char *name) {
    arena *a = loop->arena;
    const char *marked = origin_spelling(a, type, spelling);
    const char last = spelling[0] ? spelling[strlen(spelling) - 1] : ' ';
    if (strpbrk(spelling, "(["))
        return arena_format(a, "__typeof__(%s) %s", marked, name);
    return arena_format(a, last == '*' || last == ' ' ? "%s%s" : "%s %s", marked, name);
}

const char *declaration_text(loop_text *loop, const ir_type *type, const char *name) {
    if (type->spelling)
        return declared(loop, type, spelling_of(loop->arena, type), name);
    loop->outline.possible = false;
    return "int";
}

/** Returns the spelling of a constant pointer to an array or function without the pointer's own
 * `const`: for `double (*const)[3]`, this is the `const` after the last `*` in the innermost
 * parentheses. */
static const char *without_const_inside(arena *a, const char *spelling) {
    static const char word[] = "const";
    const char *const close = strchr(spelling, ')'), *own = NULL, *at = close;
    while (at && at > spelling && *at != '(' && *at != '*') {
        at--;
        own = source_starts_with(at, word) ? at : own;
    }
    if (!own || *at != '*')
        return spelling;
    return arena_format(a, "%.*s%s", (int)(own - spelling), spelling, own + sizeof word - 1);
}

/** The type's spelling without its own `const`, so that objects of that type can be assigned. */
static const char *unqualified(arena *a, const ir_type *type) {
    static const char before[] = "const ", after[] = "const";
    const char *spelling = spelling_of(a, type);
    const size_t length = strlen(spelling);
    if (!type->is_const)
        return spelling;
    if (type->kind != IR_POINTER && source_starts_with(spelling, before))
        return spelling + sizeof before - 1;
    if (type->kind == IR_POINTER && length > sizeof after &&
        strcmp(spelling + length - (sizeof after - 1), after) == 0)
        return arena_copy(a, spelling, length - (sizeof after - 1));
    return type->kind == IR_POINTER ? without_const_inside(a, spelling) : spelling;
}

const char *assignable_declaration_text(loop_text *loop, const ir_type *type, const char *name) {
    if (!type->spelling)
        return declaration_text(loop, type, name);
    return declared(loop, type, unqualified(loop->arena, type), name);
}

static const char *outlined_declaration(loop_text *loop, const ir_variable *variable) {
    const ir_type *type = variable->type;
    if (type->size < 0 || type->kind == IR_OTHER_TYPE)
        loop->outline.possible = false;
    return declaration_text(loop, type, origin_declarator(loop->arena, variable));
}

const char *pointed_name(const loop_text *loop, const ir_node *node) {
    if (node->kind != IR_VARIABLE || !loop->outline.by_address)
        return NULL;
    return loop->outline.by_address[node->variable->id];
}

/** Does a loop in this subtree begin in bytes [begin, end)? */
static bool has_loop_between(const ir_node *node, uint32_t begin, uint32_t end) {
    if (ir_is_loop(node) && node->range.begin >= begin && node->range.begin < end)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (node->children[i] && has_loop_between(node->children[i], begin, end))
            return true;
    return false;
}

/** Does another loop of the function begin on the same line, before this one? */
static bool is_behind_another(const loop_text *loop) {
    const uint32_t end = loop->facts->loop->range.begin;
    uint32_t begin = end;
    while (begin > 0 && loop->unit->source->text[begin - 1] != '\n')
        begin--;
    return has_loop_between(loop->facts->function->body, begin, end);
}

const char *outlined_name(loop_text *loop, const char *part) {
    const ir_position place = ir_position_of(loop->unit, loop->facts->loop->range.begin);
    const char *name =
        arena_format(loop->arena, "redcc__%s_%s_%u", part, loop->facts->function->name, place.line);
    return is_behind_another(loop) ? arena_format(loop->arena, "%s_c%u", name, place.column) : name;
}

const char *private_declaration(loop_text *loop, const private_variable *item) {
    const ir_variable *variable = item->variable;
    return outlined_declaration(loop, variable);
}

const char *loop_lanes_name(loop_text *loop) {
    return outlined_name(loop, "lanes") + sizeof "redcc__" - 1;
}
