/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The monitor's verdicts, the length of a step, and the results of a step of each integrator, each
 * alone. */
#include "stage.h"

#include <string.h>

static collider plane = {.kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .friction = 0.5, .gap = 0.005};

/* Returns the monitor's verdict on a step that ends with this cloth, of any energy. */
static monitor_verdict verdict_on(stage *on, int passing, int shortest) {
    simulation *sim = on->sim;
    monitored_step step = simulation_monitored(sim);
    step.finite = 1;
    step.status = SOLVER_CONVERGED;
    step.passing = passing;
    step.shortest = shortest;
    return monitor_check(&sim->monitor, &step);
}

static void test_monitor(void **state) {
    (void)state;
    collider below = plane;
    below.position[2] = -1;
    stage on = stage_with(&below);
    on.s.monitor.energy = 1e300;
    stage_begin(&on);
    double(*x)[3] = on.sim->step.x_next;
    const size_t bytes = sizeof *x * (size_t)on.m.vertex_count;
    const double falling[16][3] = {{0, 0, -2}};
    collisions_find_near(&on.sim->collisions, 0, 1, (const double(*)[3])on.m.position, falling,
                         NULL);
    memcpy(x, on.m.position, bytes);
    assert_int_equal(verdict_on(&on, 0, 0), STEP_GOOD);
    /* Strain: large but permitted, and too large. */
    for (int i = 0; i < on.m.vertex_count; i++)
        x[i][0] = 1.7 * on.m.position[i][0];
    assert_int_equal(verdict_on(&on, 0, 0), STEP_GOOD);
    for (int i = 0; i < on.m.vertex_count; i++)
        x[i][0] = 2.2 * on.m.position[i][0];
    assert_int_equal(verdict_on(&on, 0, 0), STEP_STRAIN);
    assert_int_equal(verdict_on(&on, 0, 1), STEP_GOOD);
    monitor_accept(&on.sim->monitor);
    assert_int_equal(simulation_faults(on.sim).strain, 1);
    assert_near(simulation_faults(on.sim).greatest_strain, 1.2, 1e-12);
    /* Penetration: deep, and deeper than before. */
    memcpy(x, on.m.position, bytes);
    x[3][2] = -1.05;
    on.s.monitor.growth = 1e300;
    assert_int_equal(verdict_on(&on, 0, 0), STEP_PENETRATION);
    assert_int_equal(verdict_on(&on, 0, 1), STEP_GOOD);
    monitor_accept(&on.sim->monitor);
    assert_int_equal(verdict_on(&on, 0, 0), STEP_GOOD);
    assert_int_equal(simulation_faults(on.sim).penetration, 1);
    assert_near(simulation_faults(on.sim).deepest, 0.05, 1e-12);
    /* Passing. */
    assert_int_equal(verdict_on(&on, 1, 0), STEP_PASSING);
    assert_int_equal(verdict_on(&on, 1, 1), STEP_GOOD);
    monitor_accept(&on.sim->monitor);
    assert_int_equal(simulation_faults(on.sim).passing, 1);
    stage_end(&on);
}

/* A small gain in each step is permitted, but not the sum of many: no state may have more energy
 * than all steps together were given. */
static void test_gains_add_up(void **state) {
    (void)state;
    collider below = plane;
    below.position[2] = -1;
    stage on = stage_with(&below);
    memset(on.s.surroundings.gravity, 0, sizeof on.s.surroundings.gravity);
    on.s.surroundings.drag = 0;
    on.s.monitor.energy = 0.1;
    stage_begin(&on);
    simulation *sim = on.sim;
    memcpy(sim->step.x_next, on.m.position, sizeof *sim->step.x_next * (size_t)on.m.vertex_count);
    for (int i = 0; i < on.m.vertex_count; i++)
        sim->state.v[i][0] = 1;
    stage_changed(&on);
    const double parts[3] = {1.05, 0.5, 0.59}; /* parts of the initial energy, in succession */
    for (int n = 0; n < 3; n++) {
        for (int i = 0; i < on.m.vertex_count; i++)
            sim->step.v_next[i][0] = sqrt(parts[n]);
        assert_int_equal(verdict_on(&on, 0, 1), STEP_GOOD);
        monitor_accept(&sim->monitor);
    }
    for (double part = 0.6; part < 1.15; part += 0.09) {
        for (int i = 0; i < on.m.vertex_count; i++)
            sim->step.v_next[i][0] = sqrt(part);
        const monitor_verdict verdict = verdict_on(&on, 0, 1);
        assert_int_equal(verdict, part < 1.1 ? STEP_GOOD : STEP_ENERGY);
        if (verdict == STEP_GOOD)
            monitor_accept(&sim->monitor);
    }
    assert_near(sim->monitor.value, 0.14 * sim->monitor.reference, 1e-12);
    stage_end(&on);
}

/* If halving did not prevent passing in 32 of the shortest steps in a row, passing is no longer a
 * reason to halve steps of twice the length, and so on. Strain remains a reason. One step in which
 * nothing passes resets the count. */
static void test_futile_halving(void **state) {
    (void)state;
    stage on = stage_with(&plane);
    on.s.monitor.energy = 1e300;
    stage_begin(&on);
    double(*x)[3] = on.sim->step.x_next;
    memcpy(x, on.m.position, sizeof *x * (size_t)on.m.vertex_count);
    for (int n = 0; n < 31; n++) {
        on.sim->step.ticks = 1;
        assert_int_equal(verdict_on(&on, 1, 1), STEP_GOOD);
        monitor_accept(&on.sim->monitor);
        on.sim->step.ticks = 2;
        assert_int_equal(verdict_on(&on, 1, 0), STEP_PASSING);
    }
    assert_int_equal(verdict_on(&on, 1, 1), STEP_GOOD);
    monitor_accept(&on.sim->monitor);
    on.sim->step.ticks = 2;
    assert_int_equal(verdict_on(&on, 1, 0), STEP_GOOD);
    on.sim->step.ticks = 4;
    assert_int_equal(verdict_on(&on, 1, 0), STEP_PASSING);
    for (int n = 0; n < 32; n++) {
        on.sim->step.ticks = 2;
        assert_int_equal(verdict_on(&on, 1, 0), STEP_GOOD);
        monitor_accept(&on.sim->monitor);
    }
    assert_int_equal(monitor_futile_parts(&on.sim->monitor), 4);
    assert_int_equal(simulation_faults(on.sim).passing, 64);
    for (int i = 0; i < on.m.vertex_count; i++)
        x[i][0] = 2.2 * on.m.position[i][0];
    assert_int_equal(verdict_on(&on, 0, 0), STEP_STRAIN);
    memcpy(x, on.m.position, sizeof *x * (size_t)on.m.vertex_count);
    assert_int_equal(verdict_on(&on, 0, 0), STEP_GOOD);
    monitor_accept(&on.sim->monitor);
    assert_int_equal(monitor_futile_parts(&on.sim->monitor), 1);
    stage_end(&on);
}

/* With the midpoint rule cloth lands on a plane and stays there. */
static void test_midpoint_does_not_bounce(void **state) {
    (void)state;
    collider ground = plane;
    ground.position[2] = -0.1;
    stage on = stage_with(&ground);
    on.s.time.integrator = INTEGRATOR_MIDPOINT;
    on.s.solution.newton_tolerance = 1e-6;
    on.s.solution.newton_iterations = 50;
    on.s.monitor.energy = 1e300;
    stage_begin(&on);
    int landed = 0;
    for (int n = 0; n < 30; n++) {
        stage_run(&on, 1);
        for (int i = 0; i < on.m.vertex_count; i++) {
            landed += on.sim->state.x[i][2] < -0.094;
            assert_below(on.sim->state.v[i][2], 0.1);
        }
    }
    assert_true(landed > 10);
    stage_end(&on);
}

/* BDF2 is exact for free fall, also if a step's length differs from the previous one. */
static void test_bdf2_of_unequal_steps(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.2, 3), cloth_scene());
    on.s.time.integrator = INTEGRATOR_BDF2;
    on.s.solution.newton_tolerance = 1e-10;
    on.s.solution.newton_iterations = 50;
    stage_begin(&on);
    stage_run(&on, 3);
    on.sim->step.ticks /= 2;
    on.sim->step.easy_steps = -100;
    stage_run(&on, 1);
    on.sim->step.ticks *= 2;
    stage_run(&on, 2);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_near(on.sim->state.v[i][2], -9.81 * simulation_time(on.sim), 1e-9);
    stage_end(&on);
}

/* Cloth of slivers, on which the conjugate gradients fail, is solved directly, and this is
 * reported. */
static void test_fallback_to_direct_solution(void **state) {
    (void)state;
    stage on = stage_of_slivers();
    stage_begin(&on);
    stage_run(&on, 3);
    double left[3] = {0, 0, 0}, size = 0; /* the pins' impulses account for the missing momentum */
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            const double mass = on.sim->cloth.mass[i], h = on.sim->step.h;
            left[a] += mass * (on.sim->step.dv[i][a] - h * on.s.surroundings.gravity[a]) +
                       on.sim->solver.residual[i][a];
            size += mass * h * 9.81;
        }
    for (int a = 0; a < 3; a++)
        assert_near(left[a], 0, 1e-6 * size);
    const run_faults f = simulation_faults(on.sim);
    print_message("S40 slivers: %ld solved directly, %ld iterations\n", f.solved_directly,
                  simulation_counts(on.sim).iterations);
    assert_true(f.solved_directly > 0 || on.sim->fallback.failed);
    assert_true(f.not_solved == 0 || on.sim->fallback.failed);
    stage_end(&on);
}

/* A halved step returns to its full length. */
static void test_step_grows_again(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.2, 3), cloth_scene());
    stage_begin(&on);
    on.sim->step.ticks /= 4;
    stage_run(&on, 5);
    assert_int_equal(on.sim->step.ticks, TICKS_PER_STEP);
    assert_in_range(simulation_counts(on.sim).taken, 7, 12);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_monitor),
        cmocka_unit_test(test_gains_add_up),
        cmocka_unit_test(test_futile_halving),
        cmocka_unit_test(test_midpoint_does_not_bounce),
        cmocka_unit_test(test_bdf2_of_unequal_steps),
        cmocka_unit_test(test_fallback_to_direct_solution),
        cmocka_unit_test(test_step_grows_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
