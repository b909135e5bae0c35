/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/exported.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/loop_text.h"
#include "analysis/base/unit_text.h"
#include "analysis/memory/access.h"
#include "analysis/memory/location.h"

const char *exported_word(exported_kind kind) {
    assert(kind <= EXPORTED_PURE);
    static const char *const words[] = {[EXPORTED_CONST] = "const",
                                        [EXPORTED_ARGUMENTS] = "pure of its arguments",
                                        [EXPORTED_PURE] = "pure"};
    return words[kind];
}

/* Is the function defined without `inline` before its body? An inline function may have another
 * definition elsewhere. False if its text is not in the main file. */
static bool is_plain_definition(const ir_unit *unit, const ir_function *function) {
    const source *s = unit->source;
    const ir_range head = {function->range.begin, function->body->range.begin};
    if (head.begin >= head.end || head.end > s->length)
        return false;
    for (uint32_t i = head.begin; i + 6 <= head.end; i++)
        if (memcmp(s->text + i, "inline", 6) == 0)
            return false;
    return true;
}

/* Does the file contain a pragma, such as #pragma weak, by which another definition may replace one
 * of its functions? */
static bool has_linkage_pragma(const ir_unit *unit) {
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *d = &unit->directives[i];
        if (d->kind == IR_DIRECTIVE_PRAGMA && !d->is_skipped && d->text &&
            (strstr(d->text, "weak") || strstr(d->text, "redefine_extname") ||
             strstr(d->text, "visibility")))
            return true;
    }
    return false;
}

bool exported_is_plain(arena *a, const ir_unit *unit, const ir_function *function) {
    const ir_linkage *linkage = &function->linkage;
    return function->body && function->is_in_main_file && !linkage->is_static &&
           (!linkage->is_weak || linkage->is_interposable) && !linkage->is_renamed &&
           !function->is_variadic && !function->is_noreturn && !function->has_other_attributes &&
           !function->has_errors && strcmp(function->name, "main") != 0 &&
           is_plain_definition(unit, function) && !has_linkage_pragma(unit) &&
           !unit->text.includes_itself && !unit->text.unseen_word &&
           !unit->dialect.refusing_option && !unit_text_fenv_access(unit_text_new(a, unit)) &&
           !text_openmp_in(a, unit, function);
}

/* Is the accessed memory the target of a pointer parameter, reached through no other pointer? */
static bool is_of_argument(const access *item) {
    const ir_node *lvalue = item->lvalue;
    while (lvalue && lvalue->kind != IR_VARIABLE) {
        const bool follows_pointer =
            (lvalue->kind == IR_UNARY && lvalue->op == IR_OP_DEREFERENCE) ||
            (lvalue->kind == IR_INDEX && lvalue->children[0]->type &&
             lvalue->children[0]->type->kind == IR_POINTER) ||
            (lvalue->kind == IR_MEMBER && (lvalue->flags & IR_ARROW));
        const bool is_part = lvalue->kind == IR_INDEX || lvalue->kind == IR_MEMBER;
        if (!follows_pointer && !is_part)
            return false;
        lvalue = lvalue->children[0];
        if (follows_pointer)
            break;
    }
    return lvalue && lvalue->kind == IR_VARIABLE && lvalue->variable->storage == IR_PARAMETER &&
           lvalue->variable->type->kind == IR_POINTER;
}

static exported_kind kind_of(effects *all, const ir_function *function) {
    const access_list *list = effects_of(all, function);
    if (!list || list->problems.count || list->may_set_errno || function->has_errors ||
        function->is_variadic || function->is_noreturn || function->has_other_attributes)
        return EXPORTED_NOTHING;
    exported_kind kind = EXPORTED_CONST;
    for (unsigned i = 0; i < list->items.count; i++) {
        const access *item = &list->items.items[i];
        if (item->kind != ACCESS_READ)
            return EXPORTED_NOTHING;
        if (item->is_presumed || !is_of_argument(item))
            kind = EXPORTED_PURE;
        else if (kind == EXPORTED_CONST)
            kind = EXPORTED_ARGUMENTS;
    }
    return kind;
}

exported_functions exported_of_unit(arena *a, const ir_unit *unit,
                                    const analysis_options *options) {
    must_write *prover = must_write_new(a, unit, options);
    variable_facts *facts = variable_facts_new(a, unit, prover);
    effects *all = effects_new(a, unit, options, facts);
    const bool is_doubtful = has_linkage_pragma(unit);
    VECTOR(exported_function) found = {0};
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *function = unit->functions[i];
        if (!function->body || function->linkage.is_static || function->linkage.is_weak)
            continue;
        const bool is_known =
            !is_doubtful && function->is_in_main_file && is_plain_definition(unit, function);
        const exported_function one = {function->name,
                                       is_known ? kind_of(all, function) : EXPORTED_NOTHING};
        VECTOR_PUSH(a, &found, one);
    }
    return (exported_functions){found.count, found.items};
}
