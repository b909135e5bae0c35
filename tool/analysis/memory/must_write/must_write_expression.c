/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include <assert.h>
#include <string.h>

#include "analysis/memory/must_write/must_write_run.h"

const value value_other = {VALUE_OTHER, false, 0};

value run_give_up(run *r, const ir_node *node, const char *why) {
    assert(why);
    if (r->unknown == NULL) {
        r->unknown = why;
        r->unknown_node = node;
    }
    return value_other;
}

bool run_step(run *r, const ir_node *node, unsigned steps) {
    if (r->unknown != NULL)
        return false;
    if (r->prover->steps < steps) {
        r->prover->steps = 0;
        run_give_up(r, node, "the proof would take too long");
        return false;
    }
    r->prover->steps -= steps;
    return true;
}

static unsigned set_weight(const run *r) {
    return 1 + (unsigned)(r->size / 64);
}

void run_read_set(run *r, const state *s, const ir_node *node, byte_set bytes) {
    byte_set_subtract(bytes, s->written);
    if (!byte_set_is_empty(bytes) && r->read_node == NULL)
        r->read_node = node;
    byte_set_unite(r->read, bytes);
}

void run_read(run *r, const state *s, const ir_node *node, int64_t begin, int64_t end) {
    if (!run_step(r, node, 1) || byte_set_has(s->written, begin, end) ||
        !run_step(r, node, set_weight(r)))
        return;
    byte_set bytes = byte_set_new(r->prover->scratch, r->size);
    byte_set_add(bytes, begin, end);
    run_read_set(r, s, node, bytes);
}

void run_write(run *r, state *s, const ir_node *node, int64_t begin, int64_t end, bool is_exact) {
    if (!run_step(r, node, 1 + (unsigned)((end - begin) / 64)))
        return;
    byte_set_add(r->touched, begin, end);
    if (is_exact)
        byte_set_add(s->written, begin, end);
}

/* ---- operands in unspecified order ----------------------------------------------------------- */

typedef struct effect_search {
    bool is_found;
    unsigned visits;
} effect_search;

static bool note_effect(ir_node *node, void *context) {
    effect_search *search = context;
    search->visits++;
    if (node->kind == IR_ASSIGN || node->kind == IR_CALL || node->kind == IR_OPAQUE ||
        ir_is_increment(node))
        search->is_found = true;
    return !search->is_found;
}

bool run_has_effects(run *r, const ir_node *node) {
    effect_search search = {false, 0};
    ir_walk((ir_node *)node, note_effect, &search);
    run_step(r, node, search.visits / 4);
    return search.is_found;
}

unsequenced run_begin_unsequenced(run *r, const state *s, const ir_node *node,
                                  ir_node *const *operands, unsigned count) {
    unsequenced u = {0};
    unsigned with_effects = 0;
    for (unsigned i = 0; i < count; i++)
        with_effects += run_has_effects(r, operands[i]);
    u.is_needed = count > 1 && with_effects > 0 && run_step(r, node, 3 * set_weight(r));
    if (u.is_needed) {
        u.before = byte_set_copy(r->prover->scratch, s->written);
        u.all = byte_set_copy(r->prover->scratch, s->written);
    }
    return u;
}

void run_next_unsequenced(unsequenced *u, state *s) {
    if (u->is_needed) {
        byte_set_unite(u->all, s->written);
        byte_set_assign(s->written, u->before);
    }
}

void run_end_unsequenced(unsequenced *u, state *s) {
    run_next_unsequenced(u, s);
    if (u->is_needed)
        byte_set_assign(s->written, u->all);
}

/* ---- expressions --------------------------------------------------------------------------- */

static value evaluate_assignment(run *r, state *s, const ir_node *node) {
    const ir_node *target = node->children[0];
    value old = value_other;
    unsequenced u = run_begin_unsequenced(r, s, node, node->children, 2);
    const place p = run_locate(r, s, target);
    if (node->op != IR_OP_NONE)
        old = run_load(r, s, target, &p);
    run_next_unsequenced(&u, s);
    value v = run_evaluate(r, s, node->children[1]);
    run_end_unsequenced(&u, s);
    if (node->op != IR_OP_NONE) {
        /* the tree has only the target's type, not the type in which C computes the result */
        const ir_node sum = {.op = node->op,
                             .type = target->type,
                             .children = node->children,
                             .child_count = node->child_count};
        v = value_combine(&sum, old, v);
    }
    return run_store(r, s, target, &p, v);
}

static value evaluate_increment(run *r, state *s, const ir_node *node) {
    const ir_node *target = node->children[0];
    const bool is_down = node->op == IR_OP_PRE_DECREMENT || node->op == IR_OP_POST_DECREMENT;
    const bool is_post = node->op == IR_OP_POST_INCREMENT || node->op == IR_OP_POST_DECREMENT;
    const value one = {VALUE_INTEGER, true, 1};
    const place p = run_locate(r, s, target);
    const value old = run_load(r, s, target, &p);
    value v = value_other;
    int64_t number;
    if (old.kind == VALUE_POINTER)
        v = value_move(old, one, value_pointee_size(target->type), is_down);
    else if (old.kind == VALUE_INTEGER && target->type->kind == IR_INTEGER &&
             value_compute(is_down ? IR_OP_SUBTRACT : IR_OP_ADD, old.number, 1, &number))
        v = value_integer(number, target->type);
    v = run_store(r, s, target, &p, v);
    return is_post ? old : v;
}

static value evaluate_unary(run *r, state *s, const ir_node *node) {
    const ir_node *operand = node->children[0];
    value v = value_other;
    place p;
    switch (node->op) {
    case IR_OP_PRE_INCREMENT:
    case IR_OP_PRE_DECREMENT:
    case IR_OP_POST_INCREMENT:
    case IR_OP_POST_DECREMENT:
        return evaluate_increment(r, s, node);
    case IR_OP_ADDRESS:
        p = run_locate(r, s, operand);
        if (p.variable != NULL) /* the variable could then change through the pointer */
            return run_give_up(r, node, "the address of a variable is taken");
        if (p.kind == PLACE_OBJECT) {
            v.kind = VALUE_POINTER;
            v.is_exact = p.is_exact;
            v.number = p.is_exact ? p.offset : 0;
        }
        return v;
    case IR_OP_DEREFERENCE:
    case IR_OP_REAL:
    case IR_OP_IMAG:
        p = run_locate(r, s, node);
        return run_load(r, s, node, &p);
    default:
        v = run_evaluate(r, s, operand);
        if (v.kind != VALUE_INTEGER)
            return value_other;
        if (node->op == IR_OP_MINUS && v.number != INT64_MIN)
            return value_integer(-v.number, node->type);
        if (node->op == IR_OP_NOT)
            return value_integer(v.number == 0, node->type);
        return node->op == IR_OP_PLUS ? value_integer(v.number, node->type) : value_other;
    }
}

/* Evaluates a && b or a || b; b may be skipped. */
static value evaluate_short_circuit(run *r, state *s, const ir_node *node) {
    const bool is_and = node->op == IR_OP_AND;
    const value left = run_evaluate(r, s, node->children[0]);
    if (left.kind == VALUE_INTEGER && (left.number == 0) == is_and)
        return value_integer(!is_and, node->type);
    if (left.kind == VALUE_INTEGER) {
        const value right = run_evaluate(r, s, node->children[1]);
        return right.kind == VALUE_INTEGER ? value_integer(right.number != 0, node->type)
                                           : value_other;
    }
    if (!run_step(r, node, 2 * state_weight(s)))
        return value_other;
    const state without = state_copy(r->prover->scratch, s);
    run_evaluate(r, s, node->children[1]);
    state_join(r->prover->scratch, s, &without);
    return value_other;
}

static value evaluate_binary(run *r, state *s, const ir_node *node) {
    if (node->op == IR_OP_AND || node->op == IR_OP_OR)
        return evaluate_short_circuit(r, s, node);
    if (node->op == IR_OP_COMMA) {
        run_discard(r, s, node->children[0]);
        return run_evaluate(r, s, node->children[1]);
    }
    /* Chains such as a + b + c nest on the left and may be long, so only the right operand is
     * searched for effects. If it has none, it is evaluated first: its reads must not rely on
     * writes of the left operand. */
    if (!run_has_effects(r, node->children[1])) {
        const value right = run_evaluate(r, s, node->children[1]);
        return value_combine(node, run_evaluate(r, s, node->children[0]), right);
    }
    unsequenced u = run_begin_unsequenced(r, s, node, node->children, 2);
    const value left = run_evaluate(r, s, node->children[0]);
    run_next_unsequenced(&u, s);
    const value right = run_evaluate(r, s, node->children[1]);
    run_end_unsequenced(&u, s);
    return value_combine(node, left, right);
}

static value evaluate_conditional(run *r, state *s, const ir_node *node) {
    const value condition = run_evaluate(r, s, node->children[0]);
    if (condition.kind == VALUE_INTEGER) {
        const value v = run_evaluate(r, s, node->children[condition.number != 0 ? 1 : 2]);
        return v.kind == VALUE_INTEGER ? value_integer(v.number, node->type) : v;
    }
    if (!run_step(r, node, 2 * state_weight(s)))
        return value_other;
    state other = state_copy(r->prover->scratch, s);
    const value first = run_evaluate(r, s, node->children[1]);
    const value second = run_evaluate(r, &other, node->children[2]);
    state_join(r->prover->scratch, s, &other);
    const value joined = value_join(first, second);
    return joined.kind == VALUE_INTEGER ? value_integer(joined.number, node->type) : joined;
}

static void evaluate_initialisers(run *r, state *s, const ir_node *node) {
    unsequenced u = run_begin_unsequenced(r, s, node, node->children, node->child_count);
    for (unsigned i = 0; i < node->child_count; i++) {
        if (i > 0)
            run_next_unsequenced(&u, s);
        run_evaluate_closed(r, s, node->children[i]);
    }
    run_end_unsequenced(&u, s);
}

value run_evaluate(run *r, state *s, const ir_node *node) {
    place p;
    if (!run_step(r, node, 1))
        return value_other;
    if ((node->flags & IR_HAS_VALUE) != 0 && node->type != NULL)
        return value_integer(node->value, node->type);
    switch (node->kind) {
    case IR_NUMBER:
    case IR_STRING:
    case IR_FUNCTION:
        return value_other;
    case IR_VARIABLE:
    case IR_INDEX:
    case IR_MEMBER:
        p = run_locate(r, s, node);
        return run_load(r, s, node, &p);
    case IR_UNARY:
        return evaluate_unary(r, s, node);
    case IR_BINARY:
        return evaluate_binary(r, s, node);
    case IR_ASSIGN:
        return evaluate_assignment(r, s, node);
    case IR_CONDITIONAL:
        return evaluate_conditional(r, s, node);
    case IR_CALL:
        return run_call(r, s, node);
    case IR_CAST:
        run_check_hidden(r, s, node, node->type);
        if (node->type->kind == IR_VOID) {
            run_discard(r, s, node->children[0]);
            return value_other;
        }
        return run_convert(r, node, run_evaluate(r, s, node->children[0]), node->type);
    case IR_SIZEOF:
        run_check_hidden(r, s, node, NULL);
        return value_other;
    case IR_INITIALIZERS:
        if ((node->flags & IR_COMPOUND_LITERAL) != 0)
            run_check_hidden(r, s, node, node->type);
        evaluate_initialisers(r, s, node);
        return value_other;
    default:
        return run_give_up(r, node, "it contains a construct that is not understood");
    }
}

void run_discard(run *r, state *s, const ir_node *node) {
    switch (node->kind) {
    case IR_VARIABLE:
    case IR_INDEX:
    case IR_MEMBER:
        run_locate(r, s, node);
        break;
    default:
        run_evaluate(r, s, node);
    }
}

void run_evaluate_closed(run *r, state *s, const ir_node *node) {
    if (run_evaluate(r, s, node).kind == VALUE_POINTER)
        run_give_up(r, node, "its address is stored");
}

void run_initialise(run *r, state *s, const ir_node *declarator) {
    ir_variable *variable = declarator->variable;
    const ir_node *initial = ir_child(declarator, 0);
    assert(declarator->kind == IR_DECLARATOR);
    value v = value_other;
    if (!run_step(r, declarator, 1))
        return;
    run_check_hidden(r, s, declarator, variable->type);
    if (variable->storage != IR_LOCAL)
        return; /* the initialiser of a static variable is constant */
    if (initial != NULL && ir_is_lengths(initial)) {
        for (unsigned i = 0; i < initial->child_count; i++)
            run_evaluate_closed(r, s, initial->children[i]);
        return;
    }
    if (initial != NULL) {
        if (initial->kind == IR_INITIALIZERS && (initial->flags & IR_COMPOUND_LITERAL) == 0)
            evaluate_initialisers(r, s, initial);
        else
            v = run_evaluate(r, s, initial);
    }
    const place p = run_variable_place(r, variable);
    if (initial == NULL) {
        if (p.variable != NULL)
            state_set(r->prover->scratch, s, variable, value_other);
        return;
    }
    ir_node target = {.kind = IR_VARIABLE,
                      .type = variable->type,
                      .variable = variable,
                      .range = declarator->range};
    if (v.kind == VALUE_POINTER && (p.variable == NULL || variable->type->kind != IR_POINTER)) {
        run_give_up(r, declarator, "its address is stored");
        return;
    }
    if (p.kind == PLACE_OBJECT || p.variable != NULL)
        run_store(r, s, &target, &p, v);
}

/* ---- C text that the tree does not show ------------------------------------------------------ */

static bool is_word_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           (unsigned char)c >= 128;
}

static bool text_mentions(const char *text, size_t length, const char *word) {
    const size_t size = strlen(word);
    for (size_t i = 0; i + size <= length; i++)
        if (memcmp(text + i, word, size) == 0 && (i == 0 || !is_word_character(text[i - 1])) &&
            (i + size == length || !is_word_character(text[i + size])))
            return true;
    return false;
}

void run_check_hidden(run *r, const state *s, const ir_node *node, const ir_type *type) {
    static const char why[] = "the size of a type may depend on it";
    const source *text = r->prover->unit->source;
    if (type != NULL && !ir_type_is_variably_modified(type))
        return;
    if (r->object == NULL || text == NULL || node->range.begin >= node->range.end ||
        node->range.end > text->length || (node->flags & IR_FROM_MACRO) != 0) {
        run_give_up(r, node, why);
        return;
    }
    const char *begin = text->text + node->range.begin;
    const size_t length = node->range.end - node->range.begin;
    const bool is_object_declared_here = node->kind == IR_DECLARATOR && node->variable == r->object;
    if (type != NULL && memchr(begin, '[', length) == NULL)
        run_give_up(r, node, why); /* the length is hidden in a typedef */
    if (!is_object_declared_here && text_mentions(begin, length, r->object->name))
        run_give_up(r, node, why);
    for (unsigned i = 0; i < s->bindings.count; i++)
        if (s->bindings.items[i].value.kind == VALUE_POINTER &&
            text_mentions(begin, length, s->bindings.items[i].variable->name))
            run_give_up(r, node, why);
}
