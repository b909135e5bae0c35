/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Effects of the variables REDCC_... on the example program of docs/generated-code.md. Arguments:
 * the program without OpenMP, one whose owner-checked form writes nothing, and then the program
 * with OpenMP, built by each compiler. */
#include <jansson.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { LONGEST = 4096 };

static const char *plain, *broken;
static char **programs; /* NULL marks the end */
static char folder[64] = "/tmp/redcc-environment-XXXXXX";

struct outcome {
    int status;
    char text[LONGEST];   /* standard output */
    char errors[LONGEST]; /* standard error */
};

static void read_text(const char *name, char *text) {
    FILE *in = fopen(name, "r");
    assert_non_null(in);
    text[fread(text, 1, LONGEST - 1, in)] = '\0';
    fclose(in);
}

static struct outcome run(const char *variables, const char *program, const char *arguments) {
    struct outcome outcome;
    char command[LONGEST], out[128], err[128];
    snprintf(out, sizeof out, "%s/out", folder);
    snprintf(err, sizeof err, "%s/err", folder);
    snprintf(command, sizeof command, "%s '%s' %s >%s 2>%s", variables, program, arguments, out,
             err);
    const int status = system(command);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    read_text(out, outcome.text);
    read_text(err, outcome.errors);
    return outcome;
}

static const char *const methods[] = {"auto",
                                      "serial",
                                      "localwrite",
                                      "localwrite-direct",
                                      "localwrite-steal",
                                      "graph-localwrite",
                                      "graph-localwrite-steal",
                                      "wavefront",
                                      "expansion",
                                      "expansion:a",
                                      "expansion:b",
                                      "pseudo-expansion",
                                      "dwa-lip",
                                      "pe-dwa-lip",
                                      "pe-dwa-lip:3",
                                      "atomic"};
enum { METHODS = sizeof methods / sizeof *methods };

static void the_bits_are_those_of_the_plain_program(void **unused) {
    (void)unused;
    static const char *const exact[] = {"auto",
                                        "serial",
                                        "localwrite",
                                        "localwrite-direct",
                                        "localwrite-steal",
                                        "graph-localwrite",
                                        "graph-localwrite-steal",
                                        "wavefront"};
    const struct outcome expected = run("", plain, "5000 9");
    for (char **program = programs; *program; program++)
        for (int threads = 1; threads <= 5; threads += 2)
            for (int m = 0; m < 8; m++) {
                char variables[128];
                snprintf(variables, sizeof variables, "OMP_NUM_THREADS=%d REDCC_METHOD=%s", threads,
                         exact[m]);
                const struct outcome found = run(variables, *program, "5000 9");
                assert_int_equal(found.status, 0);
                assert_string_equal(found.text, expected.text);
                assert_string_equal(found.errors, "");
            }
}

static void every_method_by_name(void **unused) {
    (void)unused;
    for (char **program = programs; *program; program++)
        for (int m = 0; m < METHODS; m++) {
            char variables[128];
            snprintf(variables, sizeof variables, "OMP_NUM_THREADS=4 REDCC_METHOD=%s", methods[m]);
            const struct outcome found = run(variables, *program, "300 2");
            assert_int_equal(found.status, 0);
            assert_string_equal(found.errors, "");
        }
}

static json_t *report_of(const char *variables, const char *arguments) {
    char all[512], name[128];
    snprintf(name, sizeof name, "%s/report \"x\".json", folder);
    snprintf(all, sizeof all, "%s REDCC_REPORT='%s'", variables, name);
    const struct outcome found = run(all, programs[0], arguments);
    assert_int_equal(found.status, 0);
    json_error_t error;
    json_t *report = json_load_file(name, 0, &error);
    if (!report)
        fail_msg("the report is no JSON: line %d: %s", error.line, error.text);
    assert_int_equal(unlink(name), 0);
    return report;
}

static long number(const json_t *loop, const char *key) {
    const json_t *value = json_object_get(loop, key);
    assert_true(json_is_number(value));
    return (long)json_number_value(value);
}

static void expect_stop(const char *variables, const char *const *words) {
    const struct outcome found = run(variables, programs[0], "10 1");
    assert_int_equal(found.status, 2);
    for (; *words; words++)
        if (!strstr(found.errors, *words))
            fail_msg("%s: '%s' is not in: %s", variables, *words, found.errors);
}

static void unknown_names_stop_the_program(void **unused) {
    (void)unused;
    expect_stop("REDCC_METHOD=localwrit",
                (const char *[]){"REDCC_METHOD=localwrit", "did you mean localwrite?", "dwa-lip",
                                 "expansion[:a|b]", "serial", "auto", NULL});
    expect_stop("REDCC_METHOD=expansion:c", (const char *[]){"expansion[:a|b]", NULL});
    expect_stop("REDCC_METHOD=pe-dwa-lip:0", (const char *[]){"pe-dwa-lip[:N]", NULL});
    expect_stop("REDCC_METHOD=serial:2", (const char *[]){"serial", NULL});
    expect_stop("REDCC_ORDER=seriel", (const char *[]){"REDCC_ORDER=seriel", "did you mean serial?",
                                                       "fixed", "any", NULL});
    expect_stop("REDCC_MEMORY_LIMIT=much", (const char *[]){"REDCC_MEMORY_LIMIT=much", NULL});
}

static void expect_method(const char *variables, const char *method) {
    json_t *report = report_of(variables, "300 2");
    const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
    assert_string_equal(json_string_value(json_object_get(loop, "method")), method);
    json_decref(report);
}

static void methods_of_single_loops(void **unused) {
    (void)unused;
#define SINGLE "OMP_NUM_THREADS=3 REDCC_METHOD="
    expect_method(SINGLE "springs.c:4=localwrite", "localwrite");
    expect_method(SINGLE "springs.c:4=pe-dwa-lip:3,atomic", "pe-dwa-lip:3");
    expect_method(SINGLE "atomic,/some/where/springs.c:4=wavefront", "wavefront");
    expect_method(SINGLE "localwrite,springs.c:4=serial", "serial");
    /* the loop is too short for auto */
    expect_method(SINGLE "localwrite,springs.c:4=auto", "serial");
    expect_method(SINGLE "springs.c:5=serial,localwrite", "localwrite");
    expect_method(SINGLE "xsprings.c:4=serial,localwrite", "localwrite");
    const char *unmet = SINGLE "localwrite,springs.c:9=serial,string.c:4=atomic,springs.c:4=atomic";
    const struct outcome found = run(unmet, programs[0], "300 2");
    assert_int_equal(found.status, 0);
    assert_non_null(strstr(found.errors,
                           "REDCC_METHOD names springs.c:9, but no translated loop that "
                           "was executed is there; the nearest is springs.c:4\n"));
    assert_non_null(strstr(found.errors, "names string.c:4"));
    assert_null(strstr(found.errors, "names springs.c:4"));
    expect_stop("REDCC_METHOD=springs.c:4=localwrit",
                (const char *[]){"did you mean localwrite?", "pe-dwa-lip[:N]", NULL});
    expect_stop("REDCC_METHOD=springs.c=serial",
                (const char *[]){"'springs.c' is no FILE:LINE", "REDCC_REPORT=-", NULL});
    expect_stop("REDCC_METHOD=springs.c:4x=serial", (const char *[]){"'springs.c:4x'", NULL});
    expect_stop("REDCC_METHOD=:4=serial", (const char *[]){"':4' is no FILE:LINE", NULL});
    expect_stop("REDCC_METHOD=springs.c:0=serial", (const char *[]){"no FILE:LINE", NULL});
    expect_stop("REDCC_METHOD=springs.c:4=", (const char *[]){"is not known", NULL});
    expect_stop("REDCC_METHOD=atomic,,", (const char *[]){"names two methods for all", NULL});
    expect_stop("REDCC_METHOD=atomic,serial", (const char *[]){"names two methods for all", NULL});
    expect_stop("REDCC_METHOD=springs.c:4=serial,tests/springs.c:4=atomic",
                (const char *[]){"two methods for tests/springs.c:4", NULL});
    expect_stop("REDCC_SUM=compensated REDCC_METHOD=springs.c:4=expansion",
                (const char *[]){"expansion", "REDCC_SUM=compensated", NULL});
    expect_stop("REDCC_ORDER=serial REDCC_METHOD=springs.c:4=dwa-lip",
                (const char *[]){"REDCC_METHOD=dwa-lip cannot keep order serial", NULL});
}

static void unknown_variables_are_noted(void **unused) {
    (void)unused;
    const struct outcome found =
        run("REDCC_METHDO=serial OMP_NUM_THREADS=2 REDCC_KEEP=/x REDCC_DISABEL=1 REDCC_CC=gcc "
            "REDCC_OPTS= REDCC_STRICT=1 REDCC_ROOT=/x REDCC_BUILD_REPORT=x REDCC_CACHE=off "
            "REDCC_CACHE_SIZE=1M XREDCC_METHOD=1",
            programs[0], "300 2");
    assert_int_equal(found.status, 0);
    assert_string_equal(found.errors,
                        "redcc: the variable REDCC_METHDO is not known, and is ignored; "
                        "the nearest known is REDCC_METHOD\n");
    assert_string_equal(run("REDCC_METHDO=serial", plain, "300 2").errors, "");
}

static void unknown_sums_traces_and_validations(void **unused) {
    (void)unused;
    expect_stop("REDCC_SUM=compensatd",
                (const char *[]){"compensatd", "did you mean compensated", "plain", NULL});
    expect_stop("REDCC_TRACE=plan,exection",
                (const char *[]){"exection", "did you mean execution", "choice", "plan",
                                 "validation", NULL});
    expect_stop("REDCC_VALIDATE=yes", (const char *[]){"REDCC_VALIDATE=yes", "0 1", NULL});
    expect_stop("REDCC_WATCH=on", (const char *[]){"REDCC_WATCH=on", "off auto", NULL});
    expect_stop("REDCC_PREFETCH=of", (const char *[]){"did you mean off", "auto on", NULL});
    expect_stop("REDCC_LANES=16", (const char *[]){"REDCC_LANES=16", "off auto", NULL});
    expect_stop("REDCC_SUM=compensated REDCC_METHOD=expansion",
                (const char *[]){"expansion", "REDCC_SUM=compensated", "localwrite", NULL});
    expect_stop("REDCC_SUM=compensated REDCC_METHOD=serial",
                (const char *[]){"REDCC_METHOD=serial", "localwrite", NULL});
}

static void validation_is_passed(void **unused) {
    (void)unused;
    for (int m = 0; m < METHODS; m++) {
        char variables[128];
        snprintf(variables, sizeof variables, "OMP_NUM_THREADS=3 REDCC_METHOD=%s", methods[m]);
        const struct outcome alone = run(variables, programs[0], "5000 3");
        snprintf(variables, sizeof variables, "REDCC_VALIDATE=1 OMP_NUM_THREADS=3 REDCC_METHOD=%s",
                 methods[m]);
        const struct outcome looked_at = run(variables, programs[0], "5000 3");
        assert_int_equal(looked_at.status, 0);
        if (strcmp(methods[m], "atomic") != 0) /* atomic gives other bits in each run */
            assert_string_equal(looked_at.text, alone.text);
        const bool serial = strcmp(methods[m], "serial") == 0;
        assert_non_null(strstr(looked_at.errors,
                               serial ? "springs.c:4 (springs): never ran in parallel, 3 calls: "
                                        "REDCC_METHOD says serial"
                                      : "springs.c:4 (springs): 3 executions"));
        assert_non_null(strstr(looked_at.errors, serial
                                                     ? "validated: 0 loops ran in parallel"
                                                     : "validated: 1 of 1 loops ran in parallel"));
        if (strcmp(methods[m], "localwrite") == 0)
            assert_non_null(
                strstr(looked_at.errors, "no difference in ulps; order serial is kept"));
    }
}

/* auto begins with the sequential loop. With REDCC_VALIDATE=1 even the first call runs in parallel,
 * since it may be the only one. */
static void validation_of_a_loop_executed_once(void **unused) {
    (void)unused;
    static const char *const settings[] = {"", "REDCC_METHOD=auto ",
                                           "REDCC_METHOD=springs.c:4=auto ", "REDCC_ORDER=any "};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        char variables[128];
        snprintf(variables, sizeof variables, "%sREDCC_VALIDATE=1 OMP_NUM_THREADS=3", settings[i]);
        const struct outcome found = run(variables, programs[0], "30 1");
        assert_int_equal(found.status, 0);
        assert_non_null(strstr(found.errors, "springs.c:4 (springs): 1 executions compared, no "
                                             "difference in ulps; order "));
        assert_non_null(strstr(found.errors, "validated: 1 of 1 loops ran in parallel\n"));
        assert_int_equal(run(variables, broken, "30 1").status, 3);
    }
    struct outcome found = run("REDCC_VALIDATE=1 OMP_NUM_THREADS=1", programs[0], "30 1");
    assert_int_equal(found.status, 0);
    assert_non_null(
        strstr(found.errors, "(springs): never ran in parallel, 1 calls: one thread\n"));
    assert_non_null(
        strstr(found.errors, "validated: 0 loops ran in parallel: the reasons are above"));
    found = run("REDCC_VALIDATE=1 OMP_NUM_THREADS=3", programs[0], "30 0");
    assert_non_null(
        strstr(found.errors, "0 loops ran in parallel: no translated loop was executed"));
}

static void validation_is_failed(void **unused) {
    (void)unused;
    const char *variables = "REDCC_VALIDATE=1 OMP_NUM_THREADS=3 REDCC_METHOD=localwrite";
    const struct outcome found = run(variables, broken, "2000 4");
    assert_int_equal(found.status, 3);
    assert_int_equal(strlen(found.text), 17); /* the program's whole output */
    assert_non_null(strstr(found.errors, "the promise of order serial is BROKEN in 4 of them"));
    assert_non_null(strstr(found.errors, "of s->b"));
    assert_int_equal(run("OMP_NUM_THREADS=3 REDCC_METHOD=localwrite", broken, "2000 4").status, 0);
}

static void what_is_traced(void **unused) {
    (void)unused;
    const char *method = "OMP_NUM_THREADS=3 REDCC_METHOD=localwrite";
    char variables[128];
    snprintf(variables, sizeof variables, "%s REDCC_TRACE=plan,execution", method);
    struct outcome found = run(variables, programs[0], "2000 2");
    assert_non_null(strstr(found.errors, "redcc: plan: springs.c:4 (springs): built: localwrite"));
    assert_non_null(strstr(found.errors, "used again: localwrite, 3 threads"));
    assert_non_null(strstr(found.errors, "redcc: execution: springs.c:4 (springs): 6000 iter"));
    assert_null(strstr(found.errors, "choice"));
    found = run("OMP_NUM_THREADS=2 REDCC_TRACE=plan REDCC_METHOD=spare-localwrite", programs[0],
                "2000 1"); /* `spare-localwrite` is an older name of the method */
    assert_non_null(strstr(found.errors, "built: localwrite-steal"));
    found = run("OMP_NUM_THREADS=2 REDCC_TRACE=plan REDCC_METHOD=spare-graph-localwrite",
                programs[0], "2000 1");
    assert_non_null(strstr(found.errors, "built: graph-localwrite-steal"));
    snprintf(variables, sizeof variables, "OMP_NUM_THREADS=1 REDCC_TRACE=choice");
    found = run(variables, programs[0], "2000 2");
    assert_non_null(strstr(found.errors, "redcc: choice: springs.c:4 (springs): the original loop: "
                                         "one thread"));
    assert_string_equal(run(method, programs[0], "2000 2").errors, "");
}

static void an_order_and_a_method_that_cannot_keep_it(void **unused) {
    (void)unused;
    const char *const words[] = {"REDCC_METHOD=dwa-lip", "springs.c:4", "order", NULL};
    expect_stop("REDCC_METHOD=dwa-lip REDCC_ORDER=serial", words);
    expect_stop("REDCC_METHOD=dwa-lip REDCC_ORDER=fixed", words);
    assert_int_equal(run("REDCC_METHOD=dwa-lip REDCC_ORDER=any", programs[0], "10 1").status, 0);
    assert_int_equal(run("REDCC_METHOD=localwrite REDCC_ORDER=fixed", programs[0], "10 1").status,
                     0);
}

static void the_report_says_what_was_done(void **unused) {
    (void)unused;
    json_t *report = report_of("OMP_NUM_THREADS=3 REDCC_METHOD=localwrite", "2000 5");
    const json_t *loops = json_object_get(report, "loops");
    assert_true(number(report, "process") > 1);
    assert_true(number(report, "started") > 1);
    assert_true(number(report, "cores_lost") >= 0);
    assert_true(json_is_real(json_object_get(report, "seconds")));
    assert_int_equal(json_array_size(loops), 1);
    const json_t *loop = json_array_get(loops, 0);
    assert_string_equal(json_string_value(json_object_get(loop, "file")), "springs.c");
    assert_string_equal(json_string_value(json_object_get(loop, "function")), "springs");
    assert_string_equal(json_string_value(json_object_get(loop, "method")), "localwrite");
    assert_string_equal(json_string_value(json_object_get(loop, "mode")), "reused");
    assert_string_equal(json_string_value(json_object_get(loop, "rule")), "named");
    assert_string_equal(json_string_value(json_object_get(loop, "order")), "serial");
    assert_int_equal(number(loop, "line"), 4);
    assert_int_equal(number(loop, "plans_lost"), 0);
    assert_int_equal(json_array_size(json_object_get(loop, "changed")), 0);
    assert_int_equal(number(loop, "sequential_calls"), 0);
    assert_true(json_is_null(json_object_get(loop, "speedup")));
    assert_int_equal(number(loop, "threads"), 3);
    assert_int_equal(number(loop, "calls"), 5);
    assert_int_equal(number(loop, "plans_built"), 1);
    assert_int_equal(number(loop, "plans_reused"), 4);
    assert_int_equal(number(loop, "watched"), 0); /* subscripts of only 48 KB are always read */
    assert_int_equal(number(loop, "stages"), 1);
    assert_in_range(number(loop, "nodes"), 0, 3);
    assert_in_range(number(loop, "moves"), 0, 4 * 3);
    assert_in_range(number(loop, "iterations"), 5 * 6000, 5 * 6600);
    assert_true(number(loop, "extra_bytes") > 0);
    assert_true(json_is_real(json_object_get(loop, "inspect_seconds")));
    assert_true(json_is_real(json_object_get(loop, "execute_seconds")));
    assert_true(json_number_value(json_object_get(loop, "replication")) >= 1.0);
    assert_int_equal(json_array_size(json_object_get(loop, "fallbacks")), 0);
    json_decref(report);
}

/* Compensated sums have the same bits at every thread count. These bits differ from those of plain
 * sums. */
static void compensated_sums(void **unused) {
    (void)unused;
    const struct outcome one =
        run("REDCC_SUM=compensated OMP_NUM_THREADS=1", programs[0], "5000 9");
    assert_int_equal(one.status, 0);
    assert_string_not_equal(one.text, run("", plain, "5000 9").text);
    for (char **program = programs; *program; program++)
        for (int threads = 2; threads <= 6; threads += 2) {
            char variables[128];
            snprintf(variables, sizeof variables, "REDCC_SUM=compensated OMP_NUM_THREADS=%d",
                     threads);
            assert_string_equal(run(variables, *program, "5000 9").text, one.text);
        }
    json_t *report = report_of("REDCC_SUM=compensated OMP_NUM_THREADS=2 REDCC_VALIDATE=1", "500 3");
    const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
    assert_string_equal(json_string_value(json_object_get(loop, "sum")), "compensated");
    assert_int_equal(number(loop, "validated"), 3);
    assert_int_equal(number(loop, "promises_broken"), 0);
    json_decref(report);
}

static int threads_of(const char *variables, const char *arguments) {
    json_t *report = report_of(variables, arguments);
    const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
    const int threads = (int)number(loop, "threads");
    json_decref(report);
    return threads;
}

/* Few iterations do not repay waking threads, and before the first call no time is known. A named
 * method always runs. */
static void compensated_sums_of_few_iterations(void **unused) {
    (void)unused;
    assert_int_equal(threads_of("REDCC_SUM=compensated OMP_NUM_THREADS=2", "20 1"), 1);
    assert_int_equal(threads_of("REDCC_SUM=compensated OMP_NUM_THREADS=2", "5000 9"), 2);
    assert_int_equal(
        threads_of("REDCC_SUM=compensated REDCC_METHOD=localwrite OMP_NUM_THREADS=2", "20 9"), 2);
}

static void expect_least_trip(const char *variables, const char *expected) {
    const struct outcome found = run(variables, programs[0], "20 1 and");
    assert_int_equal(found.status, 0);
    if (!strstr(found.text, expected))
        fail_msg("%s: not '%s': %s", variables, expected, found.text);
}

/* Explicit settings hold for any trip count. */
static void few_short_iterations(void **unused) {
    (void)unused;
    expect_least_trip("", "131072 unasked, from 1024\n");
    expect_least_trip("REDCC_CACHE=off REDCC_OPTS=", "131072 unasked, from 1024\n");
    expect_least_trip("REDCC_CACH=off", "0 unasked, from 1024\n");
    expect_least_trip("REDCC_METHOD=auto REDCC_ORDER=any", "0 unasked, from 1024\n");
    expect_least_trip("REDCC_METHOD=localwrite", "0 unasked, from 0\n");
    expect_least_trip("REDCC_SUM=compensated", "from 0\n");
    expect_least_trip("REDCC_VALIDATE=1", "from 0\n");
}

static void expect_fallback(const char *variables, const char *slug, const char *reason,
                            long count) {
    json_t *report = report_of(variables, "2000 5");
    const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
    const json_t *fallbacks = json_object_get(loop, "fallbacks");
    assert_int_equal(json_array_size(fallbacks), 1);
    const json_t *fallback = json_array_get(fallbacks, 0);
    assert_string_equal(json_string_value(json_object_get(fallback, "slug")), slug);
    assert_string_equal(json_string_value(json_object_get(loop, "mode")), "sequential");
    assert_non_null(strstr(json_string_value(json_object_get(fallback, "reason")), reason));
    assert_int_equal(number(fallback, "count"), count);
    assert_string_equal(json_string_value(json_object_get(loop, "method")), "serial");
    json_decref(report);
}

static void the_report_says_what_binds_the_threads(void **unused) {
    (void)unused;
    json_t *report = report_of("OMP_NUM_THREADS=2 REDCC_METHOD=localwrite OMP_PROC_BIND=spread "
                               "OMP_PLACES=cores",
                               "2000 5");
    const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
    assert_string_equal(json_string_value(json_object_get(report, "proc_bind")), "spread");
    assert_string_equal(json_string_value(json_object_get(report, "places")), "cores");
    assert_int_equal(number(loop, "moves"), 0);
    json_decref(report);
}

/* auto's first call is the original loop, which is timed. If the loop is short, all calls are. */
static void the_report_says_what_the_sequential_loop_took(void **unused) {
    (void)unused;
    json_t *report = report_of("OMP_NUM_THREADS=3", "50000 1");
    const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
    assert_string_equal(json_string_value(json_object_get(loop, "mode")), "timed");
    assert_string_equal(json_string_value(json_object_get(loop, "rule")), "first");
    assert_int_equal(number(loop, "sequential_calls"), 1);
    assert_true(json_number_value(json_object_get(loop, "sequential_seconds")) > 0);
    assert_true(json_is_null(json_object_get(loop, "speedup")));
    json_decref(report);
}

static void the_report_says_why_not(void **unused) {
    (void)unused;
    expect_fallback("OMP_NUM_THREADS=1 REDCC_METHOD=localwrite", "one-thread", "one thread", 5);
    expect_fallback("OMP_NUM_THREADS=3 REDCC_METHOD=serial", "named-serial", "says serial", 5);
    expect_fallback("OMP_NUM_THREADS=3 REDCC_METHOD=expansion REDCC_MEMORY_LIMIT=24K", "no-memory",
                    "REDCC_MEMORY_LIMIT", 5);
    /* a memory limit that prevents every plan changes neither the report nor the methods of single
     * loops */
    expect_fallback("OMP_NUM_THREADS=3 REDCC_METHOD=localwrite REDCC_MEMORY_LIMIT=1", "no-memory",
                    "REDCC_MEMORY_LIMIT", 5);
}

/* springs.c has no form for tiles. */
static void the_report_names_a_method_that_can(void **unused) {
    (void)unused;
    const char *const variables[] = {"OMP_NUM_THREADS=3 REDCC_METHOD=tiles",
                                     "OMP_NUM_THREADS=3 REDCC_METHOD=springs.c:4=tiles"};
    for (int i = 0; i < 2; i++) {
        expect_fallback(variables[i], "no-tiles", "no form for tiles", 5);
        json_t *report = report_of(variables[i], "2000 5");
        const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
        const char *why = json_string_value(json_object_get(loop, "why_sequential"));
        assert_non_null(why);
        assert_non_null(strstr(why, "tiles cannot execute this loop, but localwrite can: "));
        json_decref(report);
    }
}

static void the_report_names_the_method_with_its_parameter(void **unused) {
    (void)unused;
    for (int m = 2; m < METHODS; m++) {
        char variables[128];
        snprintf(variables, sizeof variables, "OMP_NUM_THREADS=4 REDCC_METHOD=%s", methods[m]);
        json_t *report = report_of(variables, "300 2");
        const json_t *loop = json_array_get(json_object_get(report, "loops"), 0);
        const char *name = json_string_value(json_object_get(loop, "method"));
        const char *expected = strcmp(methods[m], "expansion:b") == 0  ? "expansion"
                               : strcmp(methods[m], "pe-dwa-lip") == 0 ? "pe-dwa-lip:2"
                                                                       : methods[m];
        assert_string_equal(name, expected);
        assert_string_equal(json_string_value(json_object_get(loop, "order")),
                            m <= 7 ? "serial" : "any");
        json_decref(report);
    }
}

int main(int count, char **arguments) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bits_are_those_of_the_plain_program),
        cmocka_unit_test(every_method_by_name),
        cmocka_unit_test(unknown_names_stop_the_program),
        cmocka_unit_test(unknown_sums_traces_and_validations),
        cmocka_unit_test(validation_is_passed),
        cmocka_unit_test(validation_of_a_loop_executed_once),
        cmocka_unit_test(validation_is_failed),
        cmocka_unit_test(methods_of_single_loops),
        cmocka_unit_test(unknown_variables_are_noted),
        cmocka_unit_test(the_report_says_what_the_sequential_loop_took),
        cmocka_unit_test(what_is_traced),
        cmocka_unit_test(compensated_sums),
        cmocka_unit_test(compensated_sums_of_few_iterations),
        cmocka_unit_test(few_short_iterations),
        cmocka_unit_test(an_order_and_a_method_that_cannot_keep_it),
        cmocka_unit_test(the_report_says_what_was_done),
        cmocka_unit_test(the_report_says_what_binds_the_threads),
        cmocka_unit_test(the_report_says_why_not),
        cmocka_unit_test(the_report_names_a_method_that_can),
        cmocka_unit_test(the_report_names_the_method_with_its_parameter),
    };
    if (count < 4 || !mkdtemp(folder))
        return 1;
    plain = arguments[1];
    broken = arguments[2];
    programs = arguments + 3;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command) != 0 || failed;
}
