/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The report's counters, and its pages, which must list exactly the existing slugs and
 * variables. */
#include "base/memory.h"
#include "loop.h"
#include "problem.h"
#include "settings.h"
#include "variables.h"
#include "why.h"

#include <ctype.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { THREADS = 3 };

/* ---- the pages ------------------------------------------------------------------------------- */

static const char *read_page(const char *name) {
    static char text[1 << 17];
    FILE *in = fopen(name, "r");
    assert_non_null(in);
    const size_t length = fread(text, 1, sizeof text - 1, in);
    assert_in_range(length, 1, sizeof text - 2);
    text[length] = '\0';
    fclose(in);
    return text;
}

/* Checks that the rows of the page's table under `heading` begin with exactly these names, in this
 * order. `rest` has the rest of each row, or is NULL if it is not compared. */
static void expect_table(const char *page, const char *heading, const char *const *names,
                         const char *const *rest, int count) {
    const char *at = strstr(read_page(page), heading);
    if (!at)
        fail_msg("%s has no table %s", page, heading);
    at = strchr(strchr(at + 1, '\n') + 1, '\n') + 1; /* the first row after the line of dashes */
    for (int i = 0; i < count; i++) {
        char row[1024];
        snprintf(row, sizeof row, "| `%s` |%s%s", names[i], rest ? " " : "", rest ? rest[i] : "");
        if (strncmp(at, row, strlen(row)) != 0)
            fail_msg("%s: expected '%s', found '%.*s'", page, row, (int)strcspn(at, "\n"), at);
        at += strcspn(at, "\n") + 1;
    }
    if (*at == '|')
        fail_msg("%s knows more: '%.*s'", page, (int)strcspn(at, "\n"), at);
}

static void every_slug_is_documented(void **unused) {
    (void)unused;
#define SLUG(id, slug, ...) slug,
#define TEXT(id, slug, text) text " |",
#define RULE(id, slug, known, done) known " | " done " |",
    static const char *const modes[] = {REDCC_MODE_LIST(SLUG)};
    static const char *const mode_texts[] = {REDCC_MODE_LIST(TEXT)};
    static const char *const rules[] = {REDCC_RULE_LIST(SLUG)};
    static const char *const rule_texts[] = {REDCC_RULE_LIST(RULE)};
    expect_table(REPORT_PAGE, "\n| mode |", modes, mode_texts, MODE_COUNT);
    expect_table(METHODS_PAGE, "\n| rule |", rules, rule_texts, RULE_COUNT - 1);
}

static void no_slug_stands_for_two(void **unused) {
    (void)unused;
    static const char *const slugs[] = {REDCC_REASON_LIST(SLUG)};
    for (int i = 0; i < REASON_COUNT; i++) {
        for (const char *at = slugs[i]; *at; at++)
            assert_true(islower((unsigned char)*at) || *at == '-');
        for (int other = 0; other < i; other++)
            assert_string_not_equal(slugs[i], slugs[other]);
    }
}

static void every_variable_is_documented(void **unused) {
    (void)unused;
#define NAME(name) name,
    static const char *const names[] = {REDCC_VARIABLE_LIST(NAME)};
    expect_table(REPORT_PAGE, "\n| variable | values", names, NULL, sizeof names / sizeof *names);
}

/* ---- counters -------------------------------------------------------------------------------- */

struct fixture {
    struct problem problem;
    struct described described;
};

static void fixture_begin(struct fixture *fixture) {
    fixture->problem = problem_new(1, true);
    problem_describe(&fixture->problem, &fixture->described);
    /* only a plan can execute the loop */
    fixture->described.loop.flags &= ~(unsigned)REDCC_SELECTS;
}

static void fixture_end(struct fixture *fixture) {
    redcc_loop_forget(&fixture->described.loop);
    problem_free(&fixture->problem);
    assert_int_equal(redcc_memory_live(), 0);
}

static const struct statistics *statistics_of(const struct fixture *fixture) {
    return &((const struct loop_state *)fixture->described.loop.state)->reported.statistics;
}

static int run(struct fixture *fixture) {
    long last;
    problem_reset(&fixture->problem);
    return problem_run(&fixture->problem, &fixture->described, THREADS, &last);
}

static void run_until_reused(struct fixture *fixture) {
    const long before = fixture->described.loop.state ? statistics_of(fixture)->plans_reused : 0;
    for (int call = 0; call < 100; call++) {
        run(fixture);
        if (statistics_of(fixture)->plans_reused > before)
            return;
    }
    fail_msg("no plan is used again in 100 calls");
}

/* Changes all rows, so that a sample detects it as well as a comparison. */
static void shift_rows(struct fixture *fixture) {
    struct problem *problem = &fixture->problem;
    for (long k = 0; k < problem->touches; k++)
        problem->row[k] = (problem->row[k] + 1) % problem->rows;
}

static void a_lost_plan_has_the_array_that_had_changed(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_reused(&fixture);
    const struct statistics *it = statistics_of(&fixture);
    assert_int_equal(it->lost.count, 0);
    for (int round = 1; round <= 2; round++) {
        shift_rows(&fixture);
        problem_run_tells = false; /* auto stays sequential, and the plan is invalid as well */
        run(&fixture);
        assert_int_equal(it->lost.count, round);
        assert_string_equal(it->lost.array[0].name, "row");
        assert_int_equal(it->lost.array[0].count, round);
        assert_int_equal(it->lost.array[1].count, 0);
        run(&fixture); /* the same plan is not counted twice */
        assert_int_equal(it->lost.count, round);
        problem_run_tells = true;
        run_until_reused(&fixture);
    }
    /* changes a single element of another array, which a sample may miss */
    fixture.problem.start[1]++;
    run(&fixture);
    if (redcc_settings()->method) {
        assert_int_equal(it->lost.count, 3);
        assert_string_equal(it->lost.array[1].name, "start");
    }
    fixture_end(&fixture);
}

/* An invalidated plan is counted once, even if many sequential calls follow. */
static void no_plan_is_lost_twice(void **unused) {
    (void)unused;
    struct fixture fixture;
    unsigned fits, changed;
    fixture_begin(&fixture);
    run_until_reused(&fixture);
    struct reuse *reuse = &((struct loop_state *)fixture.described.loop.state)->execution.reuse;
    for (long t = 1; t < fixture.problem.trip; t += 2) /* changes sampled elements */
        fixture.problem.start[t] = fixture.problem.start[t - 1];
    for (int call = 0; call < 3; call++) {
        reuse->changed_source = -1;
        reuse->sampled = redcc_reuse_sample(reuse->call->request.loop, reuse->call->request.known);
        redcc_reuse_survey(reuse, THREADS, &fits, &changed);
        assert_int_equal(fits, 0);
        assert_int_not_equal(changed, 0);
        assert_int_equal(reuse->changed_source >= 0, call == 0);
    }
    fixture_end(&fixture);
}

static void more_arrays_than_there_is_room_for_are_counted(void **unused) {
    (void)unused;
    struct statistics it = {0};
    for (int i = 0; i < 3 * REDCC_LOST; i++) {
        char name[8];
        snprintf(name, sizeof name, "a%d", i / 2);
        redcc_report_lost(&it, name);
    }
    assert_int_equal(it.lost.count, 3 * REDCC_LOST);
    for (int i = 0; i < REDCC_LOST; i++)
        assert_int_equal(it.lost.array[i].count, 2);
}

static void modes_follow_the_calls(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture);
    const bool named = redcc_settings()->method != NULL;
    run(&fixture);
    const struct statistics *it = statistics_of(&fixture);
    assert_int_equal(atomic_load(&it->last.mode), named ? MODE_BUILT : MODE_TIMED);
    assert_int_equal(it->sequential.calls, !named);
    assert_true((it->sequential.seconds > 0) == !named);
    assert_int_equal(it->sequential.iterations, named ? 0 : fixture.problem.trip);
    run_until_reused(&fixture);
    assert_int_equal(atomic_load(&it->last.mode), MODE_REUSED);
    long last;
    problem_run(&fixture.problem, &fixture.described, 1, &last);
    assert_int_equal(atomic_load(&it->last.mode), MODE_SEQUENTIAL);
    fixture_end(&fixture);
}

/* The report has a sentence about the most frequent reason, or none if most calls ran in
 * parallel. */
static void a_sequential_loop_is_told_why(void **unused) {
    (void)unused;
    struct statistics it = {0};
    char why[REDCC_WHY];
    redcc_why_sequential(&it, why);
    assert_string_equal(why, "");
    atomic_store(&it.calls, 22);
    atomic_store(&it.fallback[REASON_SAVING], 21);
    atomic_store(&it.fallback[REASON_COMPARED], 1);
    it.sequential.calls = 22;
    it.sequential.seconds = 2.7e-3;
    redcc_why_sequential(&it, why);
    assert_string_equal(why, "executed 22 times for 2.7 ms; a plan repays after some 41: raise the "
                             "work per call, or name a method");
    atomic_store(&it.calls, 42);
    atomic_store(&it.fallback[REASON_SAVING], 42);
    redcc_why_sequential(&it, why);
    assert_string_equal(why, "a call takes 0.123 ms; no method is expected to save time: raise the "
                             "work per call, or name a method");
    atomic_store(&it.calls, 100);
    redcc_why_sequential(&it, why);
    assert_string_equal(why, "");
    for (enum reason reason = REASON_NONE + 1; reason < REASON_COUNT; reason++) {
        struct statistics other = {0};
        atomic_store(&other.calls, 1);
        atomic_store(&other.fallback[reason], 1);
        redcc_why_sequential(&other, why);
        assert_true(strncmp(why, redcc_reason_text(reason), strlen(redcc_reason_text(reason))) ==
                    0);
        assert_true(strlen(why) < REDCC_WHY - 1 && !strstr(why, "null"));
    }
}

/* A named method that cannot execute the loop is named in the sentence, with one that can. Other
 * reasons do not depend on the method. */
static void a_named_method_that_is_impossible_is_told(void **unused) {
    (void)unused;
    struct statistics it = {.why.named = {&redcc_method_tiles, &redcc_method_localwrite}};
    char why[REDCC_WHY];
    atomic_store(&it.calls, 3);
    atomic_store(&it.fallback[REASON_NO_TILES], 3);
    redcc_why_sequential(&it, why);
    assert_string_equal(why, "tiles cannot execute this loop, but localwrite can: the translated "
                             "loop has no form for tiles");
    it.why.named.able = NULL;
    redcc_why_sequential(&it, why);
    assert_string_equal(why, "the translated loop has no form for tiles: name localwrite, which "
                             "makes a plan");
    struct statistics other = {.why.named = {&redcc_method_localwrite, &redcc_method_binning}};
    atomic_store(&other.calls, 1);
    atomic_store(&other.fallback[REASON_NESTED], 1);
    redcc_why_sequential(&other, why);
    assert_null(strstr(why, "binning"));
    atomic_store(&other.fallback[REASON_NO_INSPECTOR], 2);
    redcc_why_sequential(&other, why);
    assert_non_null(strstr(why, "localwrite cannot execute this loop, but binning can: "));
}

/* Pairs of overlapping arrays are counted separately, but are one reason. */
static void an_overlap_is_a_reason(void **unused) {
    (void)unused;
    struct statistics it = {0};
    char why[REDCC_WHY];
    atomic_store(&it.calls, 5);
    atomic_store(&it.fallback[REASON_SAVING], 2);
    redcc_report_overlap(&it, "x", "y");
    redcc_report_overlap(&it, "x", "z");
    redcc_report_overlap(&it, "x", "z");
    redcc_why_sequential(&it, why);
    const char *const text = redcc_reason_text(REASON_OVERLAP);
    assert_int_equal(strncmp(why, text, strlen(text)), 0);
}

/* Returns the number of lines of redcc_report_validation with this end. */
static int validation_lines(const char *end, bool *broken) {
    char line[256];
    int count = 0;
    FILE *const said = tmpfile();
    assert_non_null(said);
    const int usual = dup(STDERR_FILENO);
    dup2(fileno(said), STDERR_FILENO);
    *broken = redcc_report_validation();
    dup2(usual, STDERR_FILENO);
    close(usual);
    rewind(said);
    while (fgets(line, sizeof line, said))
        count += strstr(line, end) != NULL;
    fclose(said);
    return count;
}

static void each_loop_says_what_its_slice_does_not_name(void **unused) {
    (void)unused;
    struct reported loop[3];
    bool broken;
    for (int i = 0; i < 3; i++) {
        loop[i] = (struct reported){.file = "a.c", .function = "f", .line = i};
        redcc_report_add(&loop[i]);
    }
    assert_int_equal(validation_lines("that the slice does not name", &broken), 0);
    assert_false(broken);
    atomic_store(&loop[0].statistics.validated.misnamed, 4);
    atomic_store(&loop[1].statistics.validated.misnamed, 5);
    loop[2].statistics.validated.broken = 1;
    assert_int_equal(validation_lines("that the slice does not name", &broken), 2);
    assert_true(broken);
    for (int i = 0; i < 3; i++)
        redcc_report_remove(&loop[i]);
}

static void who_is_advised_to_sleep(void **unused) {
    (void)unused;
    assert_true(redcc_advises_sleep(100, 1, NULL, false));
    assert_true(redcc_advises_sleep(20, 1, "active", false));
    assert_false(redcc_advises_sleep(19, 1, NULL, false));
    assert_false(redcc_advises_sleep(9, 0.01, NULL, false));
    assert_true(redcc_advises_sleep(10, 0.01, NULL, false));
    assert_false(redcc_advises_sleep(100, 1, "passive", false));
    assert_false(redcc_advises_sleep(100, 1, "PASSIVE", false));
    assert_false(redcc_advises_sleep(100, 1, NULL, true));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_slug_is_documented),
        cmocka_unit_test(no_slug_stands_for_two),
        cmocka_unit_test(every_variable_is_documented),
        cmocka_unit_test(a_lost_plan_has_the_array_that_had_changed),
        cmocka_unit_test(no_plan_is_lost_twice),
        cmocka_unit_test(more_arrays_than_there_is_room_for_are_counted),
        cmocka_unit_test(who_is_advised_to_sleep),
        cmocka_unit_test(a_sequential_loop_is_told_why),
        cmocka_unit_test(a_named_method_that_is_impossible_is_told),
        cmocka_unit_test(an_overlap_is_a_reason),
        cmocka_unit_test(each_loop_says_what_its_slice_does_not_name),
        cmocka_unit_test(modes_follow_the_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
