/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One summary a function, bottom-up: what it accesses that is not its own. */
#include <stdlib.h>
#include <string.h>

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"
#include "analysis/base/external.h"
#include "analysis/memory/access.h"
#include "analysis/memory/access_walk.h"
#include "analysis/memory/alias.h"
#include "analysis/memory/library.h"
#include "analysis/memory/search.h"

typedef struct summary {
    enum { SUMMARY_NONE, SUMMARY_IN_PROGRESS, SUMMARY_DONE } state;
    access_list list;
} summary;

struct effects {
    arena *memory;
    const ir_unit *unit;
    const analysis_options *options;
    variable_facts *facts;
    summary *summaries;       /* by function id */
    const char **local_names; /* of all functions' own variables, sorted */
    unsigned local_name_count;
};

enum { SUMMARY_LIMIT = 4000 }; /* accesses; larger functions are not followed */

/* ---- an lvalue of a function's text in terms of its parameters ------------------------------- */

typedef struct rewriting {
    effects *all;
    const ir_function *function;
    const access_list *raw;
    bool is_exact;
    unsigned depth;
} rewriting;

static ir_node *unknown_part(rewriting *r, const ir_node *node) {
    ir_node *unknown = ir_new(r->all->memory, IR_OPAQUE, node->type, 0);
    unknown->text = "?";
    unknown->range = node->range;
    r->is_exact = false;
    return unknown;
}

static int compare_names(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Could something of a function, a variable, enumerator or type, stand in front of the global one?
 */
static bool is_shadowed(const effects *all, const ir_variable *global) {
    if (all->unit->inner_names &&
        map_get(all->unit->inner_names, global->name, strlen(global->name)))
        return true;
    return bsearch(&global->name, all->local_names, all->local_name_count,
                   sizeof all->local_names[0], compare_names) != NULL;
}

static void collect_local_names(effects *all) {
    const ir_unit *unit = all->unit;
    all->local_names = ARENA_ARRAY(all->memory, const char *, unit->variable_count + 1);
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->name &&
            (variable_is_automatic(unit->variables[i]) ||
             unit->variables[i]->storage == IR_STATIC_LOCAL ||
             (unit->variables[i]->storage == IR_THREAD_LOCAL && unit->variables[i]->function)))
            all->local_names[all->local_name_count++] = unit->variables[i]->name;
    qsort(all->local_names, all->local_name_count, sizeof all->local_names[0], compare_names);
}

effects *effects_new(arena *a, const ir_unit *unit, const analysis_options *options,
                     variable_facts *facts) {
    effects *all = ARENA_NEW(a, effects);
    unsigned highest = 0;
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->id > highest)
            highest = unit->functions[i]->id;
    *all = (effects){.memory = a,
                     .unit = unit,
                     .options = options,
                     .facts = facts,
                     .summaries = ARENA_ARRAY(a, summary, highest + 1)};
    collect_local_names(all);
    return all;
}

static ir_node *rewrite(rewriting *r, const ir_node *node);

/* The value as a variable of this type holds it. */
static ir_node *as_type(arena *a, ir_node *value, const ir_type *type) {
    if (!value->type || ir_type_equal(value->type, type) || !ir_type_is_scalar(type) ||
        type->kind == IR_POINTER)
        return value;
    ir_node *cast = ir_new(a, IR_CAST, type, 1);
    cast->range = value->range;
    cast->children[0] = value;
    value->parent = cast;
    return cast;
}

static ir_node *rewrite_variable(rewriting *r, const ir_node *node) {
    const ir_variable *variable = node->variable;
    const variable_fact *fact = variable_fact_of(r->all->facts, variable);
    if (variable->storage == IR_PARAMETER) {
        if (fact->write_count || variable->address_taken || variable->type->kind == IR_RECORD)
            return unknown_part(r, node);
        return ir_substitute(r->all->memory, node, NULL, NULL);
    }
    if (variable->storage == IR_LOCAL) {
        const ir_node *value = variable_single_definition(r->all->facts, variable);
        if (!value || r->depth > 8 || value->kind == IR_INITIALIZERS ||
            variable->type->kind == IR_ARRAY || !expression_is_plain(value))
            return unknown_part(r, node);
        r->depth++;
        ir_node *result = as_type(r->all->memory, rewrite(r, value), variable->type);
        r->depth--;
        return result;
    }
    if (variable->storage == IR_STATIC_LOCAL || is_shadowed(r->all, variable))
        r->is_exact = false;
    return ir_substitute(r->all->memory, node, NULL, NULL);
}

/* May the function itself change what is read here on the way to an address? */
static bool is_stable(const rewriting *r, const ir_node *load) {
    for (unsigned i = 0; i < r->raw->items.count; i++) {
        const access *store = &r->raw->items.items[i];
        if (store->kind == ACCESS_READ || (store->lvalue && store->lvalue->kind == IR_VARIABLE &&
                                           variable_is_automatic(store->lvalue->variable)))
            continue;
        if (!r->all->unit->strict_aliasing || types_may_overlap(store->type, load->type))
            return false;
    }
    return true;
}

static ir_node *rewrite(rewriting *r, const ir_node *node) {
    if (node->kind == IR_VARIABLE)
        return rewrite_variable(r, node);
    if (node->kind == IR_OPAQUE || node->kind == IR_CALL || node->kind == IR_ASSIGN)
        return unknown_part(r, node);
    ir_node *copy = ir_new(r->all->memory, node->kind, node->type, node->child_count);
    ir_node **children = copy->children;
    *copy = *node;
    copy->children = children;
    copy->parent = NULL;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        bool is_load = child->kind != IR_VARIABLE && expression_is_lvalue(child) && child->type &&
                       ir_type_is_scalar(child->type) &&
                       !(node->kind == IR_MEMBER && !(node->flags & IR_ARROW)) &&
                       !(node->kind == IR_UNARY && node->op == IR_OP_ADDRESS);
        if (is_load && !is_stable(r, child))
            r->is_exact = false;
        children[i] = rewrite(r, child);
        children[i]->parent = copy;
    }
    return copy;
}

/* a[k] behind a pointer, k in [0, high]: the array *(T (*)[high + 1])a. */
static ir_node *widened(rewriting *r, const ir_node *lvalue, int64_t high) {
    arena *a = r->all->memory;
    const ir_type *element = lvalue->type;
    if (!element->spelling || element->kind == IR_POINTER || element->kind == IR_ARRAY ||
        element->size <= 0)
        return NULL;
    ir_type *array = ARENA_NEW(a, ir_type);
    ir_type *pointer = ARENA_NEW(a, ir_type);
    *array = (ir_type){.kind = IR_ARRAY,
                       .count = high + 1,
                       .size = (high + 1) * element->size,
                       .target = element,
                       .spelling =
                           arena_format(a, "%s[%lld]", element->spelling, (long long)(high + 1))};
    *pointer = (ir_type){
        .kind = IR_POINTER,
        .size = (int64_t)sizeof(void *),
        .target = array,
        .spelling = arena_format(a, "%s (*)[%lld]", element->spelling, (long long)(high + 1))};
    ir_node *cast = ir_new(a, IR_CAST, pointer, 1);
    ir_node *whole = ir_new(a, IR_UNARY, array, 1);
    cast->range = whole->range = lvalue->range;
    cast->children[0] = rewrite(r, lvalue->children[0]);
    cast->children[0]->parent = cast;
    whole->op = IR_OP_DEREFERENCE;
    whole->children[0] = cast;
    cast->parent = whole;
    return whole;
}

static ir_node *rewrite_lvalue(rewriting *r, const ir_node *lvalue) {
    const ir_node *row = access_extent(lvalue);
    int64_t low, high, constant;
    if (row->kind == IR_INDEX && row->children[0]->type->kind == IR_POINTER &&
        !expression_constant(row->children[1], &constant) &&
        counted_range(row->children[1], &low, &high) && low >= 0) {
        ir_node *whole = widened(r, row, high);
        if (whole)
            return whole;
    }
    return rewrite(r, row);
}

/* A search's element at another subscript, in the terms of the parameters; NULL: cannot be told. */
static const ir_node *search_element(rewriting *r, const access *item) {
    const ir_node *start = item->kind == ACCESS_READ && !item->callee && item->is_exact
                               ? search_start(r->function, item->lvalue)
                               : NULL;
    if (!start || item->lvalue->children[0]->type->kind != IR_POINTER)
        return NULL;
    ir_node *element = ir_new(r->all->memory, IR_INDEX, item->lvalue->type, 2);
    element->range = item->lvalue->range;
    element->children[0] = item->lvalue->children[0];
    element->children[1] = (ir_node *)start;
    const ir_type *cursor = item->lvalue->children[1]->type;
    if (!start->type || !ir_type_equal(start->type, cursor)) {
        element->children[1] = ir_new(r->all->memory, IR_CAST, cursor, 1);
        element->children[1]->range = start->range;
        element->children[1]->children[0] = (ir_node *)start;
    }
    r->is_exact = true;
    const ir_node *result = rewrite(r, element);
    return r->is_exact ? result : NULL;
}

/* a[from] to a[call]: the last element that a search reads is the one it finds. */
static const ir_node *found_element(arena *a, const ir_node *from, const ir_node *call) {
    ir_node *element = ir_substitute(a, from, NULL, NULL);
    element->children[1] = ir_substitute(a, call, NULL, NULL);
    element->children[1]->parent = element;
    return element;
}

/* ---- summaries --------------------------------------------------------------------------------
 */

static bool is_own(const effects *all, const ir_function *function, const ir_node *lvalue,
                   location *where) {
    *where = location_of(all->facts, lvalue, NULL);
    return where->object && variable_is_automatic(where->object) &&
           where->object->function == function;
}

static void summarise_access(effects *all, const ir_function *function, const access_list *raw,
                             const access *item, access_list *result) {
    location where;
    access kept = *item;
    kept.callee = function;
    if (!item->lvalue) {
        VECTOR_PUSH(all->memory, &result->items, kept);
        return;
    }
    if (is_own(all, function, item->lvalue, &where))
        return;
    if (where.object && item->kind != ACCESS_READ) {
        access_problem problem = {REASON_IMPURE_CALL, item->node, function->name};
        VECTOR_PUSH(all->memory, &result->problems, problem);
        return;
    }
    if (where.is_of_locale) {
        kept.lvalue = where.base;
        kept.is_exact = false;
        VECTOR_PUSH(all->memory, &result->items, kept);
        return;
    }
    rewriting r = {all, function, raw, item->is_exact, 0};
    kept.lvalue = rewrite_lvalue(&r, item->lvalue);
    kept.is_exact = r.is_exact;
    kept.from = kept.to = NULL;
    if (!kept.is_exact)
        kept.from = search_element(&r, item);
    if (where.is_string)
        return;
    if (!where.object && !where.pointer)
        kept.lvalue = NULL;
    VECTOR_PUSH(all->memory, &result->items, kept);
}

static void summarise(effects *all, const ir_function *function, access_list *result) {
    access_list raw = {0};
    access_walk walk = {all->memory, all, &raw, 0};
    access_walk_node(&walk, function->body);
    result->has_floating_work = raw.has_floating_work;
    result->has_unrepeatable_work =
        raw.has_unrepeatable_work || (raw.has_floating_work && function->has_other_attributes);
    result->may_set_errno = raw.may_set_errno;
    result->errno_setter = raw.errno_setter;
    for (unsigned i = 0; i < raw.problems.count; i++)
        if (raw.problems.items[i].why != REASON_GOTO)
            VECTOR_PUSH(all->memory, &result->problems, raw.problems.items[i]);
    if (raw.items.count > SUMMARY_LIMIT || function->is_variadic || function->has_errors) {
        access_problem problem = {REASON_IMPURE_CALL, function->body, function->name};
        VECTOR_PUSH(all->memory, &result->problems, problem);
    }
    for (unsigned i = 0; i < raw.items.count && !result->problems.count; i++)
        summarise_access(all, function, &raw, &raw.items.items[i], result);
}

const access_list *effects_of(effects *all, const ir_function *function) {
    summary *s = &all->summaries[function->id];
    if (s->state == SUMMARY_NONE) {
        s->state = SUMMARY_IN_PROGRESS;
        access_list result = {0};
        summarise(all, function, &result);
        s->list = result;
        s->state = SUMMARY_DONE;
    }
    return s->state == SUMMARY_DONE ? &s->list : NULL;
}

/* ---- calls ------------------------------------------------------------------------------------
 */

static bool is_const(const effects *all, const ir_function *function) {
    return function->is_attribute_const || external_kind(all->options, function) == EXPORTED_CONST;
}

static bool is_pure(const effects *all, const ir_function *function) {
    return function->is_attribute_pure || external_kind(all->options, function) == EXPORTED_PURE;
}

/* By the user's word, or because another file shows it: it reads what its arguments lead to. */
static bool is_presumed_pure(const effects *all, const ir_function *function) {
    if (external_kind(all->options, function) == EXPORTED_ARGUMENTS)
        return true;
    for (unsigned i = 0; all->options && i < all->options->pure_count; i++)
        if (strcmp(all->options->pure[i], function->name) == 0)
            return true;
    return false;
}

static bool is_floating(const ir_type *type) {
    return type && (type->kind == IR_FLOATING || type->kind == IR_COMPLEX);
}

static void add_pointee(access_walk *w, access_kind kind, const ir_node *call,
                        const ir_node *pointer, bool is_presumed) {
    ir_node *whole = ir_new(w->memory, IR_UNARY, NULL, 1);
    whole->op = IR_OP_DEREFERENCE;
    whole->children[0] = (ir_node *)pointer;
    whole->range = pointer->range;
    access_add(w, (access){.kind = kind,
                           .lvalue = whole,
                           .node = call,
                           .callee = call->children[0]->function,
                           .is_presumed = is_presumed});
}

/* Without side effects by attribute or by the user's word: what may it read? */
static void walk_pure_call(access_walk *w, const ir_node *call, bool by_user) {
    const ir_function *function = call->children[0]->function;
    if (library_is_locale_table(call))
        return;
    /* of another file's function the body was looked at */
    const bool is_seen = external_kind(w->all->options, function) != EXPORTED_NOTHING;
    if (!by_user && !is_seen && library_tells_of_thread(function)) {
        const bool is_errno = strcmp(function->name, "__errno_location") == 0;
        access_problem_add(w, REASON_THREAD_STATE, call, is_errno ? "errno" : function->name);
        return;
    }
    w->list->has_floating_work = w->list->has_unrepeatable_work = true;
    if (is_const(w->all, function))
        return;
    access_add(
        w, (access){.kind = ACCESS_READ, .node = call, .callee = function, .is_presumed = by_user});
    for (unsigned i = 1; i < call->child_count; i++) {
        const ir_type *type = call->children[i]->type;
        if (type && (type->kind == IR_POINTER || type->kind == IR_ARRAY))
            add_pointee(w, ACCESS_READ, call, call->children[i], false);
    }
}

static bool walk_memory_call(access_walk *w, const ir_node *call) {
    const char *name = call->children[0]->function->name;
    if (call->children[0]->function->is_renamed)
        return false;
    if (strncmp(name, "__builtin_", 10) == 0)
        name += 10;
    bool is_copy = strcmp(name, "memcpy") == 0 || strcmp(name, "memmove") == 0;
    if ((!is_copy && strcmp(name, "memset") != 0) || call->child_count != 4)
        return false;
    if (is_copy)
        add_pointee(w, ACCESS_READ, call, call->children[2], false);
    add_pointee(w, ACCESS_WRITE, call, call->children[1], false);
    return true;
}

/* Are all globals in it declared where the call stands? */
static bool is_declared_before(const ir_node *lvalue, const ir_node *call) {
    const ir_declared *declared = lvalue->kind == IR_VARIABLE ? lvalue->variable->declared : NULL;
    if (declared && !declared->file && declared->offset > call->range.begin &&
        !variable_is_automatic(lvalue->variable))
        return false;
    for (unsigned i = 0; i < lvalue->child_count; i++)
        if (!is_declared_before(lvalue->children[i], call))
            return false;
    return true;
}

static void walk_known_call(access_walk *w, const ir_node *call, const access_list *known) {
    const ir_function *function = call->children[0]->function;
    effects *all = w->all;
    if (call->child_count - 1 != function->parameter_count) {
        access_problem_add(w, REASON_IMPURE_CALL, call, function->name);
        return;
    }
    w->list->has_floating_work |= known->has_floating_work;
    w->list->has_unrepeatable_work |= known->has_unrepeatable_work;
    if (known->may_set_errno) {
        w->list->may_set_errno = true;
        w->list->errno_setter = known->errno_setter;
    }
    for (unsigned i = 0; i < known->items.count; i++) {
        access item = known->items.items[i];
        item.node = call;
        item.callee = function;
        item.is_behind = item.is_conditional;
        if (item.lvalue) {
            item.lvalue = ir_substitute(all->memory, item.lvalue, function, &call->children[1]);
            item.is_exact = item.is_exact && expression_is_plain(item.lvalue) &&
                            is_declared_before(item.lvalue, call);
        }
        if (item.from) {
            item.from = ir_substitute(all->memory, item.from, function, &call->children[1]);
            item.to = found_element(all->memory, item.from, call);
        }
        access_add(w, item);
    }
}

static void walk_library_call(access_walk *w, const ir_node *call, const library_function *found) {
    if (is_floating(call->type))
        w->list->has_floating_work = true;
    if (!found->is_exact)
        w->list->has_unrepeatable_work = true;
    if (found->sets_errno) {
        w->list->may_set_errno = true;
        w->list->errno_setter = call->children[0]->function->name;
    }
}

void access_walk_call(access_walk *w, const ir_node *call) {
    const ir_node *callee = call->children[0];
    for (unsigned i = 1; i < call->child_count; i++)
        access_walk_node(w, call->children[i]);
    if (callee->kind != IR_FUNCTION) {
        access_problem_add(w, REASON_FUNCTION_POINTER, call, expression_text(w->memory, callee));
        return;
    }
    const ir_function *function = callee->function;
    bool by_user = is_presumed_pure(w->all, function);
    const library_function *library = library_find(w->all->unit, function);
    if (function->is_noreturn) {
        access_problem_add(w, REASON_NO_RETURN, call,
                           access_is_assertion(function) ? "assert" : function->name);
    } else if (function->body && !function->is_weak) {
        const access_list *known = effects_of(w->all, function);
        if (!known)
            access_problem_add(w, REASON_RECURSION, call, function->name);
        else if (known->problems.count && by_user)
            walk_pure_call(w, call, true);
        else if (known->problems.count)
            access_problem_add(w, known->problems.items[0].why, call,
                               known->problems.items[0].name);
        else
            walk_known_call(w, call, known);
    } else if (by_user) {
        walk_pure_call(w, call, true);
    } else if (library) {
        walk_library_call(w, call, library);
    } else if (is_const(w->all, function) || is_pure(w->all, function)) {
        walk_pure_call(w, call, false);
    } else if (function->is_interposable) {
        access_problem_add(w, REASON_INTERPOSED, call, function->name);
    } else if (!walk_memory_call(w, call)) {
        access_problem_add(w, REASON_IMPURE_CALL, call, function->name);
    }
}

void access_collect(effects *all, const ir_node *node, access_list *list) {
    access_walk walk = {all->memory, all, list, 0};
    access_walk_node(&walk, node);
}
