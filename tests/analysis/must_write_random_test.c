/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The must-write proof is compared with executions. Random loop bodies over an array f of four
 * doubles are analysed, then executed many times with random data, in every order of operands that C
 * permits. Every proved property must hold in every execution.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <string.h>

#include "analysis/memory/must_write/must_write.h"
#include "ir_reader/ir_read.h"

enum { PROGRAMS = 4000, EXECUTIONS = 40, ELEMENTS = 4, MOST_STEPS = 4000, MOST_DEPTH = 3 };

static uint64_t random_state;

static unsigned below(unsigned n) {
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (unsigned)(random_state >> 33) % n;
}

/* ---- random bodies --------------------------------------------------------------------------- */

typedef struct generator {
    buffer out;
    unsigned names;
    unsigned counters[16], counter_count; /* enclosing loops' counters, innermost last */
    unsigned pointers[16], pointer_count;
    unsigned loops; /* number of enclosing loops inside the analysed one */
} generator;

static void say(generator *g, const char *text) {
    buffer_text(&g->out, text);
}

static void known_subscript(generator *g) {
    if (g->counter_count == 0 || below(3) == 0)
        buffer_format(&g->out, "%u", below(ELEMENTS));
    else if (below(3) == 0)
        buffer_format(&g->out, "(%% (+ (* c%u %u) %u) 4)", g->counters[below(g->counter_count)],
                      1 + below(3), below(4));
    else
        buffer_format(&g->out, "c%u", g->counters[below(g->counter_count)]);
}

static void subscript(generator *g) {
    if (below(8) == 0)
        say(g, "(& (index s t) 3)");
    else
        known_subscript(g);
}

static void pointer(generator *g) {
    switch (below(4)) {
    case 0:
        say(g, "f");
        break;
    case 1:
        say(g, "(& (index f ");
        subscript(g);
        say(g, "))");
        break;
    case 2:
        if (g->pointer_count > 0) {
            buffer_format(&g->out, "p%u", g->pointers[below(g->pointer_count)]);
            break;
        }
        /* fall through */
    default:
        say(g, "(call at f ");
        subscript(g);
        say(g, ")");
    }
}

static void place(generator *g) {
    if (g->pointer_count > 0 && below(4) == 0) {
        buffer_format(&g->out, "(index p%u %u)", g->pointers[below(g->pointer_count)], below(3));
    } else if (below(8) == 0) {
        say(g, "(* ");
        pointer(g);
        say(g, ")");
    } else {
        say(g, "(index f ");
        subscript(g);
        say(g, ")");
    }
}

static void expression(generator *g, unsigned depth);

static void call(generator *g) {
    static const char *const names[] = {"put", "get", "maybe", "fill", "swap"};
    const unsigned which = below(5);
    buffer_format(&g->out, "(call %s ", names[which]);
    pointer(g);
    say(g, " ");
    if (which == 4)
        pointer(g);
    else if (which == 2)
        say(g, "s");
    else
        known_subscript(g);
    say(g, ")");
}

static void two(generator *g, const char *op, unsigned depth) {
    buffer_format(&g->out, "(%s ", op);
    expression(g, depth + 1);
    say(g, " ");
    expression(g, depth + 1);
    say(g, ")");
}

static void condition(generator *g, unsigned depth) {
    if (g->counter_count > 0 && below(3) == 0) {
        buffer_format(&g->out, "(< c%u %u)", g->counters[below(g->counter_count)], below(5));
    } else if (depth < MOST_DEPTH && below(4) == 0) {
        say(g, below(2) ? "(&& " : "(|| ");
        condition(g, depth + 1);
        say(g, " (> ");
        expression(g, depth + 1);
        say(g, " 0.5))");
    } else {
        say(g, "(> (index s t) 0)");
    }
}

static void assignment(generator *g, unsigned depth) {
    say(g, below(4) == 0 ? "(+= " : "(= ");
    place(g);
    say(g, " ");
    expression(g, depth + 1);
    say(g, ")");
}

static void expression(generator *g, unsigned depth) {
    switch (depth > MOST_DEPTH ? 0 : below(9)) {
    case 0:
    case 1:
    case 2:
        say(g, "1.5");
        break;
    case 3:
        place(g);
        break;
    case 4:
        two(g, "+", depth);
        break;
    case 5:
        call(g);
        break;
    case 6:
        assignment(g, depth);
        break;
    case 7:
        say(g, "(conditional ");
        condition(g, depth + 1);
        say(g, " ");
        expression(g, depth + 1);
        say(g, " ");
        expression(g, depth + 1);
        say(g, ")");
        break;
    default:
        two(g, ",", depth);
    }
}

static void statement(generator *g, unsigned depth);

static void block(generator *g, unsigned depth) {
    const unsigned pointers = g->pointer_count;
    say(g, "(block ");
    for (unsigned i = 1 + below(3); i > 0; i--)
        statement(g, depth + 1);
    say(g, ")");
    g->pointer_count = pointers;
}

static void loop(generator *g, unsigned depth) {
    const unsigned counter = g->names++;
    const unsigned kind = below(4);
    if (kind < 2) {
        buffer_format(&g->out, "(for (declaration (declarator c%u int %u)) (< c%u ", counter,
                      below(2), counter);
        say(g, kind == 0 ? "4" : "(& (index s t) 3)");
        buffer_format(&g->out, ") (_++ c%u) ", counter);
    } else {
        buffer_format(&g->out, "(declaration (declarator c%u int %u))", counter, 1 + below(4));
        if (kind == 2)
            buffer_format(&g->out, "(while (> (_-- c%u) 0) ", counter);
        else
            say(g, "(do ");
    }
    g->counters[g->counter_count++] = counter;
    g->loops++;
    block(g, depth + 1);
    g->loops--;
    g->counter_count--;
    if (kind == 3)
        buffer_format(&g->out, " (> (--_ c%u) 0)", counter);
    say(g, ")");
}

static void choice(generator *g, unsigned depth) {
    say(g, "(switch (& (index s t) 3) (block ");
    for (unsigned i = 0; i < 3; i++) {
        if (i == 2 && below(2))
            say(g, "(default ");
        else
            buffer_format(&g->out, "(case %u ", i);
        block(g, depth + 1);
        say(g, below(2) ? ") (break)" : ")");
    }
    say(g, "))");
}

static void new_pointer(generator *g) {
    const unsigned name = g->names++;
    if (g->pointer_count == 16)
        return;
    buffer_format(&g->out, "(declaration (declarator p%u ptr(double) ", name);
    pointer(g);
    say(g, "))");
    g->pointers[g->pointer_count++] = name;
}

static void move_pointer(generator *g) {
    if (g->pointer_count > 0)
        buffer_format(&g->out, "(_++ p%u)", g->pointers[below(g->pointer_count)]);
}

static void statement(generator *g, unsigned depth) {
    switch (depth > MOST_DEPTH ? below(4) : below(12)) {
    case 0:
    case 1:
    case 2:
    case 3:
        assignment(g, 1);
        break;
    case 4:
        say(g, "(= g ");
        expression(g, 0);
        say(g, ")");
        break;
    case 5:
        new_pointer(g);
        break;
    case 6:
        say(g, "(if ");
        condition(g, 0);
        say(g, below(4) == 0 ? " (continue))" : g->loops > 0 && below(3) == 0 ? " (break))" : " ");
        if (g->out.data[g->out.length - 1] == ')')
            break;
        block(g, depth + 1);
        if (below(2))
            block(g, depth + 1);
        say(g, ")");
        break;
    case 7:
    case 8:
    case 9:
        loop(g, depth);
        break;
    case 10:
        choice(g, depth);
        break;
    default:
        move_pointer(g);
        call(g);
    }
}

static void generate(generator *g) {
    say(g, "(unit \"random.c\"\n"
           "(function put double !static (parameter p ptr(double)) (parameter i int)"
           " (block (= (index p i) 2.5) (return 1.0)))\n"
           "(function get double !static (parameter p ptr(double)) (parameter i int)"
           " (block (return (index p i))))\n"
           "(function maybe double !static (parameter p ptr(double)) (parameter s ptr(int))"
           " (block (if (> (index s 0) 0) (return 0.5)) (= (* p) 1.5) (return 1.5)))\n"
           "(function fill double !static (parameter p ptr(double)) (parameter n int)"
           " (block (for (declaration (declarator c int 0)) (< c n) (_++ c) (= (index p c) 0.5))"
           " (return 0.5)))\n"
           "(function swap double !static (parameter a ptr(double)) (parameter b ptr(double))"
           " (block (declaration (declarator c double (* a))) (= (* a) (* b)) (= (* b) c)"
           " (return c)))\n"
           "(function at ptr(double) !static (parameter p ptr(double)) (parameter i int)"
           " (block (return (+ p i))))\n"
           "(function judged void (parameter n int) (parameter s ptr(int)) (block"
           " (declaration (declarator f array(4,double))) (declaration (declarator g double))"
           " (for (declaration (declarator t int 0)) (< t n) (_++ t) (block ");
    for (unsigned i = 2 + below(4); i > 0; i--)
        statement(g, 0);
    say(g, ")))))");
}

/* ---- execution ------------------------------------------------------------------------------- */

typedef struct number {
    enum { PLAIN, INTO_F, INTO_S } kind;
    double value; /* the number; for a pointer (INTO_F, INTO_S) the index of its element */
} number;

typedef enum exit_kind { EXIT_NONE, EXIT_BREAK, EXIT_CONTINUE, EXIT_RETURN } exit_kind;

typedef struct machine {
    unsigned steps;
    bool is_undefined; /* the program left the array, or ran too long: its execution shows nothing */
    bool has_read_early;
    bool written[ELEMENTS];
    number *variables; /* variables of the current function, by id */
    unsigned variable_count;
    const ir_variable *f;
    number result;
} machine;

static number run_expression(machine *m, const ir_node *node);
static exit_kind run_statement(machine *m, const ir_node *node);

static number plain(double value) {
    const number n = {PLAIN, value};
    return n;
}

static int element_of(machine *m, number pointer) {
    if (pointer.kind == PLAIN || pointer.value < 0 ||
        (pointer.kind == INTO_F && pointer.value >= (double)ELEMENTS)) {
        m->is_undefined = true;
        return 0;
    }
    return (int)pointer.value;
}

/* Returns the address of an lvalue in memory, with its operands evaluated in a random order. */
static number address(machine *m, const ir_node *node) {
    if (node->kind == IR_INDEX) {
        const bool is_other_order = below(2);
        const number second = is_other_order ? run_expression(m, node->children[1]) : plain(0);
        number base = run_expression(m, node->children[0]);
        base.value += is_other_order ? second.value : run_expression(m, node->children[1]).value;
        return base;
    }
    return run_expression(m, node->children[0]); /* *p */
}

static number get(machine *m, number at) {
    const int element = element_of(m, at);
    if (at.kind == INTO_S)
        return plain((double)below(9) - 3);
    if (!m->is_undefined && !m->written[element])
        m->has_read_early = true;
    return plain((double)below(4) / 2);
}

static void put(machine *m, number at) {
    const int element = element_of(m, at);
    if (!m->is_undefined)
        m->written[element] = true;
}

static number run_call(machine *m, const ir_node *node) {
    const ir_function *function = node->children[0]->function;
    number arguments[2], variables[256] = {{PLAIN, 0}};
    const bool is_other_order = below(2);
    for (unsigned i = 0; i < 2; i++) {
        const unsigned which = is_other_order ? 1 - i : i;
        arguments[which] = run_expression(m, node->children[1 + which]);
    }
    number *const outer = m->variables;
    m->variables = variables;
    for (unsigned i = 0; i < 2; i++)
        variables[function->parameters[i]->id] = arguments[i];
    run_statement(m, function->body);
    m->variables = outer;
    return m->result;
}

static number run_assignment(machine *m, const ir_node *node) {
    const ir_node *target = node->children[0];
    if (target->kind == IR_VARIABLE) {
        const number value = run_expression(m, node->children[1]);
        m->variables[target->variable->id] = value;
        return value;
    }
    number at = {INTO_F, 0}, value = plain(0);
    const bool is_value_first = below(2);
    if (is_value_first)
        value = run_expression(m, node->children[1]);
    at = address(m, target);
    if (node->op != IR_OP_NONE)
        get(m, at);
    if (!is_value_first)
        value = run_expression(m, node->children[1]);
    put(m, at);
    return value;
}

static number run_increment(machine *m, const ir_node *node) {
    number *variable = &m->variables[node->children[0]->variable->id];
    const number old = *variable;
    const bool is_up = node->op == IR_OP_POST_INCREMENT || node->op == IR_OP_PRE_INCREMENT;
    variable->value += is_up ? 1 : -1;
    return node->op == IR_OP_PRE_DECREMENT ? *variable : old;
}

static number run_unary(machine *m, const ir_node *node) {
    switch (node->op) {
    case IR_OP_DEREFERENCE:
        return get(m, address(m, node));
    case IR_OP_ADDRESS:
        return address(m, node->children[0]);
    default:
        return run_increment(m, node);
    }
}

/* Evaluates an expression whose value is discarded; an lvalue is not read. */
static void run_discarded(machine *m, const ir_node *node) {
    if (node->kind == IR_INDEX)
        address(m, node);
    else
        run_expression(m, node);
}

static number run_binary(machine *m, const ir_node *node) {
    number left, right;
    if (node->op == IR_OP_AND || node->op == IR_OP_OR) {
        left = run_expression(m, node->children[0]);
        if ((left.value != 0) != (node->op == IR_OP_AND))
            return plain(left.value != 0);
        return plain(run_expression(m, node->children[1]).value != 0);
    }
    if (node->op == IR_OP_COMMA) {
        run_discarded(m, node->children[0]);
        return run_expression(m, node->children[1]);
    }
    if (below(2)) {
        left = run_expression(m, node->children[0]);
        right = run_expression(m, node->children[1]);
    } else {
        right = run_expression(m, node->children[1]);
        left = run_expression(m, node->children[0]);
    }
    switch (node->op) {
    case IR_OP_ADD:
        left.value += right.value;
        return left;
    case IR_OP_MULTIPLY:
        return plain(left.value * right.value);
    case IR_OP_REMAINDER:
        return plain((double)((int)left.value % (int)right.value));
    case IR_OP_BIT_AND:
        return plain((double)((int)left.value & (int)right.value));
    case IR_OP_LESS:
        return plain(left.value < right.value);
    default:
        return plain(left.value > right.value);
    }
}

static number run_expression(machine *m, const ir_node *node) {
    const number none = {PLAIN, 0}, into_f = {INTO_F, 0}, into_s = {INTO_S, 0};
    if (m->is_undefined || ++m->steps > MOST_STEPS) {
        m->is_undefined = true;
        return none;
    }
    switch (node->kind) {
    case IR_NUMBER:
        return plain((node->flags & IR_HAS_VALUE) != 0 ? (double)node->value : 1.5);
    case IR_VARIABLE:
        if (node->variable == m->f)
            return into_f;
        if (strcmp(node->variable->name, "s") == 0)
            return into_s;
        return m->variables[node->variable->id];
    case IR_INDEX:
        return get(m, address(m, node));
    case IR_UNARY:
        return run_unary(m, node);
    case IR_BINARY:
        return run_binary(m, node);
    case IR_ASSIGN:
        return run_assignment(m, node);
    case IR_CONDITIONAL:
        return run_expression(
            m, node->children[run_expression(m, node->children[0]).value != 0 ? 1 : 2]);
    case IR_CALL:
        return run_call(m, node);
    default:
        fail_msg("a kind of expression that is not generated: %d", (int)node->kind);
        return none;
    }
}

static exit_kind run_loop(machine *m, const ir_node *node) {
    const bool is_for = node->kind == IR_FOR, is_do = node->kind == IR_DO;
    const ir_node *condition = node->children[is_for || is_do ? 1 : 0];
    const ir_node *body = node->children[is_for ? 3 : is_do ? 0 : 1];
    if (is_for)
        run_statement(m, node->children[0]);
    for (bool is_first = is_do; !m->is_undefined; is_first = false) {
        if (!is_first && run_expression(m, condition).value == 0)
            break;
        const exit_kind left = run_statement(m, body);
        if (left == EXIT_BREAK)
            break;
        if (left == EXIT_RETURN)
            return left;
        if (is_for)
            run_expression(m, node->children[2]);
    }
    return EXIT_NONE;
}

static exit_kind run_switch(machine *m, const ir_node *node) {
    const int value = (int)run_expression(m, node->children[0]).value;
    const ir_node *body = node->children[1];
    bool is_entered = false;
    for (unsigned i = 0; i < body->child_count; i++) {
        const ir_node *item = body->children[i];
        if (item->kind == IR_CASE && item->children[0]->value == value)
            is_entered = true;
        if (item->kind == IR_DEFAULT)
            is_entered = true;
        if (!is_entered)
            continue;
        const bool is_labelled = item->kind == IR_CASE || item->kind == IR_DEFAULT;
        const exit_kind left =
            run_statement(m, is_labelled ? item->children[item->child_count - 1] : item);
        if (left != EXIT_NONE)
            return left == EXIT_BREAK ? EXIT_NONE : left;
    }
    return EXIT_NONE;
}

static exit_kind run_statement(machine *m, const ir_node *node) {
    exit_kind left = EXIT_NONE;
    switch (node->kind) {
    case IR_BLOCK:
    case IR_DECLARATION:
        for (unsigned i = 0; i < node->child_count && left == EXIT_NONE; i++)
            left = run_statement(m, node->children[i]);
        return left;
    case IR_DECLARATOR:
        m->variables[node->variable->id] = run_expression(m, node->children[0]);
        return EXIT_NONE;
    case IR_EXPRESSION:
        run_discarded(m, node->children[0]);
        return EXIT_NONE;
    case IR_IF:
        if (run_expression(m, node->children[0]).value != 0)
            return run_statement(m, node->children[1]);
        return node->child_count > 2 ? run_statement(m, node->children[2]) : EXIT_NONE;
    case IR_FOR:
    case IR_WHILE:
    case IR_DO:
        return run_loop(m, node);
    case IR_SWITCH:
        return run_switch(m, node);
    case IR_BREAK:
        return EXIT_BREAK;
    case IR_CONTINUE:
        return EXIT_CONTINUE;
    case IR_RETURN:
        m->result = run_expression(m, node->children[0]);
        return EXIT_RETURN;
    default:
        fail_msg("a kind of statement that is not generated: %d", (int)node->kind);
        return EXIT_NONE;
    }
}

/* ---- the comparison -------------------------------------------------------------------------- */

typedef struct tally {
    unsigned proved, early, early_seen, whole, undefined;
} tally;

/* Prints the program to standard error, since cmocka truncates long messages. */
static void refute(const generator *g, const char *what) {
    fprintf(stderr, "%s:\n%s\n", what, g->out.data);
    fail_msg("%s", what);
}

static void check_execution(const generator *g, const private_result *result, const machine *m) {
    unsigned count = 0;
    for (unsigned i = 0; i < ELEMENTS; i++)
        count += m->written[i];
    if (result->verdict == PRIVATE_PROVED && m->has_read_early)
        refute(g, "proved, but read before written");
    if (result->assigned_at_end && count < ELEMENTS)
        refute(g, "said to be assigned at the end, but is not");
    if (!result->is_written && count > 0)
        refute(g, "said not to be written, but is");
}

static void execute(const generator *g, const ir_unit *unit, const ir_node *body,
                    const ir_variable *f, const private_result *result, tally *sums) {
    bool has_read_early = false;
    for (unsigned i = 0; i < EXECUTIONS; i++) {
        number variables[256] = {{PLAIN, 0}};
        machine m = {.variables = variables, .variable_count = unit->variable_count, .f = f};
        assert_true(unit->variable_count < 256);
        run_statement(&m, body);
        sums->undefined += m.is_undefined;
        if (m.is_undefined)
            continue;
        has_read_early = has_read_early || m.has_read_early;
        check_execution(g, result, &m);
    }
    sums->early_seen += result->verdict == PRIVATE_READ_BEFORE_WRITE && has_read_early;
}

static void check_one(uint64_t seed, tally *sums) {
    generator g = {{0}, 0, {0}, 0, {0}, 0, 0};
    const char *message = NULL;
    random_state = seed;
    generate(&g);
    arena *memory = arena_new();
    const ir_unit *unit = ir_read(memory, g.out.data, g.out.length, &message);
    if (unit == NULL)
        fail_msg("%s:\n%s", message, g.out.data);
    const ir_function *function = ir_function_named(unit, "judged");
    const ir_variable *f = function->body->children[0]->children[0]->variable;
    const ir_node *body = function->body->children[2]->children[3];
    const private_result result = must_write_check(must_write_new(memory, unit, NULL), body, f);
    if (result.verdict != PRIVATE_UNKNOWN)
        execute(&g, unit, body, f, &result, sums);
    sums->proved += result.verdict == PRIVATE_PROVED;
    sums->early += result.verdict == PRIVATE_READ_BEFORE_WRITE;
    sums->whole += result.assigned_at_end;
    arena_free(memory);
    buffer_free(&g.out);
}

static void test_against_execution(void **context) {
    (void)context;
    tally sums = {0, 0, 0, 0, 0};
    for (uint64_t seed = 1; seed <= PROGRAMS; seed++)
        check_one(seed * UINT64_C(0x9e3779b97f4a7c15), &sums);
    /* The comparison would be void if few properties were proved, or few programs executed. */
    print_message("proved %u, read early %u (seen %u), whole %u, undefined executions %u\n",
                  sums.proved, sums.early, sums.early_seen, sums.whole, sums.undefined);
    assert_true(sums.proved > PROGRAMS / 20);
    assert_true(sums.whole > PROGRAMS / 20);
    assert_true(sums.early_seen > sums.early / 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_against_execution)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
