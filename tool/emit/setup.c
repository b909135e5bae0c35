/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Before a loop is written: what things will be called, what the runtime is told of, and what
 *  forbids writing it at all. */
#include "emit/setup.h"

#include <ctype.h>
#include <string.h>

#include "analysis/loop/executed.h"
#include "emit/dry_run.h"
#include "emit/hoist.h"
#include "emit/macro_names.h"
#include "emit/syntax.h"

/* ---- names --------------------------------------------------------------------------------- */

/** The last identifier of a base: `b` of `s->b`. */
static const char *short_name(const ir_node *base) {
    if (base->kind == IR_MEMBER && base->field && base->field->name[0])
        return base->field->name;
    if (base->kind == IR_VARIABLE)
        return base->variable->name;
    return "array";
}

static bool has_sizeof(const ir_node *node) {
    if (node->kind == IR_SIZEOF || node->kind == IR_OPAQUE)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (has_sizeof(node->children[i]))
            return true;
    return false;
}

/** Does the tree name the variable at `at`, a place in the file? Macros have no places. */
static bool is_named_at(const ir_node *node, const ir_variable *variable, uint32_t at) {
    if (node->kind == IR_VARIABLE && node->variable == variable && node->range.begin == at &&
        !(node->flags & IR_FROM_MACRO))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_named_at(node->children[i], variable, at))
            return true;
    return false;
}

static bool is_named_by_macro(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_VARIABLE && node->variable == variable && node->flags & IR_FROM_MACRO)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_named_by_macro(node->children[i], variable))
            return true;
    return false;
}

enum { MOST_MENTIONS = 64 }; /* each is looked for in the whole body */

/** Is the variable named in the body by the tree's own nodes alone? What stands in types (the
 *  length of an array, a typeof) is not in the tree, and may ask for the array's type or size. */
static bool is_named_by_nodes(const loop_text *loop, const ir_variable *variable) {
    const ir_node *body = loop->facts->counted.body;
    const char *text = loop->unit->source->text;
    const size_t length = strlen(variable->name);
    unsigned mentions = 0;
    for (uint32_t at = body->range.begin; at < body->range.end; at++) {
        if (text[at] == '\\' || text[at] == '?') { /* words may be spelled otherwise */
            if (text[at] == '\\' || text[at + 1] == '?')
                return false;
            continue;
        }
        const bool is_begin =
            source_is_name_byte(text[at]) && (at == 0 || !source_is_name_byte(text[at - 1]));
        if (is_begin && strncmp(text + at, variable->name, length) == 0 &&
            !source_is_name_byte(text[at + length]) &&
            (++mentions > MOST_MENTIONS || !is_named_at(body, variable, at)))
            return false;
    }
    return !is_named_by_macro(body, variable);
}

/** A macro may name the variable where the tree shows nothing of it: `#define LIKE typeof(h)`. */
bool has_macro(const loop_text *loop) {
    const ir_range body = loop->facts->counted.body->range;
    return macro_name_in(loop->arena, loop->unit, loop->unit->source->text + body.begin,
                         body.end - body.begin) != NULL;
}

bool can_be_pointer(const loop_text *loop, const ir_variable *variable) {
    return !has_sizeof(loop->facts->counted.body) && !has_macro(loop) &&
           is_named_by_nodes(loop, variable);
}

/** A pointer of the same name may stand for the variable, unless its type or its size as an array
 *  may be asked. */
static bool can_be_shadowed(const loop_text *loop, const ir_node *base) {
    if (base->kind != IR_VARIABLE)
        return false;
    return base->type->kind == IR_POINTER || can_be_pointer(loop, base->variable);
}

/** The base's own address - of an array as a whole, a pointer to an array; of a pointer, where that
 *  lies - is not that of what stands for it. */
static void check_address(loop_text *loop, const ir_node *base, const ir_node *node) {
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS && syntax_same(base, node->children[0]))
        loop_obstacle(loop, node->range, "the address of its array as a whole is taken");
    for (unsigned i = 0; i < node->child_count; i++)
        check_address(loop, base, node->children[i]);
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
        text->is_shadowed = can_be_shadowed(loop, base);
        check_address(loop, base, facts->counted.body);
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

/* ---- sources ------------------------------------------------------------------------------- */

/** Do two facts tell of one thing, so that the runtime need be told of only one? */
static bool move_together(const loop_source *left, const loop_source *right) {
    if (left->extent != right->extent)
        return false;
    if (left->extent == EXTENT_TOUCHED)
        return left->base && right->base && syntax_same(left->base, right->base);
    return syntax_same(left->row, right->row) && source_ends_equal(left, right);
}

/** Numbers the sources that the runtime must know: what may overlap, what decides subscripts. */
static void number_sources(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    source_text *sources = ARENA_ARRAY(loop->arena, source_text, facts->source_count + 1);
    int *numbers = ARENA_ARRAY(loop->arena, int, facts->source_count + 1);
    for (unsigned i = 0; i < facts->source_count; i++) {
        const loop_source *fact = &facts->sources[i];
        numbers[i] = SOURCE_NOT_TOLD;
        if (!fact->needs_guard && !fact->is_subscript)
            continue;
        unsigned number = 0;
        while (number < loop->source_count && !move_together(sources[number].fact, fact))
            number++;
        if (number == loop->source_count)
            sources[loop->source_count++] = (source_text){fact, false};
        sources[number].is_subscript |= fact->is_subscript;
        numbers[i] = (int)number;
    }
    loop->sources = sources;
    loop->source_number = numbers;
}

/* ---- what may stop it ---------------------------------------------------------------------- */

static bool is_constant(const ir_type *type) {
    const ir_type *inner = ir_type_innermost(type);
    return (type->is_const || inner->is_const) && !inner->is_volatile && !inner->is_atomic &&
           ir_type_is_scalar(inner) && inner->kind != IR_POINTER;
}

/** Is the variable used other than by reading it, or elements of it? Of what stands in the body
 * there is one in each copy of it. */
static bool goes_by_address(const ir_node *node, const ir_variable *variable) {
    if (node->kind == IR_VARIABLE && node->variable == variable) {
        const ir_node *whole = node;
        while (whole->type->kind == IR_ARRAY && whole->parent->kind == IR_INDEX &&
               whole->parent->children[0] == whole)
            whole = whole->parent;
        return whole->type->kind == IR_ARRAY ||
               (whole->parent->kind == IR_UNARY && whole->parent->op == IR_OP_ADDRESS);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        if (goes_by_address(node->children[i], variable))
            return true;
    return false;
}

static void check_statement(loop_text *loop, const ir_node *node) {
    if (node->kind == IR_LABEL)
        loop_obstacle(loop, node->range, "its body holds a label, which cannot stand twice");
    if (node->kind == IR_DECLARATOR && node->variable->storage == IR_GLOBAL)
        loop_obstacle(loop, node->range, "its body declares '%s' extern", node->variable->name);
    if (node->kind == IR_DECLARATOR && node->variable->storage == IR_STATIC_LOCAL &&
        (!is_constant(node->variable->type) ||
         goes_by_address(loop->facts->counted.body, node->variable)))
        loop_obstacle(loop, node->range, "its body declares '%s' static", node->variable->name);
    if (node->kind == IR_VARIABLE && node->variable->storage == IR_THREAD_LOCAL &&
        !ir_type_is_scalar(node->variable->type))
        loop_obstacle(loop, node->range, "'%s' is another object in each thread",
                      node->variable->name);
    for (unsigned i = 0; i < node->child_count; i++)
        check_statement(loop, node->children[i]);
}

/** Does the function's text say `inline` before its body, and not `static`? A static object may
 *  not stand in it (C17 6.7.4p3). */
static bool is_shared_inline(const ir_unit *unit, const ir_function *function) {
    if (function->linkage.is_static || !function->body)
        return false;
    const char *text = unit->source->text;
    for (uint32_t i = function->range.begin; i + 6 <= function->body->range.begin; i++)
        if (strncmp(text + i, "inline", 6) == 0 && !(i > 0 && isalnum((unsigned char)text[i - 1])))
            return true; /* not that of `noinline` */
    return false;
}

static void check_loop(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    if (is_shared_inline(loop->unit, facts->function))
        loop_obstacle(loop, facts->loop->range,
                      "'%s' is inline but not static: it cannot hold static data",
                      facts->function->name);
    const uint32_t end = syntax_statement_end(loop->unit->source, facts->loop);
    if (facts->loop->kind == IR_DO && end == facts->loop->range.end)
        loop_obstacle(loop, facts->loop->range, "its semicolon stands in a macro");
    if (syntax_editable_statement(facts->loop, facts->function->body) != facts->loop)
        loop_obstacle(loop, facts->loop->range, "one macro call stands for it and more");
    for (unsigned i = 0; i < facts->array_count; i++) {
        const ir_variable *root = ir_root_variable(facts->arrays[i].base);
        if (root && root->storage == IR_THREAD_LOCAL)
            loop_obstacle(loop, facts->loop->range, "'%s' is another object in each thread",
                          root->name);
    }
    check_statement(loop, facts->loop);
}

void prepare_loop(loop_text *loop) {
    check_loop(loop);
    name_arrays(loop);
    name_counter(loop);
    number_sources(loop);
    check_what_is_read_ahead(loop);
    check_stale_slice(loop);
}
