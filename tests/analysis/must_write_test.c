/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tests the must-write proof on the functions of must_write_cases.c, read as IR text. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "analysis/memory/must_write/must_write.h"
#include "ir_reader/ir_read.h"
#include "support/source.h"

static arena *memory;
static ir_unit *unit;

static int read_cases(void **context) {
    (void)context;
    const char *message = NULL;
    memory = arena_new();
    const source *text = source_read(memory, MUST_WRITE_CASES, &message);
    if (text == NULL) {
        print_error("%s\n", message);
        return 1;
    }
    unit = ir_read(memory, text->text, text->length, &message);
    if (unit == NULL) {
        print_error("%s: %s\n", MUST_WRITE_CASES, message);
        return 1;
    }
    unit->source = source_read(memory, MUST_WRITE_SOURCE, &message);
    return unit->source == NULL;
}

static int free_cases(void **context) {
    (void)context;
    arena_free(memory);
    return 0;
}

static bool begins_with(const char *text, const char *start) {
    return strncmp(text, start, strlen(start)) == 0;
}

static bool ends_with(const char *text, const char *end) {
    return strlen(text) >= strlen(end) && strcmp(text + strlen(text) - strlen(end), end) == 0;
}

typedef struct search {
    const char *counter;
    const ir_node *body;
} search;

static bool declares_or_assigns(const ir_node *initial, const char *name) {
    if (initial->kind == IR_DECLARATION)
        initial = initial->children[0];
    return initial->kind == IR_DECLARATOR && strcmp(initial->variable->name, name) == 0;
}

static bool find_loop(ir_node *node, void *context) {
    search *find = context;
    if (find->body == NULL && node->kind == IR_FOR &&
        declares_or_assigns(node->children[0], find->counter))
        find->body = node->children[3];
    return find->body == NULL;
}

static const ir_variable *variable_named(const ir_function *function, const char *name) {
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->function == function && strcmp(unit->variables[i]->name, name) == 0)
            return unit->variables[i];
    return NULL;
}

static private_result judge(must_write *prover, const ir_function *function) {
    search find = {"t", NULL};
    ir_walk(function->body, find_loop, &find);
    const ir_variable *f = variable_named(function, "f");
    assert_non_null(find.body);
    assert_non_null(f);
    return must_write_check(prover, find.body, f);
}

static private_verdict expected_verdict(const char *name) {
    return begins_with(name, "proved_")  ? PRIVATE_PROVED
           : begins_with(name, "early_") ? PRIVATE_READ_BEFORE_WRITE
                                         : PRIVATE_UNKNOWN;
}

static bool is_case(const ir_function *function) {
    return function->body != NULL &&
           (begins_with(function->name, "proved_") || begins_with(function->name, "early_") ||
            begins_with(function->name, "unknown_"));
}

static unsigned check_case(must_write *prover, const ir_function *function) {
    const char *name = function->name;
    const private_result result = judge(prover, function);
    const bool is_whole = ends_with(name, "_whole");
    const private_verdict expected = expected_verdict(name);
    unsigned wrong = result.verdict != expected;
    if (expected != PRIVATE_UNKNOWN && result.verdict == expected)
        wrong |= result.assigned_at_end != is_whole;
    wrong |= (result.why == NULL) != (result.verdict == PRIVATE_PROVED);
    if (wrong)
        print_error("%s: verdict %d (%s), assigned at end %d\n", name, (int)result.verdict,
                    result.why != NULL ? result.why : "-", result.assigned_at_end);
    return wrong;
}

static void test_cases(void **context) {
    (void)context;
    must_write *prover = must_write_new(memory, unit, NULL);
    unsigned count = 0, wrong = 0;
    for (unsigned i = 0; i < unit->function_count; i++)
        if (is_case(unit->functions[i])) {
            count++;
            wrong += check_case(prover, unit->functions[i]);
        }
    assert_true(count > 100);
    assert_int_equal(wrong, 0);
}

/* The result of a query must not depend on earlier queries. */
static void test_order_of_queries(void **context) {
    (void)context;
    must_write *prover = must_write_new(memory, unit, NULL);
    unsigned wrong = 0;
    for (unsigned i = unit->function_count; i-- > 0;)
        if (is_case(unit->functions[i]))
            wrong += check_case(prover, unit->functions[i]);
    assert_int_equal(wrong, 0);
}

static void test_node_in_the_way(void **context) {
    (void)context;
    must_write *prover = must_write_new(memory, unit, NULL);
    const ir_function *function = ir_function_named(unit, "early_callee");
    const private_result result = judge(prover, function);
    assert_non_null(result.node);
    assert_int_equal(result.node->kind, IR_INDEX);
    const private_result call = judge(prover, ir_function_named(unit, "unknown_callee_keeps"));
    assert_non_null(call.node);
    assert_int_equal(call.node->kind, IR_CALL);
}

static void test_pure_by_the_users_word(void **context) {
    (void)context;
    const char *const names[] = {"keep"};
    const analysis_options options = {.pure_count = 1, .pure = names};
    must_write *prover = must_write_new(memory, unit, &options);
    const private_result result =
        judge(prover, ir_function_named(unit, "unknown_callee_without_body"));
    assert_int_equal(result.verdict, PRIVATE_PROVED);
}

static parameter_effect effect_of(must_write *prover, const char *name, unsigned index) {
    const ir_function *function = ir_function_named(unit, name);
    assert_non_null(function);
    return must_write_parameter(prover, function, index);
}

static void test_parameters(void **context) {
    (void)context;
    must_write *prover = must_write_new(memory, unit, NULL);
    parameter_effect effect = effect_of(prover, "fill", 1);
    assert_true(effect.is_known && effect.may_write && effect.writes_all && !effect.may_read);
    assert_int_equal(effect.end, 3 * 8);
    effect = effect_of(prover, "fill", 0);
    assert_true(effect.is_known && !effect.may_write && effect.may_read);
    assert_int_equal(effect.end, 3 * 8);
    effect = effect_of(prover, "fill_rows", 0);
    assert_true(effect.is_known && effect.writes_all && !effect.may_read);
    assert_int_equal(effect.end, 9 * 8);
    effect = effect_of(prover, "twice", 0);
    assert_true(effect.is_known && effect.writes_all && effect.may_read);
    effect = effect_of(prover, "fill_if", 1);
    assert_true(effect.is_known && effect.may_write && !effect.writes_all && !effect.may_read);
    assert_false(effect_of(prover, "fill_n", 2).is_known); /* unknown length */
    assert_false(effect_of(prover, "fill_n", 2).keeps_address);
    assert_false(effect_of(prover, "fill_rows", 0).keeps_address);
    assert_true(effect_of(prover, "hide", 0).keeps_address);
    assert_true(effect_of(prover, "second", 0).keeps_address);
    assert_false(effect_of(prover, "hide", 0).is_known);   /* stores the pointer */
    assert_false(effect_of(prover, "deep", 1).is_known);   /* calls itself */
    assert_false(effect_of(prover, "second", 0).is_known); /* returns the pointer */
    assert_false(effect_of(prover, "fill", 7).is_known);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cases),           cmocka_unit_test(test_order_of_queries),
        cmocka_unit_test(test_node_in_the_way), cmocka_unit_test(test_pure_by_the_users_word),
        cmocka_unit_test(test_parameters),
    };
    return cmocka_run_group_tests(tests, read_cases, free_cases);
}
