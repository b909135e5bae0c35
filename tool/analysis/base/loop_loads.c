/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/loop_loads.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/expression.h"

enum { MOST_NAMED = 32 }; /* greatest number of added variables in one function */

/* ---- loads that qualify ---------------------------------------------------------------------- */

/* Returns the length of the type's spelling without a final `const`, which qualifies the pointer
 * itself. Pointers that are members of a const record have such a `const`. */
static size_t length_of_spelling(const ir_type *type) {
    static const char word[] = "*const";
    const size_t length = strlen(type->spelling), last = sizeof word - 1;
    const bool ends_so = length > last && strcmp(type->spelling + length - last, word) == 0;
    return type->is_const && ends_so ? length - (last - 1) : length;
}

static bool is_plain_pointer(const ir_type *type) {
    return type && type->kind == IR_POINTER && type->spelling &&
           type->is_const == (length_of_spelling(type) < strlen(type->spelling)) &&
           !type->is_volatile && !type->is_atomic && !type->is_restrict &&
           !type->has_address_space && type->target && type->target->kind != IR_FUNCTION_TYPE &&
           !type->target->is_volatile && !type->target->is_atomic &&
           !type->target->has_address_space;
}

/* The p of p->a.b.c with a plain pointer c; stores the offset of c from p in *offset. NULL if the
 * expression has another form. */
static const ir_node *pointer_under(const ir_node *node, int64_t *offset) {
    *offset = 0;
    if (!is_plain_pointer(node->type))
        return NULL;
    for (; node->kind == IR_MEMBER; node = node->children[0]) {
        const ir_field *field = node->field;
        if (!field || field->is_bit_field || field->offset < 0 || !node->type ||
            node->type->is_volatile || node->type->is_atomic)
            return NULL;
        *offset += field->offset;
        if (node->flags & IR_ARROW)
            return node->children[0];
    }
    return NULL;
}

static bool is_root(const ir_node *node) {
    return node->kind == IR_VARIABLE && node->type && node->type->kind == IR_POINTER &&
           !node->type->is_volatile && !node->type->is_atomic &&
           (node->variable->storage == IR_LOCAL || node->variable->storage == IR_PARAMETER);
}

static bool is_load(const ir_node *node) {
    int64_t offset;
    const ir_node *under = node->kind == IR_MEMBER ? pointer_under(node, &offset) : NULL;
    return under && (is_root(under) || is_load(under));
}

/* ---- their variables ------------------------------------------------------------------------- */

static ir_variable *named(unsigned count, ir_variable *const *variables,
                          const ir_function *function, const ir_node *node) {
    for (unsigned i = 0; i < count; i++)
        if (variables[i]->stands_for && variables[i]->function == function &&
            expression_same(variables[i]->stands_for, node))
            return variables[i];
    return NULL;
}

typedef struct naming {
    ir_unit *unit;
    const ir_function *function;
    unsigned count; /* number of variables added to the function */
    VECTOR(ir_variable *) variables;
} naming;

static void name_load(naming *n, const ir_node *node) {
    assert(is_load(node));
    int64_t offset;
    const ir_node *under = pointer_under(node, &offset);
    if (is_load(under))
        name_load(n, under);
    if (n->count == MOST_NAMED ||
        named(n->unit->variable_count, n->unit->variables, n->function, node) ||
        named(n->variables.count, n->variables.items, n->function, node))
        return;
    arena *a = n->unit->arena;
    ir_type *type = ARENA_NEW(a, ir_type);
    *type = *node->type;
    type->is_const = false;
    type->spelling = arena_copy(a, type->spelling, length_of_spelling(node->type));
    ir_variable *variable = ARENA_NEW(a, ir_variable);
    *variable = (ir_variable){.name = arena_format(a, "redcc__read_%u", n->count++),
                              .type = type,
                              .storage = IR_LOCAL,
                              .function = n->function,
                              .id = n->unit->variable_count + n->variables.count,
                              .is_unnamed = true,
                              .stands_for = node};
    VECTOR_PUSH(a, &n->variables, variable);
}

static void name_loads(naming *n, const ir_node *node, bool is_in_loop) {
    if (is_in_loop && is_load(node)) {
        name_load(n, node);
        return;
    }
    is_in_loop |= ir_is_loop(node);
    for (unsigned i = 0; i < node->child_count; i++)
        name_loads(n, node->children[i], is_in_loop);
}

static unsigned count_named(const ir_unit *unit, const ir_function *function) {
    unsigned count = 0;
    for (unsigned i = 0; i < unit->variable_count; i++)
        count += unit->variables[i]->stands_for && unit->variables[i]->function == function;
    return count;
}

void loop_loads_name(ir_unit *unit) {
    naming n = {.unit = unit};
    for (unsigned i = 0; i < unit->function_count; i++) {
        n.function = unit->functions[i];
        n.count = count_named(unit, n.function);
        if (n.function->body && n.function->is_in_main_file)
            name_loads(&n, n.function->body, false);
    }
    ir_variable **all =
        ARENA_ARRAY(unit->arena, ir_variable *, unit->variable_count + n.variables.count + 1);
    for (unsigned i = 0; i < unit->variable_count; i++)
        all[i] = unit->variables[i];
    for (unsigned i = 0; i < n.variables.count; i++)
        all[unit->variable_count + i] = n.variables.items[i];
    unit->variables = all;
    unit->variable_count += n.variables.count;
}

/* ---- loads of a loop ------------------------------------------------------------------------- */

typedef struct search {
    arena *memory;
    const ir_unit *unit;
    const ir_function *function;
    loop_loads *found;
    bool is_over;
} search;

static ir_variable *add_load(search *s, const ir_node *node) {
    assert(is_load(node));
    loop_loads *found = s->found;
    ir_variable *variable = named(s->unit->variable_count, s->unit->variables, s->function, node);
    for (unsigned i = 0; variable && i < found->count; i++)
        if (found->items[i].variable == variable)
            return variable;
    int64_t offset;
    const ir_node *under = pointer_under(node, &offset);
    const ir_variable *const through = is_load(under) ? add_load(s, under) : under->variable;
    if (!variable || !through || found->count == LOOP_MOST_LOADS) {
        s->is_over = true;
        return NULL;
    }
    found->items[found->count++] = (loop_load){variable, through, offset};
    return variable;
}

static void find_uses(search *s, ir_node *parent, unsigned number) {
    ir_node *node = parent->children[number];
    if (!is_load(node)) {
        for (unsigned i = 0; i < node->child_count; i++)
            find_uses(s, node, i);
        return;
    }
    ir_variable *variable = add_load(s, node);
    if (!variable)
        return;
    ir_node *stand_in = ir_new(s->memory, IR_VARIABLE, variable->type, 0);
    stand_in->variable = variable;
    stand_in->id = node->id;
    stand_in->parent = parent;
    stand_in->range = node->range;
    stand_in->flags = node->flags & IR_FROM_MACRO;
    VECTOR_PUSH(s->memory, &s->found->uses, ((load_use){node, stand_in, parent, number}));
}

loop_loads *loop_loads_find(arena *a, const ir_unit *unit, const ir_function *function,
                            const ir_node *body) {
    search s = {a, unit, function, ARENA_NEW(a, loop_loads), false};
    for (unsigned i = 0; i < body->child_count; i++)
        find_uses(&s, (ir_node *)body, i);
    return s.is_over || s.found->count == 0 ? NULL : s.found;
}

void loop_loads_take_out(const loop_loads *loads) {
    for (unsigned i = 0; loads && i < loads->uses.count; i++) {
        const load_use *use = &loads->uses.items[i];
        assert(use->parent->children[use->number] == use->node);
        use->parent->children[use->number] = use->stand_in;
    }
}

void loop_loads_put_back(const loop_loads *loads) {
    for (unsigned i = 0; loads && i < loads->uses.count; i++) {
        const load_use *use = &loads->uses.items[i];
        assert(use->parent->children[use->number] == use->stand_in);
        use->parent->children[use->number] = use->node;
    }
}

bool loop_loads_has(const loop_loads *loads, const ir_variable *variable) {
    for (unsigned i = 0; loads && i < loads->count; i++)
        if (loads->items[i].variable == variable)
            return true;
    return false;
}
