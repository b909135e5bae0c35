/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Whole steps: laws that every cloth must satisfy. Numbers such as S06 refer to
 * docs/fabric-hard-cases.md. */
#include "check.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "stage.h"

/* S24: in free fall v = -g t, and the solver needs at most one iteration per step. */
static void S24_free_fall(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    stage_begin(&on);
    stage_run(&on, 50);
    const double t = simulation_time(on.sim);
    assert_near(t, 0.5, 1e-15);
    for (int i = 0; i < on.m.vertex_count; i++) {
        assert_near(simulation_velocities(on.sim)[i][2], -9.81 * t, 1e-7);
        assert_near(simulation_velocities(on.sim)[i][0], 0, 1e-7);
    }
    assert_true(simulation_counts(on.sim).iterations <= 50);
    assert_int_equal(simulation_counts(on.sim).taken, 50);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_end(&on);
}

/* S06: inner forces do not change the momentum, up to the tolerance of the solver. */
static void S06_momentum_is_kept(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    on.s.solution.tolerance = 1e-12;
    memset(on.s.surroundings.gravity, 0, sizeof on.s.surroundings.gravity);
    unsigned seed = 3;
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            on.m.position[i][a] += 0.005 * random_number(&seed);
    stage_begin(&on);
    stage_run(&on, 60);
    double sum[3] = {0, 0, 0}, size = 0;
    for (int i = 0; i < on.m.vertex_count; i++) {
        vector_add_scaled(sum, on.sim->cloth.mass[i], on.sim->state.v[i], sum);
        size += on.sim->cloth.mass[i] * vector_length(on.sim->state.v[i]);
    }
    assert_true(size > 0);
    assert_below(vector_length(sum) / size, 1e-10);
    stage_end(&on);
}

/* S08: a free sheet stretched by 5 % gains no energy in any step. */
static void S08_energy_does_not_grow(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    memset(on.s.surroundings.gravity, 0, sizeof on.s.surroundings.gravity);
    on.s.material.stretch_damping = on.s.material.shear_damping = on.s.material.bend_damping = 0;
    on.s.time.step = 0.033;
    unsigned seed = 3;
    for (int i = 0; i < on.m.vertex_count; i++) {
        for (int a = 0; a < 2; a++)
            on.m.position[i][a] *= 1.05;
        on.m.position[i][2] = 1e-4 * random_number(&seed);
    }
    stage_begin(&on);
    const double first = stage_energy(&on);
    double before = first;
    for (int n = 0; n < 60; n++) {
        stage_run(&on, 1);
        const double now = stage_energy(&on);
        assert_below(now - before, 1e-12 * first);
        before = now;
    }
    stage_end(&on);
}

/* S10: cloth collapsed to a line or a point unfolds. */
static void S10_collapsed_sheet_recovers(void **state) {
    (void)state;
    for (int to_point = 0; to_point < 2; to_point++) {
        stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.2, 1), cloth_scene());
        memset(on.s.surroundings.gravity, 0, sizeof on.s.surroundings.gravity);
        for (int i = 0; i < on.m.vertex_count; i++) {
            on.m.position[i][1] = on.m.position[i][2] = 0;
            on.m.position[i][0] *= to_point ? 0 : 1;
        }
        stage_begin(&on);
        stage_run(&on, 200);
        double area = 0, rest = 0;
        for (int t = 0; t < on.sim->cloth.triangles.count; t++) {
            const int *v = on.sim->cloth.triangles.vertex[t];
            double one[3], other[3], cross[3];
            vector_subtract(on.sim->state.x[v[1]], on.sim->state.x[v[0]], one);
            vector_subtract(on.sim->state.x[v[2]], on.sim->state.x[v[0]], other);
            vector_cross(one, other, cross);
            area += vector_length(cross) / 2;
            rest += on.sim->cloth.triangles.rest[t].area;
        }
        assert_true(area >= 0.9 * rest);
        stage_end(&on);
    }
}

/* S22: pins, at rest and moving, are exactly in their prescribed positions. */
static void S22_pins_are_exact(void **state) {
    (void)state;
    pin pins[2] = {{.low = {-0.01, -0.01}, .high = {0.01, 0.51}, .velocity = {0, 0, 0}},
                   {.low = {0.49, -0.01}, .high = {0.51, 0.51}, .velocity = {0.03, -0.02, 0.05}}};
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    on.s.solution.tolerance = 1e-4;
    on.s.pins = pins;
    on.s.pin_count = 2;
    stage_begin(&on);
    stage_run(&on, 1000);
    int held = 0;
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int p = 0; p < 2; p++) {
            const double *at = on.m.material[i];
            if (at[0] < pins[p].low[0] || at[0] > pins[p].high[0])
                continue;
            held++;
            for (int a = 0; a < 3; a++) {
                assert_near(simulation_positions(on.sim)[i][a],
                            on.m.position[i][a] + 10.0 * pins[p].velocity[a], 1e-9);
                assert_true(simulation_velocities(on.sim)[i][a] == pins[p].velocity[a]);
            }
        }
    assert_int_equal(held, 12);
    stage_end(&on);
}

/* S24, S27: cloth on a ball comes to rest and stays there. */
static void test_cloth_comes_to_rest(void **state) {
    (void)state;
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0.25, 0.25, -0.3},
                     .size = {0.2},
                     .friction = 0.5,
                     .gap = 0.005};
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    on.s.time.step = 0.033;
    on.s.solution.tolerance = 1e-3;
    on.s.surroundings.drag = 1;
    on.s.colliders = &ball;
    on.s.collider_count = 1;
    stage_begin(&on);
    stage_run(&on, 300);
    double sum = 0;
    for (int i = 0; i < on.m.vertex_count; i++)
        sum += vector_dot(on.sim->state.v[i], on.sim->state.v[i]);
    assert_below(sqrt(sum / on.m.vertex_count), 1e-3);
    /* At rest the right side is almost 0, so a tolerance relative to it alone would never be
     * reached. */
    const long before = simulation_counts(on.sim).iterations;
    stage_run(&on, 100);
    assert_below((double)(simulation_counts(on.sim).iterations - before), 100 * 10);
    long contacts;
    collisions_count(&on.sim->collisions, &contacts, NULL);
    assert_in_range(contacts, 1, 36);
    stage_end(&on);
}

/* An effect without influence changes no bit: a distant collider, and drag and bend of 0. */
static void test_far_collider_changes_no_bit(void **state) {
    (void)state;
    collider far = {.kind = COLLIDER_SPHERE, .position = {100, 0, 0}, .size = {1}, .gap = 0.01};
    pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 0.51}, .velocity = {0, 0, 0}};
    stage with = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    stage without = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    with.s.pins = without.s.pins = &hold;
    with.s.pin_count = without.s.pin_count = 1;
    with.s.colliders = &far;
    with.s.collider_count = 1;
    with.s.surroundings.wind[0] = 3; /* without drag wind has no effect */
    stage_begin(&with);
    stage_begin(&without);
    stage_run(&with, 30);
    stage_run(&without, 30);
    assert_memory_equal(simulation_positions(with.sim), simulation_positions(without.sim),
                        sizeof(double[3]) * (size_t)with.m.vertex_count);
    stage_end(&with);
    stage_end(&without);
}

/* Without bending the matrix has no blocks for hinges, and without forces between vertices only
 * diagonal blocks. */
static void test_matrix_follows_the_effects(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    const int edges = on.m.hinge_count + (3 * on.m.triangle_count - 2 * on.m.hinge_count);
    stage_begin(&on);
    assert_true(simulation_counts(on.sim).matrix_blocks > 36 + edges);
    simulation_free(on.sim);
    on.s.material.bend = on.s.material.bend_damping = 0;
    stage_begin(&on);
    assert_int_equal(simulation_counts(on.sim).matrix_blocks, 36 + edges);
    simulation_free(on.sim);
    on.s.material.stretch = on.s.material.shear = on.s.material.stretch_damping =
        on.s.material.shear_damping = 0;
    on.s.surroundings.drag = 0.3;
    stage_begin(&on);
    assert_int_equal(simulation_counts(on.sim).matrix_blocks, 36);
    stage_run(&on, 5);
    int count;
    const effect_account *effects = simulation_effects(on.sim, &count);
    for (int k = 0; k < count; k++) {
        const int expected = !strcmp(effects[k].name, "gravity") ||
                             !strcmp(effects[k].name, "drag") ||
                             !strcmp(effects[k].name, "monitor");
        assert_int_equal(effects[k].active, expected);
        assert_true(expected ? effects[k].elements > 0 : effects[k].elements == 0);
        assert_true(expected || strcmp(effects[k].name, "contact") == 0 || effects[k].seconds == 0);
    }
    stage_end(&on);
}

/* S20: a vertex without triangles stays where it is and does not affect the others. */
static void S20_lone_vertex_is_held(void **state) {
    (void)state;
    const double material[4][2] = {{0, 0}, {1, 0}, {0, 1}, {5, 5}};
    const int triangle[1][3] = {{0, 1, 2}};
    stage on = stage_of(cloth_of(4, material, 1, triangle), cloth_scene());
    stage_begin(&on);
    stage_run(&on, 10);
    stage_assert_finite(&on);
    assert_true(simulation_positions(on.sim)[3][2] == 0);
    assert_true(simulation_positions(on.sim)[0][2] < -0.01);
    stage_end(&on);
}

static void S35_broken_position_is_refused(void **state) {
    (void)state;
    char error[256] = "";
    stage on = stage_of(cloth_sheet(3, 3, 0.1, 0, 1), cloth_scene());
    on.m.position[4][1] = NAN;
    assert_null(simulation_new(&on.m, &on.s, error));
    assert_non_null(strstr(error, "finite"));
    stage_end(&on);
}

/* A step's phases are counted, one call each. */
static void test_phases_are_counted(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(3, 3, 0.1, 0, 1), cloth_scene());
    stage_begin(&on);
    stage_run(&on, 7);
    for (int k = 0; k < PHASE_COUNT; k++)
        assert_int_equal(simulation_phases(on.sim)[k].calls, 7);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S24_free_fall),
        cmocka_unit_test(S06_momentum_is_kept),
        cmocka_unit_test(S08_energy_does_not_grow),
        cmocka_unit_test(S10_collapsed_sheet_recovers),
        cmocka_unit_test(S22_pins_are_exact),
        cmocka_unit_test(test_cloth_comes_to_rest),
        cmocka_unit_test(test_far_collider_changes_no_bit),
        cmocka_unit_test(test_matrix_follows_the_effects),
        cmocka_unit_test(S20_lone_vertex_is_held),
        cmocka_unit_test(S35_broken_position_is_refused),
        cmocka_unit_test(test_phases_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
