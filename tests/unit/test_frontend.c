/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Properties that the expected IR texts do not show: the bytes of ranges, flags, errors, depth, and
 * C that is printed and parsed again. */
#include "read_ir.h"

#include "frontend/flags.h"
#include "frontend/frontend.h"
#include "ir/ir_c.h"

static frontend_result parse_with(arena *a, const char *text, unsigned flag_count,
                                  const char *const *flags) {
    source *src = source_from_text(a, "memory.c", text, strlen(text));
    frontend_result result = frontend_parse(a, src, flag_count, flags);
    assert_non_null(result.unit);
    const char *problem = ir_check(a, result.unit);
    if (problem != NULL)
        fail_msg("%s", problem);
    return result;
}

static const ir_unit *parse(arena *a, const char *text) {
    frontend_result result = parse_with(a, text, 0, NULL);
    if (result.unit->error_count > 0)
        fail_msg("%s", result.diagnostics[0].text);
    return result.unit;
}

/* ---- bytes under ranges -------------------------------------------------------------------- */

typedef struct byte_check {
    const ir_unit *unit;
    buffer seen;
} byte_check;

static bool note_bytes(ir_node *node, void *context) {
    byte_check *check = context;
    const char *text = check->unit->source->text + node->range.begin;
    size_t length = node->range.end - node->range.begin;
    if (node->kind == IR_VARIABLE || node->kind == IR_FUNCTION || node->kind == IR_NUMBER ||
        node->kind == IR_INDEX || node->kind == IR_CALL || node->kind == IR_ASSIGN ||
        node->kind == IR_FOR || node->kind == IR_DECLARATION || node->kind == IR_RETURN) {
        buffer_append(&check->seen, text, length);
        buffer_text(&check->seen, node->flags & IR_FROM_MACRO ? "! " : " ");
    }
    return true;
}

static void expect_bytes(const char *text, const char *expected) {
    arena *a = arena_new();
    byte_check check = {.unit = parse(a, text)};
    ir_walk(check.unit->functions[0]->body, note_bytes, &check);
    assert_string_equal(check.seen.data, expected);
    buffer_free(&check.seen);
    arena_free(a);
}

static void test_ranges_plain(void **state) {
    (void)state;
    expect_bytes("void f(int *p, int n) { p[n] = 2; int k = p[0]; return; }",
                 "p[n] = 2 p[n] p n 2 int k = p[0]; p[0] p 0 return ");
}

static void test_ranges_byte_order_mark_and_crlf(void **state) {
    (void)state;
    expect_bytes("\xef\xbb\xbfvoid f(int *p)\r\n{\r\n  p[1]\r\n = 2;\r\n}\r\n",
                 "p[1]\r\n = 2 p[1] p 1 2 ");
}

static void test_ranges_utf8(void **state) {
    (void)state;
    expect_bytes("/* \xc3\xa4\xc3\xb6 */ void f(int *\xc3\xa4) { \xc3\xa4[1] = '\x7e'; }",
                 "\xc3\xa4[1] = '~' \xc3\xa4[1] \xc3\xa4 1 '~' ");
}

static void test_ranges_digraphs_and_splices(void **state) {
    (void)state;
    expect_bytes("void f(int *p, int name) <% p<:na\\\nme:> = 1\\\n2; %>",
                 "p<:na\\\nme:> = 1\\\n2 p<:na\\\nme:> p na\\\nme 1\\\n2 ");
}

static void test_ranges_of_macros(void **state) {
    (void)state;
    expect_bytes("#define AT(a, i) a[i]\n#define ONE 1\n"
                 "void f(int *p, int n) { AT(p, n) = ONE; n = n + ONE; AT(p, ONE)++; }",
                 "AT(p, n) = ONE! AT(p, n)! AT(p, n)! AT(p, n)! ONE! n = n + ONE! n n ONE! "
                 "AT(p, ONE)! AT(p, ONE)! AT(p, ONE)! ");
}

static void test_loop_that_ends_in_macro_owns_its_bytes(void **state) {
    (void)state;
    arena *a = arena_new();
    const ir_unit *unit = parse(a, "#define UPD(x) x++\n#define TWO(x) x++; x--\n"
                                   "#define OPEN {\n#define CLOSE x++; }\n"
                                   "void f(int x, int n) {\n"
                                   "  for (int i = 0; i < n; i++) UPD(x);\n"
                                   "  for (int i = 0; i < n; i++) TWO(x);\n"
                                   "  for (int i = 0; i < n; i++) if (n) UPD(x);\n"
                                   "  { for (int i = 0; i < n; i++) CLOSE\n"
                                   "  OPEN UPD(x); }\n"
                                   "}\n");
    ir_node *const *statements = unit->functions[0]->body->children;
    assert_int_equal(statements[0]->kind, IR_FOR);
    assert_int_equal(statements[0]->flags & IR_FROM_MACRO, 0);
    assert_int_equal(statements[0]->children[3]->flags & IR_FROM_MACRO, 0);
    assert_int_equal(statements[0]->children[3]->children[0]->flags, IR_FROM_MACRO);
    assert_int_equal(statements[1]->kind, IR_FOR);
    assert_int_equal(statements[1]->flags, IR_FROM_MACRO);
    assert_int_equal(statements[2]->kind, IR_EXPRESSION);
    assert_int_equal(statements[2]->flags, IR_FROM_MACRO);
    assert_int_equal(statements[3]->flags, 0);
    assert_int_equal(statements[3]->children[3]->children[1]->flags, 0);
    assert_int_equal(statements[4]->kind, IR_BLOCK);
    assert_int_equal(statements[4]->children[0]->flags, IR_FROM_MACRO);
    arena_free(a);
}

/* ---- flags --------------------------------------------------------------------------------- */

static int64_t returned_value(const ir_unit *unit) {
    const ir_node *result = unit->functions[0]->body->children[0]->children[0];
    assert_int_equal(result->flags & IR_HAS_VALUE, IR_HAS_VALUE);
    return result->value;
}

static void expect_returned(const char *text, const char *flag, int64_t value) {
    arena *a = arena_new();
    const char *const flags[] = {"-c", "-o", "out.o", "-Wall", "-MMD", "-save-temps", flag};
    frontend_result result = parse_with(a, text, flag != NULL ? 7 : 6, flags);
    assert_int_equal(result.unit->error_count, 0);
    assert_int_equal(returned_value(result.unit), value);
    arena_free(a);
}

static void test_flags(void **state) {
    (void)state;
    static const char defined[] =
        "#ifdef _OPENMP\n#define V _OPENMP\n#endif\n#ifndef V\n#define V 7\n"
        "#endif\nint f(void) { return V; }";
    expect_returned(defined, NULL, 7);
    expect_returned(defined, "-DV=12", 12);
    expect_returned(defined, "-DV", 1);
    expect_returned(defined, "-fopenmp", 201511);
    expect_returned(defined, "-mno-such-feature-at-all", 7);
    expect_returned("int f(void) { return sizeof(long); }", "-m32", 4);
    expect_returned("enum e { A }; int f(void) { return sizeof(enum e); }", "-fshort-enums", 1);
    expect_returned("int f(void) { return '\\xff'; }", NULL, -1);
    expect_returned("int f(void) { return '\\xff'; }", "-funsigned-char", 255);
    expect_returned("#if __STDC_VERSION__ < 199901L\nint f() { return 1; }\n#else\n"
                    "int f() { return 2; }\n#endif",
                    "-ansi", 1);
    expect_returned("#ifdef __OPTIMIZE__\nint f(void) { return 1; }\n#else\n"
                    "int f(void) { return 0; }\n#endif",
                    "-O2", 1);
}

static void test_separate_arguments_of_flags(void **state) {
    (void)state;
    arena *a = arena_new();
    const char *const flags[] = {"-D", "V=3", "-o", "-DV=4", "-U", "W", "-std=gnu11", "-include"};
    frontend_result result = parse_with(a, "int f(void) { return V; }", 8, flags);
    assert_int_equal(result.unit->error_count, 0);
    assert_int_equal(returned_value(result.unit), 3);
    arena_free(a);
}

static void test_strict_aliasing(void **state) {
    (void)state;
    arena *a = arena_new();
    const char *const off[] = {"-fno-strict-aliasing"};
    assert_true(parse(a, "int x;")->dialect.strict_aliasing);
    assert_false(parse_with(a, "int x;", 1, off).unit->dialect.strict_aliasing);
    arena_free(a);
}

static void test_openmp_pragma_hides_nothing(void **state) {
    (void)state;
    arena *a = arena_new();
    const char *const flags[] = {"-fopenmp"};
    const ir_unit *unit = parse_with(a,
                                     "void f(int n) {\n#pragma omp parallel for\n"
                                     "for (int i = 0; i < n; i++) n++; }",
                                     1, flags)
                              .unit;
    assert_int_equal(unit->functions[0]->body->children[0]->kind, IR_FOR);
    assert_int_equal(unit->directive_count, 1);
    arena_free(a);
}

/* ---- headers of the system ----------------------------------------------------------------- */

static void test_system_headers(void **state) {
    (void)state;
    arena *a = arena_new();
    const char *const flags[] = {"-fopenmp", "-march=native"};
    frontend_result result = parse_with(a,
                                        "#include <assert.h>\n#include <complex.h>\n"
                                        "#include <errno.h>\n#include <immintrin.h>\n"
                                        "#include <limits.h>\n#include <math.h>\n"
                                        "#include <omp.h>\n#include <pthread.h>\n"
                                        "#include <stdint.h>\n#include <stdio.h>\n"
                                        "double f(int n, double x) { assert(n); errno = 0;\n"
                                        "  printf(\"%d\", INT_MAX + omp_get_max_threads());\n"
                                        "  return fabs(x) + NAN; }",
                                        2, flags);
    for (unsigned i = 0; i < result.diagnostic_count; i++)
        assert_false(result.diagnostics[i].is_error);
    assert_false(result.unit->functions[0]->has_errors);
    arena_free(a);
}

static void test_atomics_header(void **state) {
    (void)state;
    arena *a = arena_new();
    parse(a, "#include <stdatomic.h>\nvoid f(_Atomic int *p) { atomic_fetch_add(p, 1); }");
    arena_free(a);
}

/* ---- errors -------------------------------------------------------------------------------- */

static void test_errors(void **state) {
    (void)state;
    arena *a = arena_new();
    frontend_result result = parse_with(a,
                                        "int good(int n) { return n; }\n"
                                        "int bad(int n) { for (;;) n = = 2; return n; }\n"
                                        "int other(int n) { return n; }\n",
                                        0, NULL);
    assert_int_equal(result.unit->error_count, 1);
    assert_int_equal(result.diagnostic_count, 1);
    assert_true(result.diagnostics[0].is_error);
    assert_non_null(strstr(result.diagnostics[0].text, "memory.c:2:31: error: "));
    assert_false(ir_function_named(result.unit, "good")->has_errors);
    assert_true(ir_function_named(result.unit, "bad")->has_errors);
    assert_false(ir_function_named(result.unit, "other")->has_errors);
    arena_free(a);
}

static void test_missing_header_taints_all(void **state) {
    (void)state;
    arena *a = arena_new();
    const ir_unit *unit =
        parse_with(a, "#include \"no-such.h\"\nint f(int n) { return n; }", 0, NULL).unit;
    assert_int_equal(unit->error_count, 1);
    assert_true(unit->functions[0]->has_errors);
    arena_free(a);
}

/* Code that gcc accepts with a warning is no error. */
static void test_old_c(void **state) {
    (void)state;
    arena *a = arena_new();
    parse(a, "f(p) char *p; { int *q = p; q = 3; g(q); return; }\nint (*h)(int) = f;");
    arena_free(a);
}

static void test_empty_and_odd_sources(void **state) {
    (void)state;
    arena *a = arena_new();
    assert_int_equal(parse(a, "")->function_count, 0);
    assert_int_equal(parse(a, "int x;")->function_count, 0);
    assert_int_equal(parse(a, ";\n__asm__(\"\");\n_Static_assert(1, \"\");")->function_count, 0);
    source *binary = source_from_text(a, "bin.c", "\0\1\2{\xff", 5);
    assert_non_null(frontend_parse(a, binary, 0, NULL).unit);
    source *input = source_from_text(a, "-", "int f(void) { return 1; }", 25);
    assert_int_equal(frontend_parse(a, input, 0, NULL).unit->function_count, 1);
    arena_free(a);
}

/* The function of a cleanup attribute is called at the end of the scope, with the variable's
 * address. So the attribute becomes an opaque child of the variable's declaration. */
static void test_cleanup_attribute_is_opaque(void **state) {
    (void)state;
    static const char *const spellings[] = {"cleanup", "__cleanup__"};
    for (unsigned i = 0; i < 2; i++) {
        arena *a = arena_new();
        const char *text = arena_format(a,
                                        "#define GUARD __attribute__((%s(unlock)))\n"
                                        "void unlock(int *p);\n"
                                        "void f(void) { int z __attribute__((%s(unlock))) = 1;"
                                        " GUARD int w; int plain __attribute__((unused)) = 2; }",
                                        spellings[i], spellings[i]);
        ir_node *const *statements = parse(a, text)->functions[0]->body->children;
        for (unsigned k = 0; k < 2; k++) {
            const ir_node *declarator = statements[k]->children[0];
            assert_int_equal(declarator->child_count, 1);
            assert_int_equal(declarator->children[0]->kind, IR_OPAQUE);
            assert_true(declarator->variable->address_taken);
        }
        assert_int_equal(statements[2]->children[0]->children[0]->kind, IR_NUMBER);
        arena_free(a);
    }
}

/* ---- depth and size ------------------------------------------------------------------------ */

static const char *nested(arena *a, unsigned depth, const char *open, const char *middle,
                          const char *close) {
    buffer b = {0};
    buffer_text(&b, "int f(int n) { return ");
    for (unsigned i = 0; i < depth; i++)
        buffer_text(&b, open);
    buffer_text(&b, middle);
    for (unsigned i = 0; i < depth; i++)
        buffer_text(&b, close);
    buffer_text(&b, "; }\nint g(int n) { return n; }\n");
    const char *text = arena_string(a, b.data);
    buffer_free(&b);
    return text;
}

static void test_depth(void **state) {
    (void)state;
    arena *a = arena_new();
    const ir_unit *fits = parse(a, nested(a, 900, "(1 + ", "n", ")"));
    assert_false(fits->functions[0]->has_errors);
    const ir_unit *deep = parse(a, nested(a, 1500, "-(1 + ", "n", ")"));
    assert_true(ir_function_named(deep, "f")->has_errors);
    assert_false(ir_function_named(deep, "g")->has_errors);
    arena_free(a);
}

/* Many functions that call each other, and many errors: the work must be proportional to their
 * number. Quadratic work would take minutes here. */
static void test_many_functions(void **state) {
    (void)state;
    enum { COUNT = 5000 };
    arena *a = arena_new();
    buffer b = {0};
    for (int i = 0; i < COUNT; i++)
        buffer_format(&b, "int v%d; int f%d(int n) { v%d++; return n ? f%d(n - 1) : v%d; }\n", i, i,
                      i, i > 0 ? i - 1 : 0, i / 2);
    const ir_unit *unit = parse(a, b.data);
    assert_int_equal(unit->function_count, COUNT);
    assert_int_equal(unit->variable_count, 2 * COUNT);
    buffer_free(&b);
    arena_free(a);
}

/* ---- C printed and parsed again ------------------------------------------------------------ */

static bool forget_place(ir_node *node, void *context) {
    (void)context;
    node->range = (ir_range){0};
    return true;
}

/* Returns the IR, without source positions, of the right side of the only assignment. */
static char *tree_of(arena *a, const char *expression, ir_node **node) {
    const char *text = arena_format(
        a,
        "struct s { double v; union { int u; float w; }; int t[3]; };\n"
        "int called(int, double);\n"
        "double f(int a, int b, unsigned c, double x, int *p, double (*m)[3], struct s s,\n"
        "         struct s *q) { return %s; }",
        expression);
    *node = parse(a, text)->functions[0]->body->children[0]->children[0];
    ir_walk(*node, forget_place, NULL);
    buffer b = {0};
    ir_print_node(&b, *node);
    char *tree = arena_string(a, b.data);
    buffer_free(&b);
    return tree;
}

static void test_c_round_trip(void **state) {
    (void)state;
    static const char *const cases[] = {
        "a - (b - c)",
        "(a - b) - c",
        "-(-x)",
        "- -a + +b",
        "~-!a",
        "*p++ + (*p)++ - --*p",
        "(p + a)[b]",
        "b[p]",
        "m[a][1] * (*m)[2] / (*(m + 1))[0]",
        "(double)(a + b) + (int)x",
        "a ? b : c ? x : s.v",
        "(a ? b : c) ? (a = 1, b) : (b = 2)",
        "called((a, b), (x = a, x))",
        "(*called)(1, 2)",
        "s.u + q->w + (*q).t[1] + (&s)->v",
        "a << b >> c & 1 | 2 ^ 3",
        "(a & b) == c && (a || b) && !c",
        "sizeof(struct s) * sizeof a",
        "((int[3]){1, a, b = 2})[1]",
        "((struct s){1.0}).v",
        "&m[1][2] - *m",
        "'a' + 0x1fu + 1e3 + \"abc\"[1]",
        "a = b += c *= 2",
        "a % b * c / 2 - (a + (b + (c)))",
        "*&a",
        "__builtin_fabs(x)",
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        ir_node *node, *again;
        char *tree = tree_of(a, cases[i], &node);
        buffer b = {0};
        if (!ir_c_expression(&b, node, NULL, NULL))
            fail_msg("cannot be spelled: %s", cases[i]);
        assert_string_equal(tree_of(a, b.data, &again), tree);
        buffer_free(&b);
        arena_free(a);
    }
}

static void test_newest_folder(void **state) {
    (void)state;
    char *const folders[] = {"/usr/lib/gcc/x86_64-linux-gnu/10/include",
                             "/usr/lib/gcc/x86_64-linux-gnu/12/include",
                             "/usr/lib/gcc/x86_64-linux-gnu/9/include"};
    assert_string_equal(newest_folder(3, folders), folders[1]);
    assert_null(newest_folder(0, folders));
}

static void test_version(void **state) {
    (void)state;
    arena *a = arena_new();
    assert_non_null(strstr(frontend_version(a), "clang version"));
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ranges_plain),
        cmocka_unit_test(test_ranges_byte_order_mark_and_crlf),
        cmocka_unit_test(test_ranges_utf8),
        cmocka_unit_test(test_ranges_digraphs_and_splices),
        cmocka_unit_test(test_ranges_of_macros),
        cmocka_unit_test(test_loop_that_ends_in_macro_owns_its_bytes),
        cmocka_unit_test(test_flags),
        cmocka_unit_test(test_separate_arguments_of_flags),
        cmocka_unit_test(test_strict_aliasing),
        cmocka_unit_test(test_openmp_pragma_hides_nothing),
        cmocka_unit_test(test_system_headers),
        cmocka_unit_test(test_atomics_header),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_missing_header_taints_all),
        cmocka_unit_test(test_old_c),
        cmocka_unit_test(test_empty_and_odd_sources),
        cmocka_unit_test(test_cleanup_attribute_is_opaque),
        cmocka_unit_test(test_depth),
        cmocka_unit_test(test_many_functions),
        cmocka_unit_test(test_c_round_trip),
        cmocka_unit_test(test_newest_folder),
        cmocka_unit_test(test_version),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
