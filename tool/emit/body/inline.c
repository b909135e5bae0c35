/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * gcc inlines a static function of any size if it has a single call. The generated text contains
 * several copies of that call, so gcc would no longer inline a large function, which cost 12 % of
 * the time of a loop over triangles. So the function is declared inline, for gcc only: clang
 * decides for each call separately, and rejects such a declaration after the definition.
 */
#include <string.h>

#include "emit/body/body.h"
#include "emit/text/origin.h"

/** May a pragma of the file change compiler options? Compilers may not inline functions with
 *  different options into each other. */
static bool has_compiler_pragmas(const ir_unit *unit) {
    for (unsigned i = 0; i < unit->directive_count; i++)
        if (unit->directives[i].kind == IR_DIRECTIVE_PRAGMA &&
            strstr(unit->directives[i].text, "GCC"))
            return true;
    return false;
}

/** Does the declarator's text contain no attributes? libclang does not report all of them. */
static bool is_declared_plainly(const ir_unit *unit, const ir_function *function) {
    const char *at = unit->source->text + function->range.begin;
    const char *const body = unit->source->text + function->body->range.begin;
    for (; at < body; at++)
        if (strncmp(at, "__attribute", 11) == 0 || strncmp(at, "[[", 2) == 0)
            return false;
    return true;
}

static bool is_called_once(const ir_unit *unit, const ir_function *function) {
    return function->body && function->linkage.is_static && function->is_in_main_file &&
           function->reference_count == 1 && !function->is_variadic && !function->has_attributes &&
           function->body->range.end > function->range.begin && is_declared_plainly(unit, function);
}

/** Does another declaration, perhaps of a parameter, have the function's name? It may hide the
 *  function at the place where `inline` is added. */
static bool is_name_shared(const ir_unit *unit, const char *name) {
    if (unit->text.inner_names && map_get(unit->text.inner_names, name, strlen(name)))
        return true;
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->name && strcmp(unit->variables[i]->name, name) == 0)
            return true;
    return false;
}

typedef struct declaring {
    const loop_text *loop;
    writer *out;
} declaring;

static bool declare_callee(ir_node *node, void *context) {
    declaring *d = context;
    if (node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
        is_called_once(d->loop->unit, node->children[0]->function) &&
        !is_name_shared(d->loop->unit, node->children[0]->function->name))
        writer_line(d->out, "REDCC_KEEP_INLINED(%s)",
                    origin_function_declarator(d->loop->arena, node->children[0]->function));
    return true;
}

void declare_inlined(loop_text *loop, writer *out) {
    declaring d = {.loop = loop, .out = out};
    if (!has_compiler_pragmas(loop->unit))
        ir_walk(loop->facts->loop, declare_callee, &d);
}
