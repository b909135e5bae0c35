/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The helper functions of ir.h: types, paths, used values and substitution. */
#include "read_ir.h"

#include "ir/ir_c.h"

/* Returns the expression in a function with these variables. */
static ir_node *expression(arena *a, const char *text) {
    ir_unit *unit = read_ir(
        a, arena_format(a,
                        "(unit \"a.c\" (struct s (field b ptr(double)) (field n int))"
                        " (function add void (parameter d ptr(double)) (parameter v float)"
                        "   (block (+= (* d) v)))"
                        " (function t void (parameter R ptr(double)) (local A array(4,double))"
                        "   (parameter i int) (parameter p ptr(struct(s))) (parameter w float)"
                        "   (block %s)))",
                        text));
    ir_node *statement = unit->functions[1]->body->children[0];
    return statement->kind == IR_EXPRESSION ? statement->children[0] : statement;
}

static char *as_c(arena *a, const ir_node *node) {
    buffer b = {0};
    char *text = ir_c_expression(&b, node, NULL, NULL) ? arena_string(a, b.data) : NULL;
    buffer_free(&b);
    return text;
}

static void test_root_variable(void **state) {
    (void)state;
    static const struct {
        const char *text, *root;
    } cases[] = {
        {"R", "R"},
        {"(index R i)", "R"},
        {"(index (arrow b p) i)", "p"},
        {"(member n (* p))", "p"},
        {"(& (index A 2))", "A"},
        {"(cast :ptr(char) R)", "R"},
        {"(+ R 1)", NULL},
        {"(call add R w)", NULL},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        const ir_variable *root = ir_root_variable(expression(a, cases[i].text));
        if (cases[i].root == NULL)
            assert_null(root);
        else
            assert_string_equal(root->name, cases[i].root);
        arena_free(a);
    }
}

static bool find_increment(ir_node *node, void *context) {
    if (node->kind == IR_UNARY && node->op == IR_OP_POST_INCREMENT)
        *(ir_node **)context = node;
    return true;
}

static void test_used_values(void **state) {
    (void)state;
    static const struct {
        const char *text;
        bool used;
    } cases[] = {
        {"(_++ i)", false},
        {"(, (_++ i) (= i 1))", false},
        {"(, (= i 1) (_++ i))", false},
        {"(= i (, 1 (_++ i)))", true},
        {"(for (_++ i) 1 (empty) (empty))", false},
        {"(for (empty) 1 (_++ i) (empty))", false},
        {"(for (empty) (_++ i) (empty) (empty))", true},
        {"(cast :void (_++ i))", false},
        {"(cast :long (_++ i))", true},
        {"(&& w (_++ i))", false},
        {"(&& (_++ i) w)", true},
        {"(if (&& w (_++ i)) (empty))", true},
        {"(conditional w (_++ i) 1)", false},
        {"(conditional (_++ i) 1 1)", true},
        {"(index R (_++ i))", true},
        {"(while (_++ i) (empty))", true},
        {"(return (_++ i))", true},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        ir_node *increment = NULL;
        ir_walk(expression(a, cases[i].text), find_increment, &increment);
        assert_int_equal(ir_value_is_used(increment), cases[i].used);
        arena_free(a);
    }
}

static void test_types(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *u = read_ir(a, "(unit \"a.c\" (struct s (field x int)) (struct r (field x int))"
                            " (global a ptr(const(double))) (global b ptr(double))"
                            " (global c ptr(float)) (global d struct(s)) (global e struct(r))"
                            " (global f named(\"enum e\",uint)) (global g uint)"
                            " (global h array(2,array(3,schar))) (global i array(3,schar))"
                            " (global j long) (global k llong) (global l char) (global m bool))");
    ir_variable **v = u->variables;
    assert_true(ir_type_equal(v[0]->type, v[1]->type));
    assert_false(ir_type_equal(v[1]->type, v[2]->type));
    assert_false(ir_type_equal(v[3]->type, v[4]->type));
    assert_true(ir_type_equal(v[5]->type, v[6]->type));
    assert_false(ir_type_equal(v[7]->type, v[8]->type));
    assert_true(ir_type_equal(v[9]->type, v[10]->type));
    assert_false(ir_type_equal(v[11]->type, v[12]->type));
    assert_true(ir_type_is_scalar(v[0]->type));
    assert_false(ir_type_is_scalar(v[3]->type));
    assert_false(ir_type_is_scalar(v[7]->type));
    assert_int_equal(ir_type_innermost(v[7]->type)->size, 1);
    assert_ptr_equal(ir_type_innermost(v[0]->type), v[0]->type);
    arena_free(a);
}

static void test_substitute(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_node *call = expression(a, "(call add (& (index R i)) w)");
    const ir_function *add = call->children[0]->function;
    ir_node *update = add->body->children[0]->children[0];
    ir_node *const arguments[] = {call->children[1], call->children[2]};
    ir_node *copy = ir_substitute(a, update, add, arguments);
    assert_string_equal(as_c(a, copy), "*&R[i] += w");
    assert_null(copy->parent);
    assert_ptr_equal(copy->children[1]->parent, copy);
    assert_string_equal(as_c(a, update), "*d += v"); /* the original is unchanged */
    assert_ptr_equal(call->children[1]->parent, call);
    ir_node *const first_only[] = {call->children[1], NULL};
    assert_string_equal(as_c(a, ir_substitute(a, update, add, first_only)), "*&R[i] += v");
    arena_free(a);
}

/* An argument is converted to the parameter's type. */
static void test_substitute_converts(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_node *call = expression(a, "(call add A (* 2.0 w))");
    const ir_function *add = call->children[0]->function;
    ir_node *const arguments[] = {call->children[1], call->children[2]};
    ir_node *copy = ir_substitute(a, add->body->children[0]->children[0], add, arguments);
    assert_string_equal(as_c(a, copy), "*A += (float)(2.0 * w)");
    arena_free(a);
}

static void test_contains_and_named(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *u = read_ir(a, "(unit \"a.c\" (function f void (block (block (return)) (empty))))");
    const ir_function *f = ir_function_named(u, "f");
    assert_null(ir_function_named(u, "g"));
    ir_node *leaf = f->body->children[0]->children[0];
    assert_true(ir_contains(f->body, leaf));
    assert_true(ir_contains(leaf, leaf));
    assert_false(ir_contains(f->body->children[1], leaf));
    assert_null(ir_child(leaf, 0));
    assert_int_equal(leaf->id, 2);
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_root_variable),
        cmocka_unit_test(test_used_values),
        cmocka_unit_test(test_types),
        cmocka_unit_test(test_substitute),
        cmocka_unit_test(test_substitute_converts),
        cmocka_unit_test(test_contains_and_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
