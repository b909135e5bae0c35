/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Computes one summary per function, callees first: the function's accesses other than those of its
 * local variables. */
#include <assert.h>
#include <string.h>

#include "analysis/base/atomic_call.h"
#include "analysis/base/expression.h"
#include "analysis/base/external.h"
#include "analysis/base/library.h"
#include "analysis/base/loop_text.h"
#include "analysis/memory/access.h"
#include "analysis/memory/access_walk.h"
#include "analysis/memory/callee_terms.h"

typedef struct summary {
    enum { SUMMARY_NONE, SUMMARY_IN_PROGRESS, SUMMARY_DONE } state;
    access_list list;
} summary;

struct effects {
    arena *memory;
    const ir_unit *unit;
    const analysis_options *options;
    variable_facts *facts;
    summary *summaries; /* indexed by function id */
    const hidden_names *names;
};

/* greatest number of accesses; calls of functions with more are refused */
enum { SUMMARY_LIMIT = 4000 };

/* greatest number of updates that a list has for reports only. Without a limit, each function would
 * list those of all functions below it in the call graph */
enum { LISTED_LIMIT = 64 };

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
                     .names = hidden_names_new(a, unit),
                     .summaries = ARENA_ARRAY(a, summary, highest + 1)};
    return all;
}

/* The element a[call] for the call of a linear search, which returns the subscript of the last
 * element that it reads. */
static const ir_node *found_element(arena *a, const ir_node *from, const ir_node *call) {
    assert(from->kind == IR_INDEX);
    ir_node *element = ir_substitute(a, from, NULL, NULL);
    element->children[1] = ir_substitute(a, call, NULL, NULL);
    element->children[1]->parent = element;
    return element;
}

/* ---- summaries ------------------------------------------------------------------------------- */

/* Is it an update whose element the caller can name? */
static bool is_listed(const access *item) {
    return item->kind == ACCESS_UPDATE && item->lvalue && item->is_exact;
}

static void list_update(arena *a, access_list *list, access item) {
    if (is_listed(&item) && list->listed.count < LISTED_LIMIT)
        VECTOR_PUSH(a, &list->listed, item);
}

static void list_updates(arena *a, access_list *list, const access_vector *from) {
    for (unsigned i = 0; i < from->count; i++)
        list_update(a, list, from->items[i]);
}

static bool is_own(const effects *all, const ir_function *function, const ir_node *lvalue,
                   location *where) {
    *where = location_of(all->facts, lvalue, NULL);
    return where->object && variable_is_automatic(where->object) &&
           where->object->function == function;
}

static void summarise_access(effects *all, const callee_terms *terms, const access *item,
                             access_list *result) {
    const ir_function *function = terms->function;
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
        kept = callee_terms_of(terms, item);
        kept.callee = function;
        list_update(all->memory, result, kept);
        return;
    }
    if (where.is_of_locale) {
        kept.lvalue = where.base;
        kept.is_exact = false;
        VECTOR_PUSH(all->memory, &result->items, kept);
        return;
    }
    kept = callee_terms_of(terms, item);
    kept.callee = function;
    if (where.is_string)
        return;
    if (!where.object && !where.pointer)
        kept.lvalue = NULL;
    VECTOR_PUSH(all->memory, &result->items, kept);
}

static void summarise(effects *all, const ir_function *function, access_list *result) {
    access_list raw = {0};
    access_walk walk = {all->memory, all, &raw, 0, true};
    access_walk_node(&walk, function->body);
    result->ends = (typeof(result->ends)){raw.ends.items, raw.ends.count, raw.ends.count};
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
    const callee_terms terms = {.memory = all->memory,
                                .facts = all->facts,
                                .names = all->names,
                                .strict_aliasing = all->unit->dialect.strict_aliasing,
                                .function = function,
                                .loops = map_new(all->memory),
                                .raw = &raw};
    for (unsigned i = 0; i < raw.items.count && i <= SUMMARY_LIMIT; i++)
        summarise_access(all, &terms, &raw.items.items[i], result);
    access_list listed = {0};
    for (unsigned i = 0; i < raw.listed.count; i++)
        summarise_access(all, &terms, &raw.listed.items[i], &listed);
    list_updates(all->memory, result, &listed.items);
    list_updates(all->memory, result, &listed.listed);
    result->atomic = raw.atomic;
}

const access_list *effects_of(effects *all, const ir_function *function) {
    summary *s = &all->summaries[function->id];
    if (s->state == SUMMARY_NONE) {
        s->state = SUMMARY_IN_PROGRESS;
        access_list result = {0};
        summarise(all, function, &result);
        s->list = result;
        assert(s->state == SUMMARY_IN_PROGRESS);
        s->state = SUMMARY_DONE;
    }
    return s->state == SUMMARY_DONE ? &s->list : NULL;
}

/* ---- calls ----------------------------------------------------------------------------------- */

static bool is_const(const effects *all, const ir_function *function) {
    return function->is_attribute_const || external_kind(all->options, function) == EXPORTED_CONST;
}

static bool is_pure(const effects *all, const ir_function *function) {
    return function->is_attribute_pure || external_kind(all->options, function) == EXPORTED_PURE;
}

/* Is the function presumed, by the user or by the analysis of another file, to have no effects and
 * to read only the targets of its arguments? */
static bool is_presumed_pure(const effects *all, const ir_function *function) {
    if (external_kind(all->options, function) == EXPORTED_ARGUMENTS)
        return true;
    for (unsigned i = 0; all->options && i < all->options->pure_count; i++)
        if (strcmp(all->options->pure[i], function->name) == 0)
            return true;
    return false;
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

/* Adds the reads of a call that has no side effects, as an attribute, the user (`by_user`) or the
 * analysis of another file states. Adds a problem if only an attribute states it and the result may
 * depend on the thread. */
static void walk_pure_call(access_walk *w, const ir_node *call, bool by_user) {
    assert(call->kind == IR_CALL);
    const ir_function *function = call->children[0]->function;
    if (library_is_locale_table(call))
        return;
    /* another file defines the function, and its body was analysed there */
    const bool is_seen = external_kind(w->all->options, function) != EXPORTED_NOTHING;
    if (!by_user && !is_seen && library_depends_on_thread(function)) {
        const bool is_errno = strcmp(function->name, "__errno_location") == 0;
        access_problem_add(w, REASON_THREAD_STATE, call, is_errno ? "errno" : function->name);
        return;
    }
    if (!by_user && !is_seen && !library_is_same_in_threads(function)) {
        access_problem_add(w, REASON_UNSEEN_PURE, call, function->name);
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
    if (call->children[0]->function->linkage.is_renamed)
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

/* Are all globals in the lvalue declared before the call, so that the text at the call can name
 * them? */
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

/* The access's loops with the call's arguments substituted in their bounds. Clears is_exact if a
 * bound has side effects, or a global in it is not declared before the call. */
static const source_loop *loops_for_caller(access_walk *w, access *item, const ir_node *call) {
    assert(call->kind == IR_CALL && item->loop_count > 0);
    const ir_function *function = call->children[0]->function;
    source_loop *loops = ARENA_ARRAY(w->memory, source_loop, item->loop_count);
    for (unsigned i = 0; i < item->loop_count; i++) {
        loops[i] = item->loops[i];
        loops[i].lower = ir_substitute(w->memory, loops[i].lower, function, &call->children[1]);
        loops[i].bound = ir_substitute(w->memory, loops[i].bound, function, &call->children[1]);
        item->is_exact &=
            expression_is_plain(loops[i].lower) && expression_is_plain(loops[i].bound) &&
            is_declared_before(loops[i].lower, call) && is_declared_before(loops[i].bound, call);
    }
    return loops;
}

/* The bounds with the call's arguments substituted. NULL if one of them has side effects, or a
 * global in it is not declared before the call. */
static const element_bounds *bounds_for_caller(access_walk *w, const element_bounds *of,
                                               const ir_node *call) {
    const ir_function *function = call->children[0]->function;
    ir_node *const *arguments = &call->children[1];
    element_bounds *own = ARENA_NEW(w->memory, element_bounds);
    *own = *of;
    own->base = ir_substitute(w->memory, of->base, function, arguments);
    bool is_spelled = expression_is_plain(own->base) && is_declared_before(own->base, call);
    for (unsigned i = 0; i < of->term_count; i++) {
        const ir_node *value = of->terms[i].value;
        if (!value)
            continue;
        own->terms[i].value = value = ir_substitute(w->memory, value, function, arguments);
        is_spelled &= expression_is_plain(value) && is_declared_before(value, call);
    }
    for (unsigned i = 0; i < of->condition_count; i++) {
        const ir_node *value = ir_substitute(w->memory, of->conditions[i], function, arguments);
        own->conditions[i] = value;
        is_spelled &= expression_is_plain(value) && is_declared_before(value, call);
    }
    return is_spelled ? own : NULL;
}

/* The access of the called function, expressed by the caller's variables. */
static access access_for_caller(access_walk *w, access item, const ir_node *call) {
    arena *a = w->memory;
    const ir_function *function = call->children[0]->function;
    item.node = call;
    item.callee = function;
    if (!item.loop_count)
        item.is_behind = item.is_conditional;
    if (item.lvalue) {
        item.lvalue = ir_substitute(a, item.lvalue, function, &call->children[1]);
        item.is_exact = item.is_exact && expression_is_plain(item.lvalue) &&
                        is_declared_before(item.lvalue, call);
    }
    if (item.loop_count)
        item.loops = loops_for_caller(w, &item, call);
    if (item.bounds)
        item.bounds = bounds_for_caller(w, item.bounds, call);
    if (item.from) {
        item.from = ir_substitute(a, item.from, function, &call->children[1]);
        item.to = found_element(a, item.from, call);
    }
    return item;
}

static void walk_known_call(access_walk *w, const ir_node *call, const access_list *known) {
    const ir_function *function = call->children[0]->function;
    assert(call->kind == IR_CALL && function && function->body);
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
    for (unsigned i = 0; i < known->items.count; i++)
        access_add(w, access_for_caller(w, known->items.items[i], call));
    if (known->ends.count) {
        VECTOR_PUSH(w->memory, &w->list->ends, call);
        w->condition_depth++; /* never decreased, because the code after it may not be executed */
    }
}

/* ---- updates for reports --------------------------------------------------------------------- */

static void list_updates_of_call(access_walk *w, const ir_node *call, const access_vector *known) {
    for (unsigned i = 0; i < known->count && w->list->listed.count < LISTED_LIMIT; i++)
        if (is_listed(&known->items[i]))
            list_update(w->memory, w->list, access_for_caller(w, known->items[i], call));
}

/* Lists the updates of a called function with problems (known is NULL if it is recursive). */
static void list_known_call(access_walk *w, const ir_node *call, const access_list *known) {
    if (!known || call->child_count - 1 != call->children[0]->function->parameter_count)
        return;
    list_updates_of_call(w, call, &known->items);
    list_updates_of_call(w, call, &known->listed);
    if (known->atomic)
        w->list->atomic = known->atomic;
}

const char *access_walk_atomic(access_walk *w, const ir_node *node) {
    const char *name = atomic_name(w->memory, w->all->unit, node);
    const ir_node *target = name ? atomic_pointee(w->memory, node, 0) : NULL;
    if (name)
        w->list->atomic = name;
    if (target && expression_is_plain(target))
        list_update(w->memory, w->list,
                    (access){.kind = ACCESS_UPDATE,
                             .lvalue = target,
                             .is_exact = true,
                             .type = target->type,
                             .node = node});
    return name;
}

/* ---- all calls ------------------------------------------------------------------------------- */

static void walk_library_call(access_walk *w, const ir_node *call, const library_function *found) {
    if (ir_type_is_floating(call->type))
        w->list->has_floating_work = true;
    if (!found->is_exact)
        w->list->has_unrepeatable_work = true;
    if (found->sets_errno) {
        w->list->may_set_errno = true;
        w->list->errno_setter = call->children[0]->function->name;
    }
}

void access_walk_call(access_walk *w, const ir_node *call) {
    assert(call->kind == IR_CALL);
    const ir_node *callee = call->children[0];
    for (unsigned i = 1; i < call->child_count; i++)
        access_walk_node(w, call->children[i]);
    if (callee->kind != IR_FUNCTION) {
        access_problem_add(w, REASON_FUNCTION_POINTER, call, expression_text(w->memory, callee));
        return;
    }
    const ir_function *function = callee->function;
    const char *openmp = NULL;
    bool by_user = is_presumed_pure(w->all, function);
    const library_function *library = library_find(w->all->unit, function);
    access_walk_atomic(w, call);
    if (library_is_message_passing(function)) { /* takes precedence over what attributes and the
                                                 * user state */
        access_problem_add(w, REASON_MESSAGE_PASSING, call, function->name);
    } else if (function->is_noreturn) {
        access_problem_add(w, REASON_NO_RETURN, call,
                           access_is_assertion(function) ? "assert" : function->name);
    } else if (function->body && (openmp = text_openmp_in(w->memory, w->all->unit, function))) {
        /* the function might start another team of threads */
        access_problem_add(w, REASON_EXISTING_OPENMP, call,
                           arena_format(w->memory, "'%s', in '%s'", openmp, function->name));
        list_known_call(w, call, effects_of(w->all, function));
    } else if (function->body && !function->linkage.is_weak) {
        const access_list *known = effects_of(w->all, function);
        if (!known) {
            access_problem_add(w, REASON_RECURSION, call, function->name);
        } else if (known->problems.count && by_user) {
            walk_pure_call(w, call, true);
        } else if (known->problems.count) {
            access_problem_add(w, known->problems.items[0].why, call,
                               known->problems.items[0].name);
            list_known_call(w, call, known);
        } else {
            walk_known_call(w, call, known);
        }
    } else if (by_user) {
        walk_pure_call(w, call, true);
    } else if (library) {
        walk_library_call(w, call, library);
    } else if (is_const(w->all, function) || is_pure(w->all, function)) {
        walk_pure_call(w, call, false);
    } else if (function->linkage.is_interposable) {
        access_problem_add(w, REASON_INTERPOSED, call, function->name);
    } else if (!walk_memory_call(w, call)) {
        access_problem_add(w, REASON_IMPURE_CALL, call, function->name);
    }
}

void access_collect(effects *all, const ir_node *node, access_list *list) {
    access_walk walk = {all->memory, all, list, 0, false};
    access_walk_node(&walk, node);
}

void access_collect_known(effects *all, const ir_node *node, access_list *list) {
    access_collect(all, node, list);
    for (unsigned i = 0; i < list->listed.count; i++)
        VECTOR_PUSH(all->memory, &list->items, list->listed.items[i]);
    const ir_function *function = node->kind == IR_CALL ? ir_called_function(node) : NULL;
    const access_list *known =
        function && function->body && list->problems.count == 1 ? effects_of(all, function) : NULL;
    if (!known || !known->problems.count ||
        known->problems.items[0].why != list->problems.items[0].why)
        return;
    access_list every = {0};
    access_walk walk = {all->memory, all, &every, 0, false};
    walk_known_call(&walk, node, known);
    for (unsigned i = 0; i < every.items.count; i++)
        if (every.items.items[i].is_exact && !every.items.items[i].loop_count)
            VECTOR_PUSH(all->memory, &list->items, every.items.items[i]);
}
