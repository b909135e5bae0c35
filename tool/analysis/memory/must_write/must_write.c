/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/must_write/must_write.h"
#include "analysis/memory/must_write/must_write_run.h"

enum {
    MOST_STEPS = 2000000,   /* greatest number of steps of one query, which take some tens of
                             * milliseconds */
    MOST_BYTES = 1 << 16,   /* size of an object that can be analysed */
    PARAMETER_WINDOW = 4096 /* bytes after the target of a pointer parameter that are analysed */
};

must_write *must_write_new(arena *a, const ir_unit *unit, const analysis_options *options) {
    must_write *prover = ARENA_NEW(a, must_write);
    prover->arena = a;
    prover->unit = unit;
    prover->options = options;
    return prover;
}

static void begin_query(must_write *prover) {
    prover->scratch = arena_new();
    prover->steps = MOST_STEPS;
}

static void end_query(must_write *prover) {
    arena_free(prover->scratch);
    prover->scratch = NULL;
}

/* ---- objects that can be analysed ------------------------------------------------------------ */

static bool has_union_or_volatile(const ir_type *type) {
    if (type->is_volatile || type->is_atomic || type->kind == IR_OTHER_TYPE)
        return true;
    if (type->kind == IR_ARRAY)
        return has_union_or_volatile(type->target);
    if (type->kind != IR_RECORD)
        return false;
    if (type->record == NULL || type->record->is_union || !type->record->is_complete)
        return true;
    for (unsigned i = 0; i < type->record->field_count; i++)
        if (has_union_or_volatile(type->record->fields[i].type))
            return true;
    return false;
}

static const char *find_unfit(const ir_variable *variable) {
    if (variable->storage != IR_LOCAL && variable->storage != IR_PARAMETER)
        return "it is not a local variable";
    if (variable->function == NULL || variable->function->body == NULL)
        return "its function is not known";
    if (variable->storage == IR_PARAMETER && variable->type->kind == IR_ARRAY)
        return "it is the caller's array";
    if (variable->type->size <= 0)
        return "its size is not constant";
    if (variable->type->size > MOST_BYTES)
        return "it is too large to be analysed";
    return has_union_or_volatile(variable->type) ? "it is volatile, atomic or has a union" : NULL;
}

/* ---- its address outside the body ------------------------------------------------------------ */

typedef struct search {
    must_write *prover;
    const ir_node *body;
    const ir_node *loop; /* the loop of `body`, if control never returns to it after it has ended,
                          * so that the code after it is not searched; otherwise NULL */
    const ir_variable *variable;
    const ir_node *found;
} search;

static unsigned last_id(const ir_node *node) {
    while (node->child_count > 0)
        node = node->children[node->child_count - 1];
    return node->id;
}

/* The access path that starts at the variable's node, such as v, v[i] or v.m[i]. */
static const ir_node *access_path(const ir_node *node) {
    for (;;) {
        const ir_node *above = node->parent;
        const bool is_step = above != NULL && above->children[0] == node &&
                             ((above->kind == IR_INDEX && node->type->kind == IR_ARRAY) ||
                              (above->kind == IR_MEMBER && (above->flags & IR_ARROW) == 0) ||
                              (above->kind == IR_UNARY && above->op == IR_OP_DEREFERENCE &&
                               node->type->kind == IR_ARRAY));
        if (!is_step)
            return node;
        node = above;
    }
}

/* Is the access path that starts at this node used as an address that may be stored? */
static bool address_is_kept(search *find, const ir_node *node) {
    const ir_node *path = access_path(node);
    const ir_node *above = path->parent;
    const bool is_address_of =
        above != NULL && above->kind == IR_UNARY && above->op == IR_OP_ADDRESS;
    if (!is_address_of && path->type->kind != IR_ARRAY)
        return false;
    if (is_address_of)
        path = above;
    while (path->parent != NULL && path->parent->kind == IR_CAST &&
           path->parent->type->kind == IR_POINTER)
        path = path->parent;
    above = path->parent;
    if (above == NULL || above->kind != IR_CALL)
        return true;
    for (unsigned i = 1; i < above->child_count; i++)
        if (above->children[i] == path)
            return call_keeps_address(find->prover, above, i - 1, find->variable->type->size);
    return true;
}

static bool visit_outside(ir_node *node, void *context) {
    search *find = context;
    if (node == find->body || find->found != NULL)
        return false;
    if (find->loop != NULL && node->id > last_id(find->loop))
        return false;
    const bool is_unknown =
        node->kind == IR_OPAQUE && !ir_is_statement_expression(node) && !ir_is_lengths(node);
    if (is_unknown || (node->kind == IR_VARIABLE && node->variable == find->variable &&
                       address_is_kept(find, node)))
        find->found = node;
    return true;
}

static bool note_loop_back(ir_node *node, void *context) {
    bool *found = context;
    *found = *found || node->kind == IR_LABEL || node->kind == IR_GOTO;
    return true;
}

/* The loop of this body, if control never returns to it after it has ended; otherwise NULL. */
static const ir_node *loop_entered_once(const ir_node *body) {
    const ir_node *loop = body->parent;
    bool has_labels = false;
    if (loop == NULL || !ir_is_loop(loop))
        return NULL;
    const ir_node *top = loop;
    while (top->parent != NULL) {
        top = top->parent;
        if (ir_is_loop(top))
            return NULL;
    }
    ir_walk((ir_node *)top, note_loop_back, &has_labels);
    return has_labels ? NULL : loop;
}

static const ir_node *find_address_outside(must_write *prover, const ir_node *body,
                                           const ir_variable *variable) {
    search find = {prover, body, loop_entered_once(body), variable, NULL};
    ir_walk(variable->function->body, visit_outside, &find);
    return find.found;
}

bool address_kept_outside(must_write *prover, const ir_node *body, const ir_variable *variable) {
    return find_address_outside(prover, body, variable) != NULL;
}

/* ---- pointers that outlive the iteration ----------------------------------------------------- */

typedef struct mention {
    const ir_node *body;
    const ir_variable *variable;
    bool is_declared_in_body, is_outside, has_label;
} mention;

static bool note_mention(ir_node *node, void *context) {
    mention *m = context;
    if (node->kind == IR_LABEL && ir_contains(m->body, node))
        m->has_label = true;
    if (node->variable == m->variable && node->kind == IR_DECLARATOR && ir_contains(m->body, node))
        m->is_declared_in_body = true;
    if (node->variable == m->variable && node->kind == IR_VARIABLE && !ir_contains(m->body, node))
        m->is_outside = true;
    return true;
}

static mention find_mentions(const ir_node *body, const ir_variable *variable) {
    mention m = {body, variable, false, false, false};
    ir_walk(variable->function->body, note_mention, &m);
    return m;
}

/* Checks that no pointer into the private copy is used after the iteration. A pointer may remain in
 * a variable only if the body declares the variable, or no code outside of the body uses it. */
static bool pointers_end_inside(run *r, const ir_node *body, const state *s) {
    for (unsigned i = 0; i < s->bindings.count; i++)
        if (s->bindings.items[i].value.kind == VALUE_POINTER) {
            const mention m = find_mentions(body, s->bindings.items[i].variable);
            if (!m.is_declared_in_body && m.is_outside) {
                run_give_up(r, body, "a pointer to it is left behind");
                return false;
            }
        }
    return true;
}

/* ---- the analysis --------------------------------------------------------------------------- */

typedef struct constants {
    arena *arena;
    const ir_node *body;
    state *head;
} constants;

static bool bind_constant(ir_node *node, void *context) {
    constants *known = context;
    const ir_variable *variable = node->variable;
    if (node == known->body)
        return false;
    if (node->kind != IR_DECLARATOR || node->child_count == 0 || !variable->type->is_const ||
        variable->type->kind != IR_INTEGER || (node->children[0]->flags & IR_HAS_VALUE) == 0)
        return true;
    const value v = value_integer(node->children[0]->value, variable->type);
    state_set(known->arena, known->head, variable, v);
    return true;
}

/* Binds variables that are declared outside the body as constants, as in `const int dimension = 3`,
 * to their values. */
static void bind_constants(const run *r, const ir_node *body, state *head) {
    constants known = {r->prover->scratch, body, head};
    ir_walk(r->function->body, bind_constant, &known);
}

/* Interprets iterations until the values that one iteration leaves to the next no longer change.
 * Each iteration begins with no byte written. Returns the state at the end of an iteration. */
static state interpret_iterations(run *r, const ir_node *body) {
    arena *a = r->prover->scratch;
    state head = state_new(a, r->size);
    bind_constants(r, body, &head);
    for (;;) {
        state s = state_copy(a, &head), end = {.is_reachable = false};
        r->on_break = r->on_continue = &end;
        r->on_return = (state){.is_reachable = false};
        run_execute(r, &s, body);
        state_join(a, &s, &end);
        state_join(a, &s, &r->on_return);
        if (r->has_result && r->result.kind == VALUE_POINTER)
            run_give_up(r, body, "its address is returned");
        if (r->unknown != NULL || !s.is_reachable || !pointers_end_inside(r, body, &s))
            return s;
        state next = state_copy(a, &s);
        for (unsigned i = 0; i < next.written.word_count; i++)
            next.written.words[i] = 0;
        state_join(a, &next, &head);
        if (state_same_bindings(&next, &head))
            return s;
        head = next;
    }
}

static private_result unknown_result(const ir_node *node, const char *why) {
    const private_result result = {.verdict = PRIVATE_UNKNOWN, .node = node, .why = why};
    return result;
}

static private_result conclude(const run *r, const state *end) {
    private_result result = {.verdict = PRIVATE_PROVED};
    if (r->unknown != NULL)
        return unknown_result(r->unknown_node, r->unknown);
    result.is_written = !byte_set_is_empty(r->touched);
    if (r->read_node != NULL) {
        result.verdict = PRIVATE_READ_BEFORE_WRITE;
        result.node = r->read_node;
        result.why = "it may be read before the iteration has written it";
    }
    if (end->is_reachable) {
        byte_set whole = byte_set_new(r->prover->scratch, r->size);
        byte_set_add_value(whole, r->object->type, 0);
        result.assigned_at_end = byte_set_includes(end->written, whole);
    }
    return result;
}

private_result must_write_check(must_write *prover, const ir_node *body,
                                const ir_variable *variable) {
    const char *unfit = find_unfit(variable);
    if (unfit != NULL)
        return unknown_result(NULL, unfit);
    const mention m = find_mentions(body, variable);
    if (m.is_declared_in_body)
        return (private_result){.verdict = PRIVATE_PROVED, .is_written = true};
    if (m.has_label)
        return unknown_result(body, "labels and goto are not followed");
    begin_query(prover);
    private_result result;
    const ir_node *kept = find_address_outside(prover, body, variable);
    if (kept != NULL) {
        result = unknown_result(kept, "its address may be kept outside the loop");
    } else {
        const int64_t size = variable->type->size;
        run r = {.prover = prover,
                 .function = variable->function,
                 .object = variable,
                 .body = body,
                 .size = size,
                 .read = byte_set_new(prover->scratch, size),
                 .touched = byte_set_new(prover->scratch, size)};
        const state end = interpret_iterations(&r, body);
        result = conclude(&r, &end);
    }
    end_query(prover);
    return result;
}

/* May the function store the address, return it, or pass it to unknown code? The object's size, and
 * where in the object the address points, do not matter. */
static bool keeps_address(must_write *prover, const ir_function *function, unsigned index) {
    value *arguments = ARENA_ARRAY(prover->scratch, value, function->parameter_count);
    arguments[index] = (value){VALUE_POINTER, false, 0};
    const call_summary *summary =
        summarise_call(prover, function, 1, false, function->parameter_count, arguments, 0);
    return summary->unknown != NULL || summary->result.kind == VALUE_POINTER;
}

parameter_effect must_write_parameter(must_write *prover, const ir_function *function,
                                      unsigned index) {
    parameter_effect effect = {.keeps_address = true, .is_known = false};
    if (index >= function->parameter_count || function->body == NULL || function->linkage.is_weak)
        return effect;
    begin_query(prover);
    effect.keeps_address = keeps_address(prover, function, index);
    value *arguments = ARENA_ARRAY(prover->scratch, value, function->parameter_count + 1);
    arguments[index] = (value){VALUE_POINTER, true, 0};
    const call_summary *summary = summarise_call(prover, function, PARAMETER_WINDOW, true,
                                                 function->parameter_count, arguments, 0);
    if (summary->unknown == NULL && summary->result.kind != VALUE_POINTER) {
        const int64_t read_end = byte_set_end(summary->read);
        byte_set range = byte_set_new(prover->scratch, PARAMETER_WINDOW);
        effect.is_known = true;
        effect.end = byte_set_end(summary->touched);
        effect.end = read_end > effect.end ? read_end : effect.end;
        effect.may_read = read_end > 0;
        effect.may_write = !byte_set_is_empty(summary->touched);
        byte_set_add(range, 0, effect.end);
        effect.writes_all = byte_set_includes(summary->written, range);
    }
    end_query(prover);
    return effect;
}
