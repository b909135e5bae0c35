/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* IR expressions as C text. */
#include "read_ir.h"

#include "ir/ir_c.h"

static ir_node *expression(arena *a, const char *text) {
    ir_unit *unit = read_ir(
        a, arena_format(a,
                        "(unit \"a.c\" (union .1 (field u int))"
                        " (struct s (field v double) (field \"\" union(.1)))"
                        " (global a int) (global b int) (global c int) (global x double)"
                        " (global p ptr(int)) (global m ptr(array(3,double))) (global s struct(s))"
                        " (global q ptr(struct(s)))"
                        " (function f int (parameter .1 int) (parameter .2 int))"
                        " (function t void (block (expression %s))))",
                        text));
    return unit->functions[1]->body->children[0]->children[0];
}

static void test_precedence(void **state) {
    (void)state;
    static const struct {
        const char *ir, *c;
    } cases[] = {
        {"(- a (- b c))", "a - (b - c)"},
        {"(- (- a b) c)", "a - b - c"},
        {"(* (+ a b) c)", "(a + b) * c"},
        {"(+ (* a b) c)", "a * b + c"},
        {"(- (- x))", "-(-x)"},
        {"(- (--_ a))", "-(--a)"},
        {"(+ (++_ a))", "+(++a)"},
        {"(- (+ x))", "-+x"},
        {"(! (! a))", "!!a"},
        {"(- a (- b))", "a - -b"},
        {"(_++ (* p))", "(*p)++"},
        {"(* (_++ p))", "*p++"},
        {"(index (+ p a) b)", "(p + a)[b]"},
        {"(index (index m a) (, a b))", "m[a][a, b]"},
        {"(cast :double (+ a b))", "(double)(a + b)"},
        {"(+ (cast :double a) b)", "(double)a + b"},
        {"(cast :ptr(array(3,double)) p)", "(double (*)[3])p"},
        {"(index (cast :ptr(double) p) a)", "((double *)p)[a]"},
        {"(conditional a b (conditional b c a))", "a ? b : b ? c : a"},
        {"(conditional (conditional a b c) b c)", "(a ? b : c) ? b : c"},
        {"(conditional (= a b) (, a b) (= b c))", "(a = b) ? a, b : (b = c)"},
        {"(+ (conditional a b c) a)", "(a ? b : c) + a"},
        {"(call f (, a b) (= a b))", "f((a, b), a = b)"},
        {"(call (* (& f)) a b)", "(*&f)(a, b)"},
        {"(= a (= b c))", "a = b = c"},
        {"(>>= a (+ b 1))", "a >>= b + 1"},
        {"(, (= a b) (, b c))", "a = b, (b, c)"},
        {"(& (& a b) c)", "a & b & c"},
        {"(== (& a b) c)", "(a & b) == c"},
        {"(|| (&& a b) c)", "(a && b) || c"},
        {"(&& (|| a b) c)", "(a || b) && c"},
        {"(<< a (+ b c))", "a << (b + c)"},
        {"(& (+ a b) 255)", "(a + b) & 255"},
        {"(^ 2 5)", "(2) ^ 5"},
        {"(^ a (^ 2 (- 5)))", "a ^ ((2) ^ -5)"},
        {"(== a (< b c))", "a == (b < c)"},
        {"(sizeof \"sizeof(int)\" =4)", "sizeof(int)"},
        {"(* (sizeof \"sizeof a\" =4) a)", "sizeof a * a"},
        {"(member v s)", "s.v"},
        {"(member u (member #1 s))", "s.u"},
        {"(member u (arrow #1 q))", "q->u"},
        {"(arrow v (+ q 1))", "(q + 1)->v"},
        {"(& (index p a))", "&p[a]"},
        {"(* (+ p a))", "*(p + a)"},
        {"(~ (! a))", "~!a"},
        {"(initializers :array(2,int) !literal a (= b c))", "(int[2]){a, b = c}"},
        {"(initializers :array(1,array(2,int)) !literal (initializers :array(2,int) a b))",
         "(int[1][2]){{a, b}}"},
        {"(call f (string \"\\\"a\\\\n\\\"\") (number \"'b'\" =98))", "f(\"a\\n\", 'b')"},
        {"(__real (cast :cdouble a))", "__real (_Complex double)a"},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        buffer b = {0};
        assert_true(ir_c_expression(&b, expression(a, cases[i].ir), NULL, NULL));
        assert_string_equal(b.data, cases[i].c);
        buffer_free(&b);
        arena_free(a);
    }
}

static void test_what_cannot_be_spelled(void **state) {
    (void)state;
    static const char *const cases[] = {
        "(+ a (opaque \"a ?: b\" :int))",
        "(cast :unnamed(struct(s)) a)",
        "(initializers :array(2,int) !designated a b)",
        "(initializers :array(2,int) !literal !designated a b)",
        "(member #1 s)",
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        buffer b = {0};
        buffer_text(&b, "before");
        assert_false(ir_c_expression(&b, expression(a, cases[i]), NULL, NULL));
        assert_string_equal(b.data, "before");
        buffer_free(&b);
        arena_free(a);
    }
}

static const char *shadow(const ir_node *node, void *context) {
    if (node->kind == IR_MEMBER && strcmp(node->field->name, "v") == 0)
        return context;
    return NULL;
}

static void test_rename(void **state) {
    (void)state;
    arena *a = arena_new();
    buffer b = {0};
    assert_true(ir_c_expression(&b, expression(a, "(_++ (member v s))"), shadow, "redcc__v"));
    assert_string_equal(b.data, "redcc__v++");
    buffer_free(&b);
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_precedence),
        cmocka_unit_test(test_what_cannot_be_spelled),
        cmocka_unit_test(test_rename),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
