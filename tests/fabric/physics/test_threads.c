/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* S34 of docs/fabric-hard-cases.md for loops with OpenMP pragmas: the bits are the same at every
 * thread count. */
#include "check.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "cloth.h"
#include "step/simulation.h"

/* A pinned cloth in wind falls onto a ball. Returns its positions after some steps. */
static double (*result(int threads))[3] {
    char error[256] = "";
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0.7, 0.6, -0.35},
                     .size = {0.3},
                     .friction = 0.4,
                     .gap = 0.01};
    pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 2}, .velocity = {0, 0, 0.1}};
    mesh m = cloth_sheet(22, 20, 0.1, 0.3, 5);
    scene s = cloth_scene();
    s.time.step = 0.033;
    s.solution.tolerance = 1e-3;
    s.surroundings.drag = 0.5;
    s.surroundings.wind[1] = 2;
    s.pins = &hold;
    s.pin_count = 1;
    s.colliders = &ball;
    s.collider_count = 1;
    omp_set_num_threads(threads);
    simulation *sim = simulation_new(&m, &s, error);
    assert_non_null(sim);
    for (int n = 0; n < 20; n++)
        assert_int_equal(simulation_step(sim, error), 0);
    double(*x)[3] = malloc(sizeof *x * (size_t)m.vertex_count);
    memcpy(x, simulation_positions(sim), sizeof *x * (size_t)m.vertex_count);
    simulation_free(sim);
    cloth_free(&m);
    return x;
}

static void S34_bits_do_not_depend_on_threads(void **state) {
    (void)state;
    double(*one)[3] = result(1);
    for (int threads = 2; threads <= 5; threads++) {
        double(*more)[3] = result(threads);
        assert_memory_equal(one, more, sizeof(double[3]) * 22 * 20);
        free(more);
    }
    free(one);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(S34_bits_do_not_depend_on_threads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
