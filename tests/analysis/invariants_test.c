/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* In builds with assertions a verdict that violates analysis/base/facts.h stops the program. Each
 * test changes one fact of a valid verdict. */
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "analysis/invariants.h"
#include "frontend/frontend.h"

static const char text[] = "void spread(double *restrict b, double *restrict c, const int *row, "
                           "const double *x, int n) {\n"
                           "    double last = 0;\n"
                           "    for (int t = 0; t < n; t++) {\n"
                           "        last = x[t];\n"
                           "        b[row[t]] += last;\n"
                           "        c[row[t]] -= last;\n"
                           "    }\n"
                           "}\n";

static arena *memory;
static const ir_unit *unit;
static loop_verdict verdict;

static int find_verdict(void **state) {
    (void)state;
    memory = arena_new();
    unit =
        frontend_parse(memory, source_from_text(memory, "spread.c", text, sizeof text - 1), 0, NULL)
            .unit;
    const analysis_result result = analyse(memory, unit, NULL);
    if (result.verdict_count != 1 || result.verdicts[0].kind != VERDICT_TRANSFORM)
        return 1;
    verdict = result.verdicts[0];
    return 0;
}

static int free_verdict(void **state) {
    (void)state;
    arena_free(memory);
    return 0;
}

typedef struct changed {
    loop_verdict verdict;
    loop_facts facts;
    reduction_array arrays[2];
    reduction_update updates[2];
    loop_source sources[8];
} changed;

typedef void change(changed *c);

static void nothing(changed *c) {
    (void)c;
}
static void no_reason(changed *c) {
    c->verdict.kind = VERDICT_REFUSE;
}
static void a_reason(changed *c) {
    c->verdict.why.id = REASON_GOTO;
}
static void no_step(changed *c) {
    c->facts.counted.step = 0;
}
static void the_other_way(changed *c) {
    c->facts.counted.step = -1;
}
static void no_bound(changed *c) {
    c->facts.counted.bound = NULL;
}
static void an_array_beyond(changed *c) {
    c->updates[1].array = 2;
}
static void an_array_without_updates(changed *c) {
    c->updates[1].array = 0;
}
static void an_update_of_another_loop(changed *c) {
    c->updates[0].statement = verdict.function->body;
}
static void no_operator(changed *c) {
    c->arrays[0].op = REDUCTION_NONE;
}
static void a_unit_of_half_an_element(changed *c) {
    c->arrays[1].unit = 4;
}
static void a_source_for_nothing(changed *c) {
    c->sources[0].is_subscript = c->sources[0].needs_guard = false;
}
static void a_touched_source_without_a_place(changed *c) {
    c->sources[0].extent = EXTENT_TOUCHED;
    c->sources[0].place = NULL;
}
static void no_slice(changed *c) {
    c->facts.slice.holds = NULL;
}
static void another_function(changed *c) {
    c->facts.function = NULL;
}

/* Checks the changed verdict in a child process. Returns true if no assertion fails. */
static bool survives(change *make) {
    changed c = {.verdict = verdict, .facts = *verdict.facts};
    memcpy(c.arrays, c.facts.arrays, sizeof c.arrays);
    memcpy(c.updates, c.facts.updates, sizeof c.updates);
    memcpy(c.sources, c.facts.sources, c.facts.source_count * sizeof *c.sources);
    make(&c);
    c.facts.arrays = c.arrays;
    c.facts.updates = c.updates;
    c.facts.sources = c.sources;
    c.verdict.facts = &c.facts;
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        const struct rlimit no_core = {0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        signal(SIGABRT, SIG_DFL);
        if (!freopen("/dev/null", "w", stderr))
            _exit(3);
        analysis_assert_verdict(unit, &c.verdict);
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) ? WTERMSIG(status) == SIGABRT : status == 0);
    return !WIFSIGNALED(status);
}

static void a_changed_verdict_trips_an_assertion(void **state) {
    (void)state;
    static const struct {
        const char *name;
        change *make;
    } changes[] = {{"no reason", no_reason},
                   {"a reason", a_reason},
                   {"no step", no_step},
                   {"the other way", the_other_way},
                   {"no bound", no_bound},
                   {"an array beyond", an_array_beyond},
                   {"an array without updates", an_array_without_updates},
                   {"an update of another loop", an_update_of_another_loop},
                   {"no operator", no_operator},
                   {"a unit of half an element", a_unit_of_half_an_element},
                   {"a source for nothing", a_source_for_nothing},
                   {"a touched source without a place", a_touched_source_without_a_place},
                   {"no slice", no_slice},
                   {"another function", another_function}};
#ifdef NDEBUG
    const bool watched = false;
#else
    const bool watched = true;
#endif
    assert_int_equal(verdict.facts->array_count, 2);
    assert_int_equal(verdict.facts->update_count, 2);
    assert_in_range(verdict.facts->source_count, 1, 8);
    assert_true(survives(nothing));
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++)
        if (survives(changes[i].make) == watched)
            fail_msg("%s", changes[i].name);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_changed_verdict_trips_an_assertion)};
    return cmocka_run_group_tests(tests, find_verdict, free_verdict);
}
