/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Statistics of an iteration from a sample, and the estimated cost of cutting owners from the
 * access graph. */
#include "choose/cost_model.h"
#include "ownership/cuts.h"
#include "ownership/estimate.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

enum { ELEMENTS = 4000, ARRAYS = 2 };

static double force[ELEMENTS + 2][3], block[2 * ELEMENTS][9];

static const redcc_array arrays[ARRAYS] = {{"force", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *force, 0},
                                           {"block", REDCC_SUM, REDCC_DOUBLE, 8, sizeof *block, 0}};

/* Records element t: it adds to force[t] twice, to force[t + 1] and force[t + 2], and to two blocks
 * of element t, which are recorded as one touch. */
static void take_elements(struct sample *sample) {
    assert_true(redcc_sample_begin(sample, (size_t)8 * ELEMENTS, 0));
    for (int t = 0; t < ELEMENTS; t++) {
        for (int corner = 0; corner < 3; corner++)
            redcc_sample_add(sample, (uintptr_t)force[t + corner], 0, 1, 0);
        redcc_sample_add(sample, (uintptr_t)force[t], 0, 1, 0);
        redcc_sample_add(sample, (uintptr_t)block[2 * t], 1, 2, sizeof *block);
        redcc_sample_next_iteration(sample);
    }
}

static bool is_about(double found, double expected) {
    return found > 0.99 * expected && found < 1.01 * expected;
}

static void rows_of_the_leading_group_count_apart(void **unused) {
    (void)unused;
    const redcc_loop loop = {.arrays = arrays, .array_count = ARRAYS};
    void *const bases[] = {force, block};
    struct partition partition;
    struct sample sample;
    struct estimate estimate;
    const struct sample *samples[] = {&sample};
    take_elements(&sample);
    assert_true(redcc_partition_begin(&partition, &loop, bases, 2));
    assert_true(redcc_choose_cuts(&partition, samples, 1));
    for (uint32_t leader = 0; leader < ARRAYS; leader++) {
        const double rows[] = {3, 2};
        partition.leader = leader;
        assert_true(redcc_estimate(&partition, samples, 1, &estimate));
        assert_true(is_about(estimate.each.touches, 6));
        assert_true(is_about(estimate.each.records, 5));
        assert_true(is_about(estimate.each.leading_rows, rows[leader]));
        assert_true(is_about(estimate.each.further_rows, rows[1 - leader]));
    }
    redcc_partition_end(&partition);
    redcc_sample_end(&sample);
}

/* Measured seconds of cutting owners with 2 threads on two cores of an AMD EPYC (family 26), for
 * the loops of the cloth simulator on its large mesh, shuffled. Each is one run (REDCC_TRACE=plan);
 * bending is the median of three runs, 0.099 to 0.141 s. */
struct cutting {
    long long trip;
    double leading_rows, further_rows, seconds;
};

static const struct cutting measured[] = {
    {434829, 3, 0, 0.038},  /* masses of vertices */
    {434829, 3, 3, 0.056},  /* drag */
    {434829, 3, 6, 0.073},  /* stretch and shear */
    {651387, 4, 10, 0.120}, /* bending */
};

/* The estimate must be 1.2 to 2 times the measured time, since an underestimate would begin useless
 * work. */
static void cutting_is_expected_to_take_as_long_as_it_took(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof measured / sizeof *measured; i++) {
        const struct cutting *it = &measured[i];
        struct arm found[WAY_COUNT];
        redcc_estimate_arms(&(struct findings){.trip = it->trip,
                                               .threads = 2,
                                               .sequential = 1e-7,
                                               .share = 0.75,
                                               .touches = it->leading_rows + it->further_rows,
                                               .leading_rows = it->leading_rows,
                                               .further_rows = it->further_rows,
                                               .runs = 0.5,
                                               .reusable = true},
                            found);
        assert_true(found[WAY_GRAPH].possible);
        assert_true(found[WAY_GRAPH].set_up > 1.2 * it->seconds);
        assert_true(found[WAY_GRAPH].set_up < 2 * it->seconds);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_the_leading_group_count_apart),
        cmocka_unit_test(cutting_is_expected_to_take_as_long_as_it_took),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
