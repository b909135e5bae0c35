/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/names.h"

#include <string.h>

/** The last identifier of a base: `b` of `s->b`. */
static const char *short_name(const ir_node *base) {
    if (base->kind == IR_MEMBER && base->field && base->field->name[0])
        return base->field->name;
    if (base->kind == IR_VARIABLE)
        return base->variable->name;
    return "array";
}

static void name_arrays(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    array_text *arrays = ARENA_ARRAY(loop->arena, array_text, facts->array_count);
    for (unsigned i = 0; i < facts->array_count; i++) {
        const ir_node *base = facts->arrays[i].base;
        const char *name = short_name(base);
        for (unsigned other = 0; other < i; other++)
            if (strcmp(short_name(facts->arrays[other].base), name) == 0) {
                name = arena_format(loop->arena, "%s_%u", name, i);
                break;
            }
        array_text *text = &arrays[i];
        text->owner = arena_format(loop->arena, "redcc__own_%s", name);
        if (facts->arrays[i].is_scattered)
            continue; /* the body's own text leads to its elements */
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
    if (!counted->counter_is_declared_in_header)
        loop->counter_type = arena_format(loop->arena, "__typeof__(%s)",
                                          origin_variable(loop->arena, counted->counter));
    else if (counted->counter->type->spelling)
        loop->counter_type = origin_type(loop->arena, counted->counter->type);
    else
        loop_obstacle(loop, loop->facts->loop->range, "the type of its counter has no name");
    if (!loop->counter_type)
        loop->counter_type = "int";
}

void name_things(loop_text *loop) {
    name_arrays(loop);
    name_counter(loop);
}
