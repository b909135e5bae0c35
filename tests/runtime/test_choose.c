/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What `auto` chooses by, and its decision table in docs/methods.md. */
#include "choose/choose.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* What executions of a loop take, in seconds. */
struct times {
    double serial, parallel, graph;
};

static enum course course_of(struct chooser *chooser, redcc_int trip) {
    return redcc_choose_course(chooser, trip, 2, 0).course;
}

/* Executions as auto plans them, each taking what is said; returns how many ran in parallel without
 * the graph, and adds those with it to *by_graph. */
static int simulate_with(struct chooser *chooser, redcc_int trip, int calls, struct times times,
                         double budget, int *by_graph) {
    int count = 0;
    for (int call = 0; call < calls; call++) {
        const struct choice choice = redcc_choose_course(chooser, trip, 2, budget);
        if (choice.course == COURSE_SOLO)
            redcc_choose_learn(chooser, trip, choice.course, false, times.serial);
        if (choice.course != COURSE_PARALLEL)
            continue;
        *by_graph += choice.by_graph;
        count += !choice.by_graph;
        const double seconds = choice.by_graph ? times.graph : times.parallel;
        redcc_choose_learn(chooser, trip, choice.course, choice.by_graph, seconds);
    }
    return count;
}

static int simulate(struct chooser *chooser, redcc_int trip, int calls, double serial,
                    double parallel) {
    int by_graph = 0;
    const struct times times = {serial, parallel, 0};
    const int count = simulate_with(chooser, trip, calls, times, 1e9, &by_graph);
    assert_int_equal(by_graph, 0);
    return count;
}

static void the_faster_course_is_kept(void **unused) {
    (void)unused;
    static struct chooser chooser;
    assert_int_equal(course_of(&chooser, 10), COURSE_SERIAL);        /* a small loop's first call */
    assert_in_range(simulate(&chooser, 10, 1000, 2e-6, 9e-6), 0, 0); /* too little work */
    assert_int_equal(course_of(&chooser, 100000), COURSE_PARALLEL);
    assert_true(simulate(&chooser, 1000000, 1000, 2e-3, 1e-3) >= 998);
    assert_true(simulate(&chooser, 5000, 1000, 1e-4, 2e-4) <= 3 * 3);
    assert_true(simulate(&chooser, 1000, 1000, 1e-3, 6e-4) >= 996);
    /* it was faster once and is no longer */
    assert_true(simulate(&chooser, 1000000, 1000, 2e-3, 3e-3) <= 16 + 3 * 3);
}

/* A loop with spare parts, whose threads take `slowed` times as long side by side; returns how many
 * of the calls were sequential, and sets *first to the first of them. */
static int sequential_calls(double serial, double slowed, double part, int calls, int *first) {
    static struct chooser chooser;
    const redcc_int trip = 1 << 20;
    int count = 0;
    chooser = (struct chooser){0};
    *first = -1;
    for (int call = 0; call < calls; call++) {
        const struct choice choice = redcc_choose_course(&chooser, trip, 2, 0);
        const double working = serial * slowed;
        if (choice.course != COURSE_PARALLEL) {
            if (count++ == 0)
                *first = call;
            redcc_choose_learn(&chooser, trip, COURSE_SOLO, false, serial);
            continue;
        }
        if (choice.pace != PACE_UNTIMED)
            redcc_choose_learn_pace(&chooser, trip, choice.pace,
                                    choice.pace == PACE_ALONE ? part : part * slowed, working);
        redcc_choose_learn(&chooser, trip, COURSE_PARALLEL, false, working / 2);
    }
    return count;
}

/* Where company slows threads down by little, no sequential execution is needed to know that. */
static void a_part_alone_tells_what_the_whole_would_take(void **unused) {
    (void)unused;
    int first;
    assert_int_equal(sequential_calls(60e-3, 1.05, 3e-3, 100, &first), 0);
    assert_int_equal(sequential_calls(60e-3, 1.4, 3e-3, 100, &first), 0);
    assert_int_equal(sequential_calls(60e-3, 1.6, 3e-3, 100, &first), 1); /* not clearly faster */
    assert_int_equal(first, 5);
    assert_int_equal(sequential_calls(1e-3, 1.05, 50e-6, 100, &first), 1); /* too short to tell */
    assert_int_equal(first, 2);
    assert_true(sequential_calls(60e-3, 2.2, 3e-3, 100, &first) > 80); /* it is slower */
}

/* Of which pace auto's executions are, the part and all threads together taking what is said;
 * returns the course that follows. */
static enum course course_after(const double part[4], const double working[4], double parallel) {
    static const enum pace paces[] = {PACE_UNTIMED, PACE_ALONE, PACE_BESIDE, PACE_ALONE,
                                      PACE_BESIDE};
    static struct chooser chooser;
    const redcc_int trip = 1 << 20;
    chooser = (struct chooser){0};
    for (int call = 0; call < 5; call++) {
        const struct choice choice = redcc_choose_course(&chooser, trip, 2, 0);
        assert_int_equal(choice.course, COURSE_PARALLEL);
        assert_int_equal(choice.pace, paces[call]);
        if (call > 0)
            redcc_choose_learn_pace(&chooser, trip, choice.pace, part[call - 1], working[call - 1]);
        redcc_choose_learn(&chooser, trip, COURSE_PARALLEL, false, parallel);
    }
    return course_of(&chooser, trip);
}

/* Something else ran during one of two: it counts for nothing. */
static void the_shorter_of_two_parts_counts(void **unused) {
    (void)unused;
    static const double slow[] = {70e-3, 70e-3, 70e-3, 70e-3};
    static const double hit[] = {99e-3, 99e-3, 70e-3, 66e-3};
    static const double alone_hit[] = {6e-3, 3e-3, 2.9e-3, 3e-3};
    static const double beside_hit[] = {3e-3, 6e-3, 2.9e-3, 3e-3};
    assert_int_equal(course_after(alone_hit, slow, 55e-3), COURSE_SOLO);
    assert_int_equal(course_after(alone_hit, hit, 49e-3), COURSE_SOLO);
    assert_int_equal(course_after(beside_hit, slow, 35e-3), COURSE_PARALLEL);
    assert_int_equal(course_after(beside_hit, hit, 35e-3), COURSE_PARALLEL);
}

/* Two choosers that learn the same, of which one is asked first whether it rests: they agree in
 * each call, and it does rest. */
static void who_rests_decides_as_before(void **unused) {
    (void)unused;
    static struct chooser one, other;
    uint64_t random = 88172645463325252u;
    long rested = 0;
    for (int call = 0; call < 200000; call++) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        const redcc_int trip = 100 << (random >> 60) / 4 * 4;
        const int threads = (random >> 40) % 5000 == 0 ? 3 : 2;
        const double budget = (double)(random >> 50 & 15) * 1e-4;
        const double seconds = 1e-8 * (double)trip * (double)(4 + (random >> 30 & 7));
        struct choice choice = {.course = COURSE_UNDECIDED};
        const bool rests = redcc_choose_rests(&one, trip, threads, &choice);
        if (!rests)
            choice = redcc_choose_course(&one, trip, threads, budget);
        const struct choice expected = redcc_choose_course(&other, trip, threads, budget);
        rested += rests;
        assert_int_equal(choice.course, expected.course);
        assert_int_equal(choice.by_graph, expected.by_graph);
        assert_int_equal(choice.reason, expected.reason);
        assert_int_equal(choice.rule, expected.rule);
        if (choice.course == COURSE_SERIAL)
            continue;
        struct chooser *const both[] = {&one, &other};
        for (int i = 0; i < 2; i++) {
            if (choice.course == COURSE_PARALLEL && (random >> 20) % 50 == 0)
                redcc_choose_refused(both[i], trip,
                                     (random >> 10) % 2 ? REASON_COSTLY : REASON_OVERLAP);
            else
                redcc_choose_learn(both[i], trip, choice.course, choice.by_graph, seconds);
        }
    }
    assert_true(rested > 50000);
    assert_memory_equal(&one, &other, sizeof one);
}

/* How many calls are left to the sequential loop between the first trial and the second? */
static int first_rest(double serial, double parallel) {
    static struct chooser chooser;
    chooser = (struct chooser){0};
    int tried = 0;
    while (tried < 3)
        tried += simulate(&chooser, 100000, 1, serial, parallel);
    int calls = 0;
    while (simulate(&chooser, 100000, 1, serial, parallel) == 0)
        calls++;
    return calls;
}

/* Who lost by little tries again soon, and no retry costs more than 0.01 of what was before. */
static void the_rest_is_as_long_as_the_loss(void **unused) {
    (void)unused;
    static struct chooser chooser;
    assert_int_equal(first_rest(1e-3, 1.01e-3), 15);
    assert_in_range(first_rest(1e-3, 1.2e-3), 57, 61);
    assert_int_equal(first_rest(1e-3, 3e-3), 255);
    for (int loss = 1; loss < 60; loss++) {
        chooser = (struct chooser){0};
        simulate(&chooser, 100000, 4, 1e-3, 1e-3 * (1 + loss / 100.0));
        const int tries = simulate(&chooser, 100000, 1000, 1e-3, 1e-3 * (1 + loss / 100.0));
        assert_true(tries * loss / 100.0 <= 0.011 * 1000);
    }
}

/* A shuffled loop: 0.75 of the iterations for each of two, 100000 touches. */
static const struct findings shuffled = {
    .trip = 50000, .threads = 2, .share = 0.75, .touches = 1e5, .swept = true, .reusable = true};

static void a_graph_is_cut_when_the_budget_allows_it(void **unused) {
    (void)unused;
    static struct chooser chooser;
    const struct times times = {1e-3, 0.9e-3, 0.6e-3};
    int by_graph = 0;
    assert_int_equal(course_of(&chooser, shuffled.trip), COURSE_PARALLEL);
    assert_int_equal(redcc_choose_way(&chooser, &shuffled), RULE_INDEX);
    simulate_with(&chooser, shuffled.trip, 100, times, 1e-4, &by_graph);
    assert_int_equal(by_graph, 0);
    assert_int_equal(redcc_choose_rule(&chooser, shuffled.trip), RULE_FASTER);
    simulate_with(&chooser, shuffled.trip, 100, times, 1, &by_graph);
    assert_int_equal(by_graph, 97); /* all but three, to compare with what there was before */
    assert_int_equal(redcc_choose_rule(&chooser, shuffled.trip), RULE_GRAPH_KEPT);
    struct findings changed = shuffled; /* other subscripts: only while the budget allows it */
    changed.by_graph = true;
    changed.budget = 1;
    assert_int_equal(redcc_choose_way(&chooser, &changed), RULE_GRAPH);
    simulate_with(&chooser, shuffled.trip, 100, times, 1, &by_graph);
    changed.budget = 0;
    assert_int_equal(redcc_choose_way(&chooser, &changed), RULE_INDEX);
    by_graph = 0;
    simulate_with(&chooser, shuffled.trip, 100, times, 0, &by_graph);
    assert_int_equal(by_graph, 0);
}

/* The subscripts are others in each call. */
static void graphs_cut_in_vain_become_rare(void **unused) {
    (void)unused;
    static struct chooser chooser;
    struct findings changed = shuffled;
    const struct times times = {1e-3, 0.9e-3, 5e-3};
    int by_graph = 0, cut = 0;
    changed.budget = 1e9;
    course_of(&chooser, shuffled.trip);
    redcc_choose_way(&chooser, &shuffled);
    simulate_with(&chooser, shuffled.trip, 10, times, 0, &by_graph);
    for (int call = 0; call < 1000; call++) {
        const struct choice choice =
            redcc_choose_course(&chooser, shuffled.trip, 2, changed.budget);
        changed.by_graph = choice.by_graph;
        const bool graph = redcc_choose_way(&chooser, &changed) == RULE_GRAPH;
        cut += graph;
        redcc_choose_learn(&chooser, shuffled.trip, choice.course, graph,
                           graph ? times.graph : times.parallel);
    }
    assert_in_range(cut, 1, 6);
}

static void a_graph_that_does_not_pay_is_left_alone(void **unused) {
    (void)unused;
    static struct chooser chooser;
    const struct times times = {1e-3, 0.6e-3, 0.9e-3};
    int by_graph = 0;
    course_of(&chooser, shuffled.trip);
    redcc_choose_way(&chooser, &shuffled);
    simulate_with(&chooser, shuffled.trip, 10, times, 0, &by_graph);
    simulate_with(&chooser, shuffled.trip, 7, times, 1, &by_graph);
    assert_int_equal(by_graph, 4);
    assert_int_equal(redcc_choose_rule(&chooser, shuffled.trip), RULE_GRAPH_LOST);
    simulate_with(&chooser, shuffled.trip, 10000, times, 1, &by_graph);
    assert_true(by_graph * (times.graph / times.parallel - 1) <= 0.011 * 10000);
    redcc_choose_no_graph(&chooser, shuffled.trip);
}

/* A loop by the access graph, and the first executions before it; returns how many by it. */
static int settle_graph(struct chooser *chooser, struct times before, struct times then) {
    int by_graph = 0;
    *chooser = (struct chooser){0};
    course_of(chooser, shuffled.trip);
    redcc_choose_way(chooser, &shuffled);
    simulate_with(chooser, shuffled.trip, 10, before, 0, &by_graph);
    simulate_with(chooser, shuffled.trip, 1000, then, 1, &by_graph);
    return by_graph;
}

/* The machine gets busy, and everything slow: the graph is compared with what is slow like it. */
static void a_graph_is_compared_with_its_own_time(void **unused) {
    (void)unused;
    static struct chooser chooser;
    const struct times quiet = {1e-3, 0.9e-3, 0.6e-3}, busy = {2e-3, 1.8e-3, 1.2e-3};
    const struct times serial = {1e-3, 1.1e-3, 0.6e-3}, both = {2e-3, 2.2e-3, 1.2e-3};
    assert_int_equal(settle_graph(&chooser, quiet, busy), 996); /* one is sequential */
    assert_int_equal(settle_graph(&chooser, serial, both), 996);
}

/* The loop is executed as `from` says, then as `to`; returns how many of 1000 calls ran in
 * parallel, and sets *timed to how often the sequential loop was timed. */
static int change_of_pace(struct times from, struct times to, int *timed) {
    static struct chooser chooser;
    int count = 0;
    chooser = (struct chooser){0};
    simulate(&chooser, 100000, 100, from.serial, from.parallel);
    *timed = 0;
    for (int call = 0; call < 1000; call++) {
        const struct choice choice = redcc_choose_course(&chooser, 100000, 2, 0);
        *timed += choice.course == COURSE_SOLO;
        if (choice.course == COURSE_SERIAL)
            continue;
        const bool parallel = choice.course == COURSE_PARALLEL;
        count += parallel;
        redcc_choose_learn(&chooser, 100000, choice.course, false,
                           parallel ? to.parallel : to.serial);
    }
    return count;
}

static void a_slow_machine_is_no_reason_to_give_up(void **unused) {
    (void)unused;
    int timed;
    const struct times quiet = {1e-3, 0.6e-3, 0}, busy = {2e-3, 1.2e-3, 0}, lost = {1e-3, 2e-3, 0};
    assert_int_equal(change_of_pace(quiet, busy, &timed), 999);
    assert_int_equal(timed, 1);
    assert_true(change_of_pace(quiet, lost, &timed) <= 16 + 5 * 3);
}

static void the_rows_of_the_decision_table(void **unused) {
    (void)unused;
    static struct chooser chooser;
    struct findings findings = shuffled;
    findings.share = 0.54;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_EVEN);
    findings.share = 0.56;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_INDEX);
    findings.share = 0.9;
    findings.copies = true;
    findings.copied = 1e7;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_COPIES);
    findings.copies = false;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_SERIAL);
    findings.swept = false;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_DEFERRED);
    findings.budget = 1;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_SERIAL);
    findings.by_graph = true;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_GRAPH);
}

/* Copies where they take less than iterations executed twice, and than many short runs. */
static void copies_come_first_where_they_are_cheaper(void **unused) {
    (void)unused;
    static struct chooser chooser;
    struct findings findings = shuffled;
    findings.copied = 1e5; /* 15 microseconds, instead of 100 for 25000 touches once more */
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_INDEX);
    findings.copies = true;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_CHEAP_COPIES);
    findings.copied = 1e6;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_INDEX);
    findings.runs = 50000; /* 75 microseconds more */
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_CHEAP_COPIES);
    findings.reusable = false; /* new pages for each execution */
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_INDEX);
    findings.copied = 1e4;
    findings.share = 0.5; /* every iteration has one owner, but each another one than the last */
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_CHEAP_COPIES);
    findings.runs = 2;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_EVEN);
    findings = shuffled; /* the access graph's turn comes all the same */
    findings.copies = findings.by_graph = true;
    findings.budget = 1;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_GRAPH);
}

/* A light loop whose iterations all have other owners than the last: inspecting it takes longer
 * than the loop, so that waits for the budget. */
static void a_costly_inspection_is_put_off(void **unused) {
    (void)unused;
    static struct chooser chooser;
    struct findings findings = shuffled;
    findings.trip = 1000000; /* 20 ms to inspect */
    findings.touches = 2e6;
    findings.runs = 5e5;
    findings.swept = false;
    course_of(&chooser, findings.trip);
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_TIMED);
    redcc_choose_learn(&chooser, findings.trip, COURSE_SOLO, false, 5e-3);
    assert_int_equal(course_of(&chooser, findings.trip), COURSE_PARALLEL);
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_COSTLY);
    redcc_choose_refused(&chooser, findings.trip, REASON_COSTLY);
    for (int call = 0; call < 15; call++)
        assert_int_equal(course_of(&chooser, findings.trip), COURSE_SERIAL);
    assert_int_equal(redcc_choose_course(&chooser, findings.trip, 2, 0.03).course, COURSE_PARALLEL);
    findings.budget = 0.03;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_INDEX);
    findings.budget = 0;
    findings.share = 0.5;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_COSTLY);
    findings.runs = 1e5; /* long runs: quickly inspected */
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_EVEN);
    findings.runs = 5e5; /* a heavy loop */
    chooser.trial[19].serial_best = 1e-6;
    assert_int_equal(redcc_choose_way(&chooser, &findings), RULE_EVEN);
}

/* docs/methods.md shows the decision table as the runtime has it. */
static void the_decision_table_is_documented(void **unused) {
    (void)unused;
    static const char *const rows[] = {
#define ROW(id, known, done) "\n| " known " | " done " |\n",
        REDCC_RULE_LIST(ROW)
#undef ROW
    };
    static char text[1 << 17];
    FILE *in = fopen(METHODS_PAGE, "r");
    assert_non_null(in);
    text[fread(text, 1, sizeof text - 1, in)] = '\0';
    fclose(in);
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++)
        if (!strstr(text, rows[row]))
            fail_msg("docs/methods.md lacks the row:%s", rows[row]);
}

static void few_short_iterations_are_one_threads(void **unused) {
    (void)unused;
    assert_int_equal(redcc_worth_threads(20, 2, 0, 0), 1); /* nothing is known yet */
    assert_int_equal(redcc_worth_threads(4095, 7, 0, 0), 1);
    assert_int_equal(redcc_worth_threads(4096, 7, 0, 0), 7);
    assert_int_equal(redcc_worth_threads(20, 2, 1e-6, 1), 1);
    assert_int_equal(redcc_worth_threads(20, 2, 1e-3, 10), 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_faster_course_is_kept),
        cmocka_unit_test(the_rest_is_as_long_as_the_loss),
        cmocka_unit_test(a_part_alone_tells_what_the_whole_would_take),
        cmocka_unit_test(the_shorter_of_two_parts_counts),
        cmocka_unit_test(who_rests_decides_as_before),
        cmocka_unit_test(a_graph_is_cut_when_the_budget_allows_it),
        cmocka_unit_test(a_graph_that_does_not_pay_is_left_alone),
        cmocka_unit_test(a_graph_is_compared_with_its_own_time),
        cmocka_unit_test(a_slow_machine_is_no_reason_to_give_up),
        cmocka_unit_test(graphs_cut_in_vain_become_rare),
        cmocka_unit_test(the_rows_of_the_decision_table),
        cmocka_unit_test(copies_come_first_where_they_are_cheaper),
        cmocka_unit_test(a_costly_inspection_is_put_off),
        cmocka_unit_test(the_decision_table_is_documented),
        cmocka_unit_test(few_short_iterations_are_one_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
