/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tests verdicts on IR text, without a compiler, and parts of the analysis with a contract of their own. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "analysis/base/counted.h"
#include "analysis/base/library.h"
#include "analysis/base/reason.h"
#include "expectation.h"
#include "ir_reader/ir_read.h"

static ir_unit *read_unit(arena *a, const char *text) {
    const char *message = NULL;
    ir_unit *unit = ir_read(a, text, strlen(text), &message);
    if (!unit)
        fail_msg("%s", message);
    return unit;
}

/* Returns a function with one loop around `body`, with parameters h and e (double *), s and g (int *). */
static ir_unit *unit_around(arena *a, const char *header, const char *body) {
    return read_unit(
        a, arena_format(a,
                        "(unit \"t.c\" (bytes 1000)\n"
                        " (global total double)\n"
                        " (function unknown double (parameter v double))\n"
                        " (function f void (parameter n int) (parameter s ptr(const(int)))\n"
                        "  (parameter e ptr(double)) (parameter h restrict(ptr(double)))\n"
                        "  (parameter g ptr(int)) (parameter m uint)\n"
                        "  (block @100-900 (for @110-890 %s (block @200-880 %s)))))",
                        header, body));
}

static const char usual[] =
    "(declaration @115-120 (declarator t int 0)) (< (variable t) (variable n)) (_++ (variable t))";

typedef struct verdict_case {
    const char *name;
    const char *body;
    const char *expected;
} verdict_case;

static const verdict_case cases[] = {
    {"plain", "(+= @210-220 (index h (index s t)) (index e t))",
     "transform h(+) guards=0 verifiable privates=0"},
    {"increment", "(_++ @210-220 (index g (index s t)))",
     "transform g(+) guards=1 verifiable privates=0"},
    {"local index",
     "(declaration @210-220 (declarator k int (index s t))) (+= @230-240 (index h k) 1.0)",
     "transform h(+) guards=0 verifiable privates=0"},
    {"operator", "(/= @210-220 (index h (index s t)) 2.0)", "transform h(kept)"},
    {"two operators",
     "(+= @210-220 (index h (index s t)) 2.0) (*= @230-240 (index h (index s t)) 2.0)",
     "transform h(+,kept)"},
    {"value used", "(= @210-220 (variable total) (+= (index h (index s t)) 1.0))",
     "refuse update-value-used"},
    {"read", "(+= @210-220 (index h (index s t)) (index h t))", "refuse array-read"},
    {"store", "(= @210-220 (index e t) 1.0) (+= @230-240 (index h (index s t)) 1.0)",
     "transform h(+) e(kept)"},
    {"store read again",
     "(= @210-220 (index e t) 1.0) (+= @230-240 (index h (index s t)) (index e t))",
     "transform h(+) e(kept)"},
    {"store read before",
     "(+= @210-220 (index h (index s t)) (index e t)) (= @230-240 (index e t) 1.0)",
     "transform h(+) guards=0 verifiable privates=0"},
    {"store read before, of what is read",
     "(+= @210-220 (index h (index s t)) (index e t)) (= @230-240 (index e t) (index e 3))",
     "refuse other-store"},
    {"call", "(+= @210-220 (index h (index s t)) (call unknown 1.0))", "refuse impure-call"},
    {"return", "(+= @210-220 (index h (index s t)) 1.0) (return @230-240)", "refuse return"},
    {"opaque", "(+= @210-220 (index h (index s t)) 1.0) (opaque \"asm\" @230-240)",
     "refuse opaque"},
    {"counter", "(+= @210-220 (index h (index s t)) 1.0) (_++ @230-240 (variable t))",
     "refuse counter-modified"},
    {"no range", "(+= (index h (index s t)) 1.0)", "refuse no-range"},
    {"macro around", "(+= @210-220 (index h (+ !macro (index s t) 1)) 1.0)",
     "transform h(+) guards=0 verifiable privates=0"},
};

static void verdicts(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        arena *a = arena_new();
        ir_unit *unit = unit_around(a, usual, cases[i].body);
        analysis_result result = analyse(a, unit, NULL);
        if (result.verdict_count != 1)
            fail_msg("%s: %u verdicts", cases[i].name, result.verdict_count);
        const char *found = expectation_describe(a, &result.verdicts[0]);
        if (strncmp(found, cases[i].expected, strlen(cases[i].expected)) != 0)
            fail_msg("%s: '%s' instead of '%s'", cases[i].name, found, cases[i].expected);
        arena_free(a);
    }
}

static void regular_loops_are_listed_on_demand(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *unit = unit_around(a, usual, "(+= @210-220 (index h t) 1.0)");
    analysis_options options = {.report_all = true};
    assert_int_equal(analyse(a, unit, NULL).verdict_count, 0);
    analysis_result all = analyse(a, unit, &options);
    assert_int_equal(all.verdict_count, 1);
    assert_int_equal(all.verdicts[0].kind, VERDICT_NOT_A_REDUCTION);
    arena_free(a);
}

static void slice_has_what_subscripts_need(void **state) {
    (void)state;
    arena *a = arena_new();
    ir_unit *unit = unit_around(a, usual,
                                "(declaration @210-220 (declarator k int (index s t)))"
                                "(declaration @221-229 (declarator d double (index e t)))"
                                "(+= @230-240 (index h k) (* d 2.0))");
    analysis_result result = analyse(a, unit, NULL);
    assert_int_equal(result.verdicts[0].kind, VERDICT_TRANSFORM);
    const loop_facts *facts = result.verdicts[0].facts;
    const ir_node *body = facts->counted.body;
    assert_true(facts->slice.holds[body->id]);
    assert_true(facts->slice.holds[body->children[0]->children[0]->id]);
    assert_false(facts->slice.holds[body->children[1]->children[0]->id]);
    assert_false(facts->slice.holds[body->children[2]->id]);
    /* the only source is the subscript array; since h is restrict, e needs no guard */
    assert_int_equal(facts->source_count, 1);
    assert_string_equal(facts->sources[0].name, "s");
    assert_true(facts->sources[0].is_subscript);
    assert_int_equal(facts->sources[0].extent, EXTENT_AFFINE);
    assert_false(facts->sources[0].needs_guard);
    arena_free(a);
}

/* ---- loop headers ---------------------------------------------------------------------------- */

typedef struct header_case {
    const char *header;
    bool is_counted;
    int64_t step;
    ir_operator comparison;
    reason_id why;
} header_case;

static const header_case headers[] = {
    {"(= t2 0) (< t2 n) (_++ t2)", true, 1, IR_OP_LESS, REASON_NONE},
    {"(= t2 0) (> n t2) (_++ t2)", true, 1, IR_OP_LESS, REASON_NONE},
    {"(= t2 n) (>= t2 0) (-= t2 2)", true, -2, IR_OP_GREATER_EQUAL, REASON_NONE},
    {"(= t2 n) (!= t2 0) (--_ t2)", true, -1, IR_OP_NOT_EQUAL, REASON_NONE},
    {"(= t2 0) (< t2 n) (= t2 (+ 3 t2))", true, 3, IR_OP_LESS, REASON_NONE},
    {"(empty) (< t2 n) (_++ t2)", true, 1, IR_OP_LESS, REASON_NONE},
    {"(= t2 0) (< t2 m) (_++ t2)", true, 1, IR_OP_LESS, REASON_NONE},
    {"(= t2 n) (< t2 m) (_++ t2)", false, 0, IR_OP_NONE, REASON_COUNTER_WRAPS},
    {"(= m 0) (<= m n) (_++ m)", false, 0, IR_OP_NONE, REASON_COUNTER_WRAPS},
    {"(= m 9) (>= m 0) (_-- m)", false, 0, IR_OP_NONE, REASON_COUNTER_WRAPS},
    {"(= m 9) (> m 0) (_-- m)", true, -1, IR_OP_GREATER, REASON_NONE},
    {"(= t2 0) (< t2 n) (_-- t2)", false, 0, IR_OP_NONE, REASON_STEP},
    {"(= t2 0) (!= t2 n) (+= t2 2)", false, 0, IR_OP_NONE, REASON_STEP},
    {"(= t2 0) (< t2 n) (+= t2 n)", false, 0, IR_OP_NONE, REASON_STEP},
    {"(= t2 0) (< (+ t2 1) n) (_++ t2)", false, 0, IR_OP_NONE, REASON_TRIP_COUNT},
    {"(= t2 0) (empty) (_++ t2)", false, 0, IR_OP_NONE, REASON_TRIP_COUNT},
    {"(= t2 0) (< t2 (call limit)) (_++ t2)", false, 0, IR_OP_NONE, REASON_TRIP_COUNT},
};

static void loop_headers(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof headers / sizeof headers[0]; i++) {
        arena *a = arena_new();
        ir_unit *unit =
            read_unit(a, arena_format(a,
                                      "(unit \"t.c\" (bytes 1000) (function limit int)\n"
                                      " (function f void (parameter n int) (parameter m uint)\n"
                                      "  (local t2 int) (block (for %s (block)))))",
                                      headers[i].header));
        const ir_function *f = ir_function_named(unit, "f");
        counted_result r = counted_recognise(f->body->children[0]);
        if (r.is_counted != headers[i].is_counted)
            fail_msg("%s: counted %d", headers[i].header, r.is_counted);
        if (r.is_counted) {
            assert_int_equal(r.loop.step, headers[i].step);
            assert_int_equal(r.loop.comparison, headers[i].comparison);
        } else if (r.why != headers[i].why) {
            fail_msg("%s: %s", headers[i].header, reason_slug(r.why));
        }
        arena_free(a);
    }
}

/* ---- lists ----------------------------------------------------------------------------------- */

static void library_finds_all_of_its_kind(void **state) {
    (void)state;
    static const char *const known[] = {
        "sqrt",  "sqrtf", "sqrtl", "__builtin_fabs", "abs",
        "labs",  "llabs", "trunc", "fmin",           "atan2",
        "erf",   "hypot", "pow",   "__builtin_clz",  "__builtin_ctzll",
        "log1p", "cabsf", "fmaxl", "__builtin_inff", "cosh"};
    static const char *const others[] = {
        "frexp",   "modf",  "lgamma",     "rand",   "sincos", "f",         "l",      "",
        "absurd",  "mall",  "__builtin_", "clz",    "absf",   "labsl",     "parity", "exp10",
        "expectf", "isnan", "inf",        "llabsf", "clzf",   "popcountll"};
    const ir_unit unit = {0};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (!library_find(&unit, &(ir_function){.name = known[i]}))
            fail_msg("%s", known[i]);
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (library_find(&unit, &(ir_function){.name = others[i]}))
            fail_msg("%s", others[i]);
}

/* Whether a name is the library's depends on the standard and on the name's declaration. */
static void library_names_are_reserved(void **state) {
    (void)state;
    const ir_unit old = {.dialect.is_c89 = true}, new = {0};
    ir_node body = {.kind = IR_BLOCK};
    assert_non_null(library_find(&old, &(ir_function){.name = "sqrt"}));
    assert_null(library_find(&old, &(ir_function){.name = "round"}));
    assert_non_null(library_find(&old, &(ir_function){.name = "round", .is_from_system = true}));
    assert_non_null(library_find(&new, &(ir_function){.name = "round"}));
    assert_non_null(library_find(&new, &(ir_function){.name = "exp10", .is_from_system = true}));
    assert_null(library_find(&new, &(ir_function){.name = "parity", .is_from_system = true}));
    assert_null(library_find(&new, &(ir_function){.name = "sqrt", .linkage.is_renamed = true}));
    assert_null(library_find(&new, &(ir_function){.name = "sqrt", .body = &body}));
}

static char *file_text(const char *path) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    long length = ftell(file);
    rewind(file);
    char *text = calloc((size_t)length + 1, 1);
    assert_int_equal(fread(text, 1, (size_t)length, file), length);
    fclose(file);
    return text;
}

static void each_reason_is_documented_and_named_once(void **state) {
    (void)state;
    arena *a = arena_new();
    char *text = file_text(REASONS_DOCUMENT);
    for (int id = 1; id < REASON_COUNT; id++) {
        const char *heading =
            arena_format(a, "\n## %s %s\n", reason_code((reason_id)id), reason_slug((reason_id)id));
        if (!strstr(text, heading))
            fail_msg("docs/reasons.md has no '%s'", heading);
        if (!reason_make(a, (reason_id)id, "x", (ir_range){0}).advice && id != REASON_IGNORED)
            fail_msg("'%s' has no advice", heading);
        for (int other = 1; other < id; other++) {
            assert_string_not_equal(reason_code((reason_id)id), reason_code((reason_id)other));
            assert_string_not_equal(reason_slug((reason_id)id), reason_slug((reason_id)other));
        }
    }
    assert_null(reason_code(REASON_NONE));
    free(text);
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(verdicts),
        cmocka_unit_test(regular_loops_are_listed_on_demand),
        cmocka_unit_test(slice_has_what_subscripts_need),
        cmocka_unit_test(loop_headers),
        cmocka_unit_test(library_finds_all_of_its_kind),
        cmocka_unit_test(library_names_are_reserved),
        cmocka_unit_test(each_reason_is_documented_and_named_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
