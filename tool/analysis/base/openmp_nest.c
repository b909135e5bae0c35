/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/openmp_nest.h"

#include <stdlib.h>
#include <string.h>

#include "analysis/base/loop_text.h"

/* ---- from the directive inwards ------------------------------------------------------------- */

const ir_variable *openmp_counter(const ir_node *loop) {
    const ir_node *first = loop->kind == IR_FOR ? loop->children[0] : NULL;
    while (first && first->child_count &&
           (first->kind == IR_EXPRESSION || first->kind == IR_ASSIGN))
        first = first->children[0];
    return first && first->kind == IR_VARIABLE ? first->variable : NULL;
}

const ir_node *openmp_inner_loop(const ir_node *loop) {
    const ir_node *body = ir_loop_body(loop);
    while (body->kind == IR_BLOCK && body->child_count == 1)
        body = body->children[0];
    return body->kind == IR_FOR ? body : NULL;
}

static bool names(const openmp_directive *read, const ir_variable *variable) {
    for (unsigned i = 0; i < read->item_count; i++)
        if (read->items[i].kind <= OPENMP_REDUCTION &&
            strcmp(read->items[i].text, variable->name) == 0)
            return true;
    return false;
}

unsigned openmp_depth(const openmp_directive *read) {
    for (unsigned i = 0; i < read->item_count; i++)
        if (read->items[i].kind == OPENMP_COLLAPSE)
            return (unsigned)strtoul(read->items[i].text, NULL, 10);
    return 1;
}

openmp_directive openmp_read_above(arena *a, const ir_unit *unit, const ir_directive *d,
                                   const ir_node *loop) {
    openmp_directive read = openmp_read(a, unit, d);
    const unsigned depth = read.kept ? 1 : openmp_depth(&read);
    VECTOR(openmp_item) items = {0};
    for (unsigned i = 0; i < read.item_count; i++)
        VECTOR_PUSH(a, &items, read.items[i]);
    for (unsigned level = 1; level < depth; level++) {
        loop = openmp_inner_loop(loop);
        const ir_variable *counter = loop ? openmp_counter(loop) : NULL;
        if (!loop ||
            (!counter && (!loop->children[0] || loop->children[0]->kind != IR_DECLARATION))) {
            read.kept = "a nest of loops that is not understood";
            return read;
        }
        const openmp_item item = {OPENMP_PRIVATE, REDUCTION_NONE, counter ? counter->name : NULL,
                                  NULL, "private"};
        if (counter && !names(&read, counter))
            VECTOR_PUSH(a, &items, item);
    }
    read.items = items.items;
    read.item_count = items.count;
    return read;
}

/* ---- from the loop outwards ----------------------------------------------------------------- */

/* Does the directive apply to nested loops, or may a macro in it make it do so? */
static bool may_be_about_nest(const ir_unit *unit, const ir_directive *d) {
    static const char *const words[] = {"collapse", "ordered", "tile", "interchange"};
    if (d->is_skipped || !d->text || !directive_is_openmp(d))
        return false;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strstr(d->text, words[i]))
            return true;
    size_t length;
    return unit->text.macros &&
           source_find_name(d->text, d->text + strlen(d->text), unit->text.macros, &length);
}

/* Returns the name of a macro directly before the loop that may expand to a pragma; NULL if there
 * is none. */
static const char *macro_above(arena *a, const ir_unit *unit, const ir_node *loop) {
    const ir_node *parent = loop->parent;
    ir_range before = {parent->range.begin, loop->range.begin};
    for (unsigned i = 0; i < parent->child_count && parent->children[i] != loop; i++)
        if (parent->kind == IR_BLOCK && parent->children[i]->range.end > before.begin)
            before.begin = parent->children[i]->range.end;
    return text_pragma_macro(a, unit, before);
}

static const char *about_nest(arena *a, const ir_unit *unit, const ir_node *outer) {
    for (unsigned i = loop_text_first_directive(unit, loop_text_begin(unit, outer));
         i < unit->directive_count && unit->directives[i].range.begin < outer->range.begin; i++)
        if (may_be_about_nest(unit, &unit->directives[i]))
            return openmp_plain_text(a, unit->directives[i].text);
    return macro_above(a, unit, outer);
}

const char *openmp_about_nest(arena *a, const ir_unit *unit, const ir_node *loop) {
    if (!unit->dialect.has_openmp || !unit->source)
        return NULL;
    const char *found = NULL;
    for (const ir_node *outer = loop->parent;
         outer && outer->parent && (outer->kind == IR_BLOCK || outer->kind == IR_FOR) && !found;
         outer = outer->parent)
        if (outer->kind == IR_FOR)
            found = about_nest(a, unit, outer);
    return found;
}
