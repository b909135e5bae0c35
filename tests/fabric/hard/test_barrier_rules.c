/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Quantities that a step with `contact: barrier` computes: friction, moving bodies and pins, and
 * energy. Also: a step may be stopped, saved and resumed. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "contact/shape.h"
#include "crossings.h"
#include "step/barrier_step.h"

static const collider ground = {
    .kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .friction = 0.5, .gap = 0.004};

static stage sheet_over(collider *list, int colliders, int columns, double height) {
    stage on = stage_of(cloth_sheet(columns, columns, 0.04, 0.2, 3), cloth_scene());
    on.s.contact.method = CONTACT_BARRIER;
    on.s.monitor.energy = 1e-3;
    on.s.self_collision.gap = 0.004;
    on.s.colliders = list;
    on.s.collider_count = colliders;
    for (int i = 0; i < on.m.vertex_count; i++)
        on.m.position[i][2] = height;
    return on;
}

/* Computes the mean velocity, m/s. */
static void mean_velocity(const stage *on, double mean[3]) {
    mean[0] = mean[1] = mean[2] = 0;
    for (int i = 0; i < on->m.vertex_count; i++)
        vector_add_scaled(mean, 1.0 / on->m.vertex_count, simulation_velocities(on->sim)[i], mean);
}

/* On a slope a sheet stays at rest if the friction coefficient exceeds the slope. Otherwise it
 * slides by Coulomb's law. */
static void sheets_slide_and_stick(void **state) {
    const double slope = 0.3, g = 9.81;
    (void)state;
    for (int sticks = 0; sticks < 2; sticks++) {
        collider plane = ground;
        double before[3], after[3];
        plane.friction = sticks ? 0.5 : 0.1;
        stage on = sheet_over(&plane, 1, 3, 0.0022);
        on.s.surroundings.gravity[0] = g * sin(slope);
        on.s.surroundings.gravity[2] = -g * cos(slope);
        stage_begin(&on);
        stage_run(&on, 15);
        mean_velocity(&on, before);
        stage_run(&on, 15);
        mean_velocity(&on, after);
        if (sticks)
            assert_below(fabs(after[0]), 1e-3); /* friction grows from 0 up to this speed */
        else
            assert_near((after[0] - before[0]) / 0.15, g * (sin(slope) - 0.1 * cos(slope)), 0.1);
        assert_int_equal(simulation_counts(on.sim).rejected, 0);
        stage_end(&on);
    }
}

/* A moving floor carries and lifts the sheet. The floor's work is counted in the energy balance:
 * otherwise the monitor would reject steps. */
static void a_moving_floor_carries(void **state) {
    (void)state;
    collider plane = ground;
    double mean[3];
    plane.velocity[0] = 0.2;
    plane.velocity[2] = 0.3;
    stage on = sheet_over(&plane, 1, 3, 0.0022);
    stage_begin(&on);
    stage_run(&on, 30);
    mean_velocity(&on, mean);
    assert_near(mean[0], 0.2, 2e-3);
    assert_near(mean[2], 0.3, 0.03);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_end(&on);
}

/* A bar turns by keyframes through a sheet whose pins move. Nothing passes, and pins and bar are at
 * their prescribed positions. */
static void bars_turn_and_pins_move(void **state) {
    keyframe turn[2] = {{0, {0, 0, 0}, 0}, {0.2, {0, 0, 0.02}, 200}};
    collider bar = {.kind = COLLIDER_BOX,
                    .position = {0.08, 0.08, -0.05},
                    .size = {0.07, 0.004, 0.004},
                    .friction = 0.3,
                    .gap = 0.004,
                    .turn_axis = {0, 1, 0},
                    .keyframe_count = 2,
                    .keyframes = turn};
    pin edge = {
        .by = PIN_RECTANGLE, .low = {-0.001, -1}, .high = {0.001, 1}, .velocity = {0.1, 0, 0.1}};
    int crossed = 0;
    (void)state;
    stage on = sheet_over(&bar, 1, 5, 0.05);
    on.s.pin_count = 1;
    on.s.pins = &edge;
    stage_begin(&on);
    for (int n = 0; n < 24; n++) {
        const double middle[3] = {0}, none[3] = {0};
        mesh body, *const m = &body;
        stage_run(&on, 1);
        assert_int_equal(solid_mesh(&bar, middle, 1, m), 0);
        const double time = fmin(simulation_time(on.sim), 0.2);
        const double angle = acos(-1) / 180 * 1000 * time;
        for (int i = 0; i < m->vertex_count; i++) {
            double *at = m->position[i];
            const double x = at[0], z = at[2];
            at[0] = bar.position[0] + cos(angle) * x + sin(angle) * z;
            at[1] += bar.position[1];
            at[2] = bar.position[2] + 0.1 * time - sin(angle) * x + cos(angle) * z;
        }
        crossed += crossings(&on) + crossings_with(&on, m, none);
        mesh_free(m);
    }
    assert_int_equal(crossed, 0);
    assert_true(on.sim->account.effects[EFFECT_CONTACT].visited > 0);
    for (int i = 0; i < on.m.vertex_count; i++)
        if (on.m.material[i][0] < 0.001)
            assert_near(simulation_positions(on.sim)[i][2], 0.05 + 0.1 * 0.24, 1e-12);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_end(&on);
}

/* The cloth falls as far as it should, however short the step is. */
static void short_steps_fall(void **state) {
    (void)state;
    stage on = sheet_over(NULL, 0, 3, 1);
    double mean[3];
    on.s.time.step = 1e-5;
    stage_begin(&on);
    stage_run(&on, 20);
    mean_velocity(&on, mean);
    assert_near(mean[2], -9.81 * 20e-5, 1e-9);
    stage_end(&on);
}

/* Cloth whose edges are shorter than the gap does not push itself apart, but two sheets do. */
static void fine_cloth_stays(void **state) {
    (void)state;
    stage on = sheet_over(NULL, 0, 5, 0);
    on.s.surroundings.gravity[2] = 0;
    on.s.self_collision.gap = 0.1;
    stage_begin(&on);
    stage_run(&on, 5);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_below(vector_length(simulation_velocities(on.sim)[i]), 1e-9);
    stage_end(&on);
}

/* A step that is stopped has no effect, and a simulation that was saved continues with the same
 * bits. */
static void steps_may_be_stopped_and_saved(void **state) {
    volatile sig_atomic_t stop = 0;
    char error[256] = "";
    collider plane = ground, other = ground;
    (void)state;
    stage whole = sheet_over(&plane, 1, 4, 0.02), part = sheet_over(&other, 1, 4, 0.02);
    stage_begin(&whole);
    stage_begin(&part);
    simulation_stop_when(part.sim, &stop);
    stage_run(&whole, 12);
    stage_run(&part, 3);
    stop = 1;
    assert_int_equal(simulation_step(part.sim, error), 1);
    /* The step in which contact begins is stopped in the next iteration. */
    simulation_stop_when(part.sim, &part.sim->barrier->contact.list.contacts);
    int steps = 2, status = 0; /* steps: at last, the number of those not undone */
    long iterations = 0;
    for (; status == 0 && steps < 12; steps++) {
        assert_int_equal(part.sim->barrier->contact.list.contacts, 0);
        iterations = simulation_counts(part.sim).newton_iterations;
        status = simulation_step(part.sim, error);
    }
    assert_int_equal(status, 1);
    assert_in_range(steps, 4, 11);
    assert_near(simulation_time(part.sim), 0.01 * steps, 1e-12);
    assert_int_equal(simulation_counts(part.sim).newton_iterations, iterations);
    const size_t size = simulation_saved_size(part.sim);
    unsigned char *bytes = malloc(size);
    simulation_save(part.sim, bytes, size);
    simulation_free(part.sim);
    stage_begin(&part);
    assert_int_equal(simulation_restore(part.sim, bytes, size), 0);
    free(bytes);
    stage_run(&part, 12 - steps);
    assert_memory_equal(simulation_positions(part.sim), simulation_positions(whole.sim),
                        (size_t)whole.m.vertex_count * sizeof(double[3]));
    assert_memory_equal(simulation_velocities(part.sim), simulation_velocities(whole.sim),
                        (size_t)whole.m.vertex_count * sizeof(double[3]));
    /* The order of pairs depends only on searches of this step. */
    assert_memory_equal(part.sim->barrier->contact.searched, whole.sim->barrier->contact.searched,
                        (size_t)whole.m.vertex_count * sizeof(double[3]));
    stage_end(&whole);
    stage_end(&part);
}

/* Settings that do not apply to the barrier are refused. */
static void settings_are_refused(void **state) {
    (void)state;
    for (int k = 0; k < 4; k++) {
        char error[256] = "";
        const char *const expected[] = {"time.integrator", "solution.method", "solution.precision",
                                        "gap above 0"};
        collider plane = ground;
        stage on = sheet_over(&plane, 1, 3, 0.1);
        on.s.time.integrator = k == 0 ? INTEGRATOR_BDF2 : INTEGRATOR_EULER;
        on.s.solution.method = k == 1 ? METHOD_DIRECT : METHOD_CONJUGATE_GRADIENTS;
        on.s.solution.precision = k == 2 ? PRECISION_MIXED : PRECISION_DOUBLE;
        plane.gap = k == 3 ? 0 : 0.004;
        on.sim = simulation_new(&on.m, &on.s, error);
        assert_null(on.sim);
        assert_non_null(strstr(error, expected[k]));
        stage_end(&on);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sheets_slide_and_stick),  cmocka_unit_test(a_moving_floor_carries),
        cmocka_unit_test(bars_turn_and_pins_move), cmocka_unit_test(short_steps_fall),
        cmocka_unit_test(fine_cloth_stays),        cmocka_unit_test(steps_may_be_stopped_and_saved),
        cmocka_unit_test(settings_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
