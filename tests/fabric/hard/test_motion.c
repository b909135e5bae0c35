/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Hard cases of motion: momentum, indefinite systems, stiffness, mass, order, and refinement.
 * Numbers such as S07 refer to docs/fabric-hard-cases.md. */
#include "stage.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

static stage free_sheet(int columns, double noise) {
    stage on = stage_of(cloth_sheet(columns, columns, 0.1, 0.3, 1), cloth_scene());
    unsigned seed = 3;
    memset(on.s.surroundings.gravity, 0, sizeof on.s.surroundings.gravity);
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            on.m.position[i][a] += noise * random_number(&seed);
    return on;
}

static void angular_momentum(const stage *on, double sum[3]) {
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < on->m.vertex_count; i++) {
        double part[3];
        vector_cross(on->sim->state.x[i], on->sim->state.v[i], part);
        vector_add_scaled(sum, on->sim->cloth.mass[i], part, sum);
    }
}

/* Returns the angular momentum that a sheet turning at 2 rad/s loses in 0.64 s. */
static double momentum_lost(double h) {
    stage on = free_sheet(6, 0);
    double before[3], after[3];
    on.s.time.step = h;
    stage_begin(&on);
    for (int i = 0; i < on.m.vertex_count; i++) {
        on.sim->state.v[i][0] = -2 * (on.sim->state.x[i][1] - 0.25);
        on.sim->state.v[i][1] = 2 * (on.sim->state.x[i][0] - 0.25);
    }
    stage_changed(&on);
    angular_momentum(&on, before);
    stage_run(&on, (int)(0.64 / h + 0.5));
    angular_momentum(&on, after);
    vector_subtract(after, before, after);
    stage_end(&on);
    return vector_length(after) / vector_length(before);
}

static void S07_angular_momentum_is_lost_in_order_of_h(void **state) {
    (void)state;
    const double coarse = momentum_lost(0.0025), fine = momentum_lost(0.00125);
    print_message("S07 lost %.3g and %.3g, ratio %.3f\n", coarse, fine, fine / coarse);
    assert_near(fine / coarse, 0.5, 0.15);
}

static stage compressed_sheet(void) {
    stage on = free_sheet(8, 0);
    unsigned seed = 3;
    on.s.time.step = 0.033;
    for (int i = 0; i < on.m.vertex_count; i++) {
        on.m.position[i][0] *= 0.8;
        on.m.position[i][2] = 1e-4 * random_number(&seed);
    }
    return on;
}

/* Computes h f, the right side at positions x. The velocities v must be 0. */
static void force_at(simulation *sim, double (*x)[3], double (*v)[3], double *b) {
    double(*kept_x)[3] = sim->state.x, (*kept_v)[3] = sim->state.v;
    sim->state.x = x;
    sim->state.v = v;
    evaluateForces(sim);
    memcpy(b, sim->system.b, sizeof *sim->system.b * (size_t)sim->mesh->vertex_count);
    sim->state.x = kept_x;
    sim->state.v = kept_v;
}

/* Replaces A by the exact M - h^2 df/dx, from differences of the forces, without clamping or
 * Gauss-Newton. Only vertices that share an element are coupled, so A has all blocks needed. */
static void use_exact_jacobian(simulation *sim) {
    const int n = 3 * sim->mesh->vertex_count;
    const double d = 1e-6;
    block_matrix *A = &sim->system.A;
    double *exact = calloc((size_t)n * (size_t)n, sizeof *exact);
    double *up = calloc((size_t)n, sizeof *up), *down = calloc((size_t)n, sizeof *down);
    double(*x)[3] = calloc((size_t)n, sizeof *x), (*still)[3] = calloc((size_t)n, sizeof *still);
    memcpy(x, sim->state.x, sizeof *x * (size_t)sim->mesh->vertex_count);
    for (int k = 0; k < n; k++) {
        const double was = (&x[0][0])[k];
        (&x[0][0])[k] = was + d;
        force_at(sim, x, still, up);
        (&x[0][0])[k] = was - d;
        force_at(sim, x, still, down);
        (&x[0][0])[k] = was;
        for (int i = 0; i < n; i++)
            exact[i * n + k] = -sim->step.h * (up[i] - down[i]) / (2 * d);
    }
    evaluateForces(sim);
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) {
                    const int row = 3 * i + r, column = 3 * A->column[k] + c;
                    A->value[k][r][c] = (exact[row * n + column] + exact[column * n + row]) / 2 +
                                        (row == column ? sim->cloth.mass[i] : 0);
                }
    free(exact);
    free(up);
    free(down);
    free(x);
    free(still);
}

static void S09_clamped_system_is_solved(void **state) {
    (void)state;
    stage on = compressed_sheet();
    stage_begin(&on);
    const double first = stage_energy(&on);
    for (int n = 0; n < 60; n++) {
        stage_run(&on, 1);
        assert_int_equal(on.sim->step.solver_status, SOLVER_CONVERGED);
        assert_below(stage_energy(&on), first);
    }
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_end(&on);
}

/* The negative control: the same cloth and solver with the exact Jacobian. */
static void S09_unclamped_system_breaks_down(void **state) {
    (void)state;
    stage on = compressed_sheet();
    stage_begin(&on);
    evaluateForces(on.sim);
    use_exact_jacobian(on.sim);
    collisionDetection(on.sim);
    solveSystem(on.sim);
    assert_int_equal(on.sim->step.solver_status, SOLVER_BREAKDOWN);
    updateSystem(on.sim);
    assert_int_equal(simulation_counts(on.sim).rejected, 1);
    stage_end(&on);
}

static stage held_sheet(int columns) {
    static pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}, .velocity = {0, 0, 0}};
    stage on = stage_of(cloth_sheet(columns, columns, 0.1, 0.3, 1), cloth_scene());
    on.s.pins = &hold;
    on.s.pin_count = 1;
    on.s.solution.tolerance = 1e-4;
    return on;
}

static double lowest(const stage *on) {
    double z = INFINITY;
    for (int i = 0; i < on->m.vertex_count; i++)
        z = fmin(z, on->sim->state.x[i][2]);
    return z;
}

/* The result must not only be finite: its energy must come from gravity. A step of 100 s needs
 * parts shorter than a thousandth of it if the cloth is stiff, which is refused with a message. */
static void S17_huge_steps_gain_no_energy(void **state) {
    (void)state;
    const double steps[] = {1e-3, 1.0 / 30, 1, 100}, stiffness[] = {1, 1e2, 1e4, 1e6, 1e8};
    double worst = 0;
    int refused = 0;
    for (int h = 0; h < 4; h++)
        for (int k = 0; k < 5; k++) {
            stage on = held_sheet(5);
            on.s.time.step = steps[h];
            on.s.material.stretch = stiffness[k];
            on.s.monitor.energy = 1e-3;
            stage_begin(&on);
            for (int n = 0; n < 4; n++) {
                double fallen = 0;
                char error[256] = "";
                if (simulation_step(on.sim, error) != 0) {
                    assert_true(steps[h] == 100);
                    assert_non_null(strstr(error, "energy"));
                    refused++;
                    break;
                }
                stage_assert_finite(&on);
                for (int i = 0; i < on.m.vertex_count; i++)
                    fallen -= on.sim->cloth.mass[i] * 9.81 * on.sim->state.x[i][2];
                const double scale = on.sim->cloth.total_mass * 9.81 * 0.4;
                worst = fmax(worst, (stage_energy(&on) - fallen) / scale);
                assert_below(stage_energy(&on) - fallen, 0.01 * scale);
            }
            stage_end(&on);
        }
    print_message("S17 energy above gravity's work, by m g L: %.3g; refused: %d\n", worst, refused);
    assert_in_range(refused, 0, 5);
}

/* Makes a step of 1/30 s of a flap of 1e8 N/m, once without a limit of energy and once with one, so
 * that the monitor subdivides the step. */
static void S26_energy_is_watched(void **state) {
    (void)state;
    for (int watched = 0; watched < 2; watched++) {
        stage on = held_sheet(5);
        int count;
        on.s.time.step = 1.0 / 30;
        on.s.material.stretch = 1e8;
        on.s.monitor.energy = watched ? 0.25 : 1e300;
        stage_begin(&on);
        const monitor *m = &on.sim->monitor;
        stage_run(&on, 1);
        assert_int_equal(m->energy > 10 * m->reference, !watched);
        stage_run(&on, 2);
        const rejection *log = simulation_rejections(on.sim, &count);
        assert_near(simulation_time(on.sim), 3 * on.s.time.step, 1e-15);
        assert_int_equal(count, simulation_counts(on.sim).rejected);
        assert_int_equal(count > 0, watched);
        for (int n = 0; n < count; n++) {
            assert_string_equal(log[n].reason, "energy");
            assert_true(log[n].value > log[n].limit && log[n].h > 0);
            assert_true(n == 0 || log[n].time >= log[n - 1].time);
        }
        stage_end(&on);
    }
}

/* Wind of 1000 m/s begins between two steps. */
static void S26_sudden_storm(void **state) {
    (void)state;
    stage on = held_sheet(6);
    on.s.time.step = 0.033;
    on.s.surroundings.drag = 1;
    on.s.surroundings.wind[0] = on.s.surroundings.wind[2] = 1e3;
    on.s.surroundings.wind_from = 2 * 0.033;
    stage_begin(&on);
    stage_run(&on, 2);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_run(&on, 3);
    assert_true(simulation_counts(on.sim).rejected > 0);
    assert_near(simulation_time(on.sim), 5 * 0.033, 1e-15);
    stage_assert_finite(&on);
    stage_end(&on);
}

/* Stiffness differs by eight decades between the halves of the cloth. */
static void S18_stiffness_ratio(void **state) {
    (void)state;
    long most = 0;
    stage on = held_sheet(8);
    on.s.time.step = 1.0 / 30;
    stage_begin(&on);
    for (int t = 0; t < on.sim->cloth.triangles.count; t += 2)
        on.sim->cloth.triangles.rest[t].area *= 1e8;
    for (int n = 0; n < 10; n++) {
        const long before = simulation_counts(on.sim).iterations,
                   rounds = on.sim->account.phases[2].calls;
        stage_run(&on, 1);
        const long solves = on.sim->account.phases[2].calls - rounds;
        const long each = (simulation_counts(on.sim).iterations - before) / solves;
        most = each > most ? each : most;
    }
    print_message("S18 iterations a solve: %ld\n", most);
    assert_int_equal(on.sim->step.solver_status, SOLVER_CONVERGED);
    assert_in_range(most, 1, 3000);
    stage_assert_finite(&on);
    assert_true(lowest(&on) > -0.7 * 1.5);
    stage_end(&on);
}

static void S19_mass_ratio(void **state) {
    (void)state;
    long before = LONG_MAX;
    for (double ratio = 1; ratio <= 1e8; ratio *= 100) {
        stage on = held_sheet(8);
        on.s.time.step = 1.0 / 30;
        on.s.solution.tolerance = 1e-6;
        stage_begin(&on);
        for (int i = 0; i < on.m.vertex_count; i += 2)
            on.sim->cloth.mass[i] *= ratio;
        stage_run(&on, 3);
        const long now = simulation_counts(on.sim).iterations;
        print_message("S19 mass ratio %g: %ld iterations\n", ratio, now);
        assert_int_equal(simulation_counts(on.sim).rejected, 0);
        stage_assert_finite(&on);
        assert_true(now <= before);
        before = now;
        stage_end(&on);
    }
}

/* Returns a flap held at one edge that falls for 0.32 s in `steps` steps. */
static stage flap(int steps) {
    stage on = held_sheet(6);
    on.s.solution.tolerance = 1e-9;
    on.s.time.step = 0.32 / steps;
    stage_begin(&on);
    stage_run(&on, steps);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    return on;
}

static double rms_distance(const stage *a, const stage *b) {
    double sum = 0;
    for (int i = 0; i < a->m.vertex_count; i++)
        for (int c = 0; c < 3; c++)
            sum += pow(a->sim->state.x[i][c] - b->sim->state.x[i][c], 2);
    return sqrt(sum / a->m.vertex_count);
}

/* Differences between successive refinements: with order 1 each is half of the previous one. */
static void S31_order_in_time(void **state) {
    (void)state;
    stage run[4];
    double apart[3];
    for (int k = 0; k < 4; k++) {
        run[k] = flap(128 << k);
        if (k > 0)
            apart[k - 1] = rms_distance(&run[k - 1], &run[k]);
    }
    for (int k = 0; k < 2; k++) {
        const double order = log2(apart[k] / apart[k + 1]);
        print_message("S31 N = %d: order %.3f\n", 128 << k, order);
        assert_near(order, 1.1, 0.2);
    }
    for (int k = 0; k < 4; k++)
        stage_end(&run[k]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S07_angular_momentum_is_lost_in_order_of_h),
        cmocka_unit_test(S09_clamped_system_is_solved),
        cmocka_unit_test(S09_unclamped_system_breaks_down),
        cmocka_unit_test(S17_huge_steps_gain_no_energy),
        cmocka_unit_test(S18_stiffness_ratio),
        cmocka_unit_test(S19_mass_ratio),
        cmocka_unit_test(S26_energy_is_watched),
        cmocka_unit_test(S26_sudden_storm),
        cmocka_unit_test(S31_order_in_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
