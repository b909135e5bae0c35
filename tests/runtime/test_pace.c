/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Deadlines of inspections: a stage ends early if it will miss its deadline at its present pace. */
#include "base/clock.h"
#include "inspect/inspection.h"

#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

/* Will the stage be late after `spent` seconds, with `left` seconds until the deadline and the
 * fraction `done` of its work? Both times are so long that the test's own time does not matter. */
static bool will_be_late(double spent, double left, double done) {
    const double now = redcc_seconds();
    const struct inspection inspection = {.pace = {.began = now - spent, .deadline = now + left}};
    return redcc_inspection_will_be_late(&inspection, done);
}

static void a_stage_ends_when_it_will_be_late(void **unused) {
    (void)unused;
    const struct inspection without = {.pace = {.began = redcc_seconds() - 1e6}};
    assert_false(redcc_inspection_will_be_late(&without, 0.01));
    assert_true(will_be_late(1e6, -1, 0.99));    /* the deadline has passed */
    assert_true(will_be_late(1e6, 8e6, 0.1));    /* 9e6 more seconds are needed */
    assert_false(will_be_late(1e6, 10e6, 0.1));  /* 9e6 of the 10e6 seconds are needed */
    assert_false(will_be_late(1e6, 20e6, 1e-6)); /* less than a 16th of the time has passed */
    assert_true(will_be_late(1e6, 14e6, 1e-6));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_stage_ends_when_it_will_be_late)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
