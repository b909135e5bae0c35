/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The text form of the IR: printed text is read back as the same IR, invalid text is refused with
 * its position, and the checker finds deliberate faults. */
#include "read_ir.h"

static char *printed(arena *a, const ir_unit *unit) {
    buffer b = {0};
    ir_print(&b, unit);
    char *text = arena_string(a, b.data);
    buffer_free(&b);
    return text;
}

/* A text with all kinds of nodes and types, exactly as the printer writes it. */
static const char canonical[] =
    "(unit \"all.c\" !no-strict-aliasing\n"
    "  (bytes 900)\n"
    "  (errors 2)\n"
    "  (struct node 16\n"
    "    (field next ptr(struct(node)) 0)\n"
    "    (bit-field low uint)\n"
    "    (field \"\" union(.1) 8))\n"
    "  (union .1 8\n"
    "    (field i int 0)\n"
    "    (field d double 0))\n"
    "  (struct vec 4 \"vec\"\n"
    "    (field x float 0))\n"
    "  (struct hidden !incomplete)\n"
    "  (struct node.2 4 !unnamed\n"
    "    (field y int 0))\n"
    "  (global list ptr(struct(node)) !address-taken !other-name @1-20)\n"
    "  (static v struct(vec))\n"
    "  (global h ptr(struct(hidden)))\n"
    "  (thread-local t const(volatile(named(\"enum color\",uint))))\n"
    "  (static other unnamed(struct(node.2)))\n"
    "  (global p restrict(ptr(const(array(?,array(3,double))))))\n"
    "  (global q named(\"int (*)(void)\",ptr(named(\"int (void)\",function(int)))))\n"
    "  (global w sized(16,other()))\n"
    "  (global l sized(4,long))\n"
    "  (function f double !static !variadic !noreturn !pure !const !errors @30-890\n"
    "    (parameter n int @32-33)\n"
    "    (parameter .1 ptr(void))\n"
    "    (local hidden int)\n"
    "    (block @40-890\n"
    "      (declaration @42-60\n"
    "        (declarator i int !address-taken @@46-47 @46-51\n"
    "          (number 0 @50-51))\n"
    "        (declarator k int !static-local)\n"
    "        (declarator t.2 int !thread-local)\n"
    "        (declarator list))\n"
    "      (for @70-300\n"
    "        (empty)\n"
    "        (,\n"
    "          (variable i)\n"
    "          (number 07))\n"
    "        (_--\n"
    "          (variable i))\n"
    "        (do\n"
    "          (while\n"
    "            (&&\n"
    "              (variable n)\n"
    "              (!\n"
    "                (variable k)))\n"
    "            (continue))\n"
    "          (number 1)))\n"
    "      (switch\n"
    "        (variable n)\n"
    "        (block\n"
    "          (case\n"
    "            (number RED =2)\n"
    "            (break))\n"
    "          (default\n"
    "            (empty))))\n"
    "      (label again\n"
    "        (if\n"
    "          (number \"'a'\" =97)\n"
    "          (goto again)\n"
    "          (goto\n"
    "            (variable p))))\n"
    "      (member i\n"
    "        (arrow #2\n"
    "          (variable list)))\n"
    "      (opaque \"asm\"\n"
    "        (variable k))\n"
    "      (expression @310-320\n"
    "        (opaque \"a ?: b\" :int @310-319))\n"
    "      (>>= !macro @330-340\n"
    "        (*\n"
    "          (+\n"
    "            (& :ptr(const(int))\n"
    "              (variable k))\n"
    "            (sizeof \"sizeof(int)\" =4)))\n"
    "        (cast :uchar\n"
    "          (conditional\n"
    "            (variable n)\n"
    "            (string \"\\\"a\\\\n\\\"\" :array(3,char))\n"
    "            (number 18446744073709551615u))))\n"
    "      (=\n"
    "        (variable v)\n"
    "        (initializers :struct(vec) !designated !literal\n"
    "          (number 1.5f)))\n"
    "      (return\n"
    "        (call\n"
    "          (function f)\n"
    "          (-\n"
    "            (-\n"
    "              (number 1)\n"
    "              (number 2ul)))))))\n"
    "  (function g void :function(void) !header)\n"
    "  (if \"#if X\" @0-5)\n"
    "  (directive \"#include <a.h>\" @6-20)\n"
    "  (pragma \"#pragma omp \\\\\\n for\" @25-30))\n";

static void test_round_trip(void **state) {
    (void)state;
    arena *a = arena_new();
    char *once = printed(a, read_ir(a, canonical));
    char *twice = printed(a, read_ir(a, once));
    assert_string_equal(once, twice);
    arena_free(a);
}

/* A text in the canonical form is printed unchanged. */
static void test_canonical_text_is_kept(void **state) {
    (void)state;
    arena *a = arena_new();
    static const char text[] = "(unit \"a.c\"\n"
                               "  (bytes 100)\n"
                               "  (global b ptr(double) @0-9)\n"
                               "  (function f void @10-90\n"
                               "    (parameter n int @17-22)\n"
                               "    (block @24-90\n"
                               "      (declaration @25-31\n"
                               "        (declarator b.2 int @29-30))\n"
                               "      (+= @40-52\n"
                               "        (index @40-44\n"
                               "          (variable b @40-41)\n"
                               "          (variable b.2 @42-43))\n"
                               "        (number 1.0 @48-51)))))\n";
    assert_string_equal(printed(a, read_ir(a, text)), text);
    arena_free(a);
}

static void test_short_forms(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *unit = read_ir(a, "(unit \"a.c\" (source \"int x;\\n\") (global a array(4,float))"
                               " (function g double (parameter x double))"
                               " (function f void (block (for (= i 0) (< i 4) (_++ i)"
                               "    (= (index a i) (call g 2))) )"
                               "   ) (global i int))");
    const ir_function *f = ir_function_named(unit, "f");
    ir_node *loop = f->body->children[0];
    assert_int_equal(loop->kind, IR_FOR);
    ir_node *statement = loop->children[3];
    assert_int_equal(statement->kind, IR_EXPRESSION);
    ir_node *assignment = statement->children[0];
    assert_string_equal(assignment->type->spelling, "float");
    assert_string_equal(assignment->children[1]->type->spelling, "double");
    assert_int_equal(assignment->children[1]->children[1]->value, 2);
    assert_int_equal(assignment->parent == statement, 1);
    assert_int_equal(f->node_count, 18);
    assert_int_equal(unit->source->length, 7);
    assert_string_equal(f->type->spelling, "void (void)");
    arena_free(a);
}

static void test_records_by_natural_alignment(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *unit =
        read_ir(a, "(unit \"a.c\" (struct s (field c char) (field d double) (field e short))"
                   " (union u (field a array(3,int)) (field s struct(s)))"
                   " (global x struct(s)) (global y union(u)))");
    const ir_record *s = unit->variables[0]->type->record;
    assert_int_equal(s->size, 24);
    assert_int_equal(s->fields[1].offset, 8);
    assert_int_equal(s->fields[2].offset, 16);
    assert_int_equal(unit->variables[1]->type->size, 24);
    assert_int_equal(unit->variables[1]->type->record->fields[1].offset, 0);
    assert_string_equal(unit->variables[1]->type->spelling, "union u");
    arena_free(a);
}

static void test_inferred_types(void **state) {
    (void)state;
    static const struct {
        const char *expression, *type;
    } cases[] = {
        {"(+ c c)", "int"},
        {"(+ i u)", "unsigned int"},
        {"(+ u l)", "long"},
        {"(* f i)", "float"},
        {"(* f 2.0)", "double"},
        {"(< f 2.0)", "int"},
        {"(<< c l)", "int"},
        {"(- p p)", "long"},
        {"(+ m 1)", "double (*)[3]"},
        {"(index m 1)", "double[3]"},
        {"(* (index m 1))", "double"},
        {"(& (index m 1))", "double (*)[3]"},
        {"(& p)", "const double **"},
        {"(* p)", "const double"},
        {"(= f (* p))", "float"},
        {"(, i k)", "int"},
        {"(conditional i f l)", "float"},
        {"(conditional i m m)", "double (*)[3]"},
        {"(_++ k)", "int"},
        {"(- c)", "int"},
        {"(! p)", "int"},
        {"(number 4294967296)", "long"},
        {"(number 0xffffffff)", "unsigned int"},
        {"(number 1.f)", "float"},
        {"(number 0x1p3)", "double"},
        {"(number 1ull)", "unsigned long long"},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        ir_unit *unit = read_ir(
            a, arena_format(a,
                            "(unit \"a.c\" (global c char) (global i int) (global u uint)"
                            " (global l long) (global f float) (global p ptr(const(double)))"
                            " (global m array(2,array(3,double))) (global k const(int))"
                            " (function t void (block %s)))",
                            cases[i].expression));
        const ir_node *e = unit->functions[0]->body->children[0]->children[0];
        assert_string_equal(e->type->spelling, cases[i].type);
        arena_free(a);
    }
}

static void test_bad_texts(void **state) {
    (void)state;
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"", "1:1: expected '('"},
        {"  unit", "1:3: expected '('"},
        {"(unit \"a.c\"\n  (bytes 4)", "2:12: expected ')'"},
        {"(unit \"a.c\") x", "1:14: expected the end of the text"},
        {"(unit \"a.c", "1:7: expected a quoted text that ends, with known escapes"},
        {"(unit \"a\\q\")", "1:7: expected a quoted text that ends, with known escapes"},
        {"(unit a.c)", "1:1: expected (unit \"file name\" ...)"},
        {"(unit \"a\" (thing))",
         "1:11: expected a part of the unit (struct, global, function, ...)"},
        {"(unit \"a\" (bytes x))", "1:18: expected a number"},
        {"(unit \"a\" (bytes -1))", "1:18: expected a number from 0 to 2147483647"},
        {"(unit \"a\" (global x))", "1:11: expected a variable's name and type"},
        {"(unit \"a\" (global x itn))", "1:21: expected a type"},
        {"(unit \"a\" (global x ptr(int))", "1:30: expected ')'"},
        {"(unit \"a\" (global x ptr(int)x))", "1:29: expected nothing behind the type"},
        {"(unit \"a\" (global x array(y,int)))", "1:27: expected a number or '?'"},
        {"(unit \"a\" (global x array(3 int)))", "1:28: expected ','"},
        {"(unit \"a\" (global x named(int)))", "1:27: expected a spelling in quotes"},
        {"(unit \"a\" (global x struct(s)))",
         "1:28: expected the name of a struct or union of this unit"},
        {"(unit \"a\" (global x int @3))", "1:25: expected a range: @begin-end"},
        {"(unit \"a\" (global x int @4-3))", "1:25: expected a range: @begin-end"},
        {"(unit \"a\" (global x int !static))",
         "1:25: expected !address-taken, !other-name or @begin-end"},
        {"(unit \"a\" (global x int) (static x int))",
         "1:34: expected a name not used before (\"name.2\")"},
        {"(unit \"a\" (struct s 8 (field x)))", "1:23: expected a field's name and type"},
        {"(unit \"a\" (struct s) (struct s))",
         "1:30: expected a name not used before (\"name.2\")"},
        {"(unit \"a\" (function f))", "1:11: expected a function's name and result type"},
        {"(unit \"a\" (function f void !quick))", "1:28: expected a flag of a function"},
        {"(unit \"a\" (function f void :int))", "1:11: expected a function type: function(result)"},
        {"(unit \"a\" (function f void (empty)))", "1:28: expected a block as the function's body"},
        {"(unit \"a\" (function f void (block) (block)))",
         "1:36: expected nothing behind the function's body"},
        {"(unit \"a\" (function f void (block (thing))))", "1:36: expected the word of a node"},
        {"(unit \"a\" (function f void (block x)))",
         "1:35: expected a variable or function declared before"},
        {"(unit \"a\" (function f void (block (variable x))))",
         "1:45: expected a variable declared before"},
        {"(unit \"a\" (function f void (block (= 1))))", "1:36: expected the word of a node"},
        {"(unit \"a\" (function f void (block (+ 1 2 3))))", "1:35: expected 2 children"},
        {"(unit \"a\" (function f void (block (call))))", "1:35: expected at least 1 children"},
        {"(unit \"a\" (function f void (block (cast 1))))",
         "1:35: expected a type (\":int\"), which cannot be inferred here"},
        {"(unit \"a\" (function f void (block (break !fast))))", "1:42: expected a flag of a node"},
        {"(unit \"a\" (global i int) (function f void (block (member x i))))",
         "1:50: expected an object of a struct or union"},
        {"(unit \"a\" (struct s (field x int)) (global i struct(s)) (function f void"
         " (block (member y i))))",
         "1:89: expected a field of this struct or union"},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        const char *message = NULL;
        assert_null(ir_read(a, cases[i].text, strlen(cases[i].text), &message));
        assert_string_equal(message, cases[i].message);
        arena_free(a);
    }
}

/* Every proper prefix of a valid text is refused, and has no other effect. */
static void test_cut_texts(void **state) {
    (void)state;
    for (size_t length = 0; length < sizeof canonical - 2; length++) {
        arena *a = arena_new();
        const char *message = NULL;
        assert_null(ir_read(a, canonical, length, &message));
        assert_non_null(message);
        arena_free(a);
    }
}

static void test_deep_text(void **state) {
    (void)state;
    arena *a = arena_new();
    enum { DEPTH = 100000 };
    char *text = arena_allocate(a, DEPTH + 1);
    memset(text, '(', DEPTH);
    const char *message = NULL;
    assert_null(ir_read(a, text, DEPTH, &message));
    assert_string_equal(message, "1:4002: expected less deeply nested lists");
    arena_free(a);
}

/* ---- the checker --------------------------------------------------------------------------- */

static ir_unit *small(arena *a) {
    return read_ir(a, "(unit \"a.c\" (bytes 50) (struct s (field x int)) (global g struct(s))"
                      " (function f void @0-40 (parameter n int @2-3)"
                      "   (block @10-40 (= @12-20 (member x @12-15 g) (number 1 @18-19)))))");
}

static void expect_problem(arena *a, const ir_unit *unit, const char *part) {
    const char *problem = ir_check(a, unit);
    assert_non_null(problem);
    if (strstr(problem, part) == NULL)
        fail_msg("'%s' does not contain '%s'", problem, part);
}

static void test_check(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *u = small(a);
    ir_node *body = u->functions[0]->body;
    body->children[0]->parent = NULL;
    expect_problem(a, u, "its parent is not the node it stands in");
    u = small(a);
    ir_node *assignment = u->functions[0]->body->children[0]->children[0];
    assignment->id = 9;
    expect_problem(a, u, "its id is not its place in preorder");
    u = small(a);
    assignment = u->functions[0]->body->children[0]->children[0];
    assignment->type = NULL;
    expect_problem(a, u, "an expression without a type");
    assignment->type = u->variables[1]->type;
    assignment->op = IR_OP_LESS;
    expect_problem(a, u, "its operator does not fit its kind");
    assignment->op = IR_OP_ADD;
    assert_null(ir_check(a, u));
    assignment->range.end = 60;
    expect_problem(a, u, "its range is not inside the file");
    assignment->range.end = 45;
    expect_problem(a, u, "its range is not inside its parent's");
    assignment->range.end = 20;
    assignment->child_count = 1;
    expect_problem(a, u, "has too few or too many children");
    assignment->child_count = 2;
    static const ir_field stranger = {.name = "x"};
    assignment->children[0]->field = &stranger;
    expect_problem(a, u, "its field is not its object's");
    u = small(a);
    u->functions[0]->node_count++;
    expect_problem(a, u, "node_count is 7, but it has 6 nodes");
    u = small(a);
    u->variables[1]->function = NULL;
    expect_problem(a, u, "local, but of no function");
    u = small(a);
    u->variables[1]->type =
        ir_read(a, "(unit \"\" (global a array(3,double)))", 36, &(const char *){0})
            ->variables[0]
            ->type;
    expect_problem(a, u, "parameter 0 is an array or a function");
    u = small(a);
    u->variables[0]->id = 1;
    expect_problem(a, u, "its id is not its place");
    u = small(a);
    u->functions[0]->body->children[0] = u->functions[0]->body->children[0]->children[0];
    ir_finish_function(u->functions[0]);
    expect_problem(a, u, "an expression where a statement belongs");
    arena_free(a);
}

static void test_node_alone(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *u = small(a);
    buffer b = {0};
    ir_print_node(&b, u->functions[0]->body->children[0]->children[0]);
    assert_string_equal(b.data, "(= @12-20\n  (member x @12-15\n    (variable g))\n"
                                "  (number 1 @18-19))\n");
    buffer_free(&b);
    arena_free(a);
}

/* A zero byte in a text is refused and must not cause a crash. */
static void test_zero_byte(void **state) {
    (void)state;
    static const char text[] = "(unit \"a\" (global x named(\"q\0\",int)))";
    arena *a = arena_new();
    const char *message = NULL;
    assert_null(ir_read(a, text, sizeof text - 1, &message));
    assert_non_null(message);
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_zero_byte),
        cmocka_unit_test(test_round_trip),
        cmocka_unit_test(test_canonical_text_is_kept),
        cmocka_unit_test(test_short_forms),
        cmocka_unit_test(test_records_by_natural_alignment),
        cmocka_unit_test(test_inferred_types),
        cmocka_unit_test(test_bad_texts),
        cmocka_unit_test(test_cut_texts),
        cmocka_unit_test(test_deep_text),
        cmocka_unit_test(test_check),
        cmocka_unit_test(test_node_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
