/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Integrators: their order, compared with an explicit method of fourth order, their equations, and
 * the quantities that they conserve. Numbers such as S07 refer to docs/fabric-hard-cases.md. */
#include "check.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "cloth.h"
#include "step/forces.h"
#include "step/simulation_state.h"

enum { COLUMNS = 5, ROWS = 4, COUNT = COLUMNS * ROWS };
typedef double vectors[COUNT][3];

typedef struct stage {
    mesh m;
    scene s;
    simulation *sim;
} stage;

/* Begins with a soft sheet, slightly bent and stretched, with every force active. */
static void begin(stage *on, integrator_kind kind, double step) {
    char error[256] = "";
    unsigned seed = 3;
    on->m = cloth_sheet(COLUMNS, ROWS, 0.1, 0.3, 1);
    for (int i = 0; i < COUNT; i++) {
        const double u = on->m.material[i][0], v = on->m.material[i][1];
        on->m.position[i][0] = 1.03 * u + 1e-4 * random_number(&seed);
        on->m.position[i][1] = 1.02 * v;
        on->m.position[i][2] = 0.05 * sin(6 * u) * cos(4 * v);
    }
    on->s.time.step = step;
    on->s.time.integrator = (int)kind;
    on->s.solution.newton_tolerance = 1e-11;
    on->s.solution.newton_iterations = 200;
    on->s.solution.tolerance = 1e-3;
    if (kind == INTEGRATOR_LINEAR_EULER)
        on->s.solution.tolerance = 1e-12;
    on->sim = simulation_new(&on->m, &on->s, error);
    if (!on->sim)
        fail_msg("%s", error);
}

static void run(stage *on, int steps) {
    char error[256] = "";
    for (int n = 0; n < steps; n++)
        if (simulation_step(on->sim, error) != 0)
            fail_msg("%s", error);
}

static void end(stage *on) {
    simulation_free(on->sim);
    cloth_free(&on->m);
}

static scene soft_scene(void) {
    scene s = cloth_scene();
    s.material.stretch = 4;
    s.material.shear = 2;
    s.material.bend = 1e-4;
    s.material.stretch_damping = 0.004;
    s.material.shear_damping = 0.002;
    s.material.bend_damping = 1e-6;
    s.surroundings.drag = 0.3;
    s.surroundings.wind[0] = 1;
    return s;
}

/* Computes the sum f of all effects' forces at x and v, N: the right side of the linear system for
 * h = 1, without the terms of derivatives. */
static void force_at(simulation *sim, vectors x, vectors v, vectors f) {
    static const vectors none;
    const double(*at)[3] = (const double(*)[3])x, (*moving)[3] = (const double(*)[3])v;
    const expansion here = {1, at, none, moving};
    forces_assemble(sim, &here);
    triangle_damping_forces(&sim->cloth.triangles, &sim->cloth.triangle_material, 1, at, moving,
                            sim->system.b);
    hinge_damping_forces(&sim->cloth.hinges, &sim->cloth.hinge_material, 1, at, moving,
                         sim->system.b);
    memcpy(f, sim->system.b, sizeof(vectors));
}

/* The classical Runge-Kutta method. */
static void runge_kutta(simulation *sim, double h, int steps, vectors x, vectors v) {
    static const double node[4] = {0, 0.5, 0.5, 1},
                        weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    for (int n = 0; n < steps; n++) {
        vectors xs, vs, f = {{0}}, dx = {{0}}, dv = {{0}}, rate = {{0}};
        for (int stage_number = 0; stage_number < 4; stage_number++) {
            for (int i = 0; i < COUNT; i++)
                for (int a = 0; a < 3; a++) {
                    xs[i][a] = x[i][a] + h * node[stage_number] * rate[i][a];
                    vs[i][a] = v[i][a] + h * node[stage_number] * f[i][a] / sim->cloth.mass[i];
                }
            force_at(sim, xs, vs, f);
            for (int i = 0; i < COUNT; i++)
                for (int a = 0; a < 3; a++) {
                    rate[i][a] = vs[i][a];
                    dx[i][a] += h * weight[stage_number] * vs[i][a];
                    dv[i][a] += h * weight[stage_number] * f[i][a] / sim->cloth.mass[i];
                }
        }
        for (int i = 0; i < COUNT; i++)
            for (int a = 0; a < 3; a++) {
                x[i][a] += dx[i][a];
                v[i][a] += dv[i][a];
            }
    }
}

static double distance(const double (*a)[3], vectors b) {
    double sum = 0;
    for (int i = 0; i < COUNT; i++)
        for (int c = 0; c < 3; c++)
            sum += (a[i][c] - b[i][c]) * (a[i][c] - b[i][c]);
    return sqrt(sum / (int)COUNT);
}

static const double duration = 0.08;

/* Returns the error after `duration` relative to the explicit method, m. */
static double error_of(const scene *of, integrator_kind kind, int steps, vectors exact) {
    stage on = {.s = *of};
    begin(&on, kind, duration / steps);
    run(&on, steps);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    const double error = distance(simulation_positions(on.sim), exact);
    end(&on);
    return error;
}

static void check_orders(const scene *of, vectors exact) {
    const double low[] = {0.85, 0.85, 1.75, 1.85}, high[] = {1.15, 1.15, 2.3, 2.2};
    for (int kind = INTEGRATOR_LINEAR_EULER; kind <= INTEGRATOR_MIDPOINT; kind++) {
        const double coarse = error_of(of, (integrator_kind)kind, 64, exact);
        const double fine = error_of(of, (integrator_kind)kind, 128, exact);
        const double order = log2(coarse / fine);
        if (!(order >= low[kind] && order <= high[kind]))
            fail_msg("integrator %d: errors %g and %g m, order %.3f", kind, coarse, fine, order);
    }
}

/* S31: halving the step divides the error by 2, or by 4 with methods of order 2. */
static void S31_orders(void **state) {
    (void)state;
    const scene soft = soft_scene();
    vectors x, v = {{0}};
    stage on = {.s = soft};
    begin(&on, INTEGRATOR_EULER, duration);
    memcpy(x, on.m.position, sizeof x);
    runge_kutta(on.sim, duration / 1000, 1000, x, v);
    end(&on);
    check_orders(&soft, x);
}

/* S31: the orders remain if wind begins and ends within steps. */
static void S31_orders_across_events(void **state) {
    (void)state;
    const double times[] = {0, 0.0213, 0.0477, duration};
    scene gusty = soft_scene();
    vectors x, v = {{0}};
    gusty.surroundings.wind[0] = 0;
    gusty.surroundings.wind[2] = 6;
    gusty.surroundings.wind_from = times[1];
    gusty.surroundings.wind_until = times[2];
    stage on = {.s = gusty};
    begin(&on, INTEGRATOR_EULER, duration);
    memcpy(x, on.m.position, sizeof x);
    for (int part = 0; part < 3; part++) {
        plan_return_to(on.sim, times[part] + 1e-12);
        assert_int_equal(on.sim->account.effects[EFFECT_WIND].on, part == 1);
        runge_kutta(on.sim, (times[part + 1] - times[part]) / 1000, 1000, x, v);
    }
    end(&on);
    check_orders(&gusty, x);
}

/* A step is shortened to end exactly when something begins or ends. Frames keep their times, and an
 * event at a frame's time shortens no step. */
static void test_steps_end_at_events(void **state) {
    (void)state;
    scene gusty = soft_scene();
    gusty.surroundings.wind_from = 0.0213;
    gusty.surroundings.wind_until = 0.03;
    stage on = {.s = gusty};
    begin(&on, INTEGRATOR_EULER, 0.01);
    const int taken[] = {1, 2, 4, 5, 6};
    for (int n = 0; n < 5; n++) {
        run(&on, 1);
        assert_int_equal(simulation_counts(on.sim).taken, taken[n]);
        assert_true(simulation_time(on.sim) == on.s.time.step * (n + 1));
        assert_int_equal(on.sim->account.effects[EFFECT_WIND].on, n == 2);
    }
    end(&on);
}

/* The step found satisfies M (v' - v) = h f(x', v') and x' = x + h v'. */
static void test_backward_euler_equation(void **state) {
    (void)state;
    const double h = 0.02;
    vectors x, v, f;
    stage on = {.s = soft_scene()};
    begin(&on, INTEGRATOR_EULER, h);
    run(&on, 3);
    memcpy(v, on.sim->state.v, sizeof v);
    run(&on, 1);
    memcpy(x, on.sim->state.x, sizeof x);
    vectors after;
    memcpy(after, on.sim->state.v, sizeof after);
    force_at(on.sim, x, after, f);
    for (int i = 0; i < COUNT; i++)
        for (int a = 0; a < 3; a++)
            assert_near(on.sim->cloth.mass[i] * (after[i][a] - v[i][a]), h * f[i][a], 1e-11);
    assert_true(simulation_counts(on.sim).newton_iterations >= 8);
    end(&on);
}

static double energy(simulation *sim) {
    double stretch, shear, kinetic = 0;
    triangle_energies(&sim->cloth.triangles, &sim->cloth.triangle_material,
                      (const double(*)[3])sim->state.x, &stretch, &shear);
    hinge_update_angles(&sim->cloth.hinges, (const double(*)[3])sim->state.x);
    for (int i = 0; i < COUNT; i++)
        kinetic += sim->cloth.mass[i] * vector_dot(sim->state.v[i], sim->state.v[i]) / 2;
    return stretch + shear + hinge_energy(&sim->cloth.hinges, &sim->cloth.hinge_material) + kinetic;
}

static scene free_scene(void) {
    scene s = soft_scene();
    s.material.stretch_damping = s.material.shear_damping = s.material.bend_damping =
        s.surroundings.drag = 0;
    memset(s.surroundings.gravity, 0, sizeof s.surroundings.gravity);
    return s;
}

/* A free sheet without damping: backward Euler loses energy, BDF2 loses less, and the midpoint rule
 * almost none. */
static void test_energy(void **state) {
    (void)state;
    double lost[4];
    for (int kind = INTEGRATOR_LINEAR_EULER; kind <= INTEGRATOR_MIDPOINT; kind++) {
        stage on = {.s = free_scene()};
        begin(&on, (integrator_kind)kind, 0.002);
        const double first = energy(on.sim);
        run(&on, 100);
        lost[kind] = 1 - energy(on.sim) / first;
        end(&on);
    }
    assert_in_range((int)(1000 * lost[INTEGRATOR_EULER]), 300, 999);
    assert_true(lost[INTEGRATOR_BDF2] > 0);
    assert_below(lost[INTEGRATOR_BDF2], 0.6 * lost[INTEGRATOR_EULER]);
    assert_below(fabs(lost[INTEGRATOR_MIDPOINT]), 0.02);
}

static void momenta(const simulation *sim, double linear[3], double angular[3]) {
    memset(linear, 0, sizeof(double[3]));
    memset(angular, 0, sizeof(double[3]));
    for (int i = 0; i < COUNT; i++) {
        double moment[3];
        vector_cross(sim->state.x[i], sim->state.v[i], moment);
        vector_add_scaled(linear, sim->cloth.mass[i], sim->state.v[i], linear);
        vector_add_scaled(angular, sim->cloth.mass[i], moment, angular);
    }
}

/* S07: the midpoint rule conserves angular momentum; with backward Euler the loss is proportional
 * to the step. */
static void S07_angular_momentum(void **state) {
    (void)state;
    double drift[4];
    for (int n = 0; n < 4; n++) {
        const int steps = n % 2 == 0 ? 20 : 40;
        stage on = {.s = free_scene()};
        on.s.monitor.energy = 1e300; /* the monitor does not know of this spin */
        begin(&on, n < 2 ? INTEGRATOR_EULER : INTEGRATOR_MIDPOINT, 0.04 / steps);
        for (int i = 0; i < COUNT; i++) {
            const double spin[3] = {0.3, 0.2, 5};
            vector_cross(spin, on.sim->state.x[i], on.sim->state.v[i]);
        }
        double linear[3], first[3], last[3], off[3];
        momenta(on.sim, linear, first);
        run(&on, steps);
        momenta(on.sim, linear, last);
        vector_subtract(last, first, off);
        drift[n] = vector_length(off) / vector_length(first);
        end(&on);
    }
    assert_near(drift[1] / drift[0], 0.5, 0.15);
    assert_below(drift[2], 1e-9);
    assert_below(drift[3], 1e-9);
}

/* The damping forces alone equal the linearised forces without stiffness. */
static void test_damping_forces(void **state) {
    (void)state;
    const double h = 0.01;
    stage on = {.s = soft_scene()};
    begin(&on, INTEGRATOR_EULER, h);
    simulation *sim = on.sim;
    const triangle_material t = {0, 0, 0.7, 0.4};
    const hinge_material b = {0, 0.3};
    double(*x)[3] = cloth_moved(&on.m, 0.02, 5), (*v)[3] = cloth_moved(&on.m, 1, 6);
    const double(*at)[3] = (const double(*)[3])x, (*moving)[3] = (const double(*)[3])v;
    vectors apart = {{0}};
    const double none[3] = {0, 0, 0};
    system_reset(&sim->system, sim->cloth.mass, none, h);
    triangle_forces(&sim->cloth.triangles, &t, h, at, moving, &sim->system);
    hinge_forces(&sim->cloth.hinges, &b, h, at, moving, &sim->system);
    triangle_damping_forces(&sim->cloth.triangles, &t, h, at, moving, apart);
    hinge_damping_forces(&sim->cloth.hinges, &b, h, at, moving, apart);
    for (int i = 0; i < COUNT; i++)
        for (int a = 0; a < 3; a++)
            assert_near(apart[i][a], sim->system.b[i][a], 1e-13);
    free(x);
    free(v);
    end(&on);
}

/* Every integrator that uses Newton's method, with moving pins and a ball in the way, at a large
 * step: pins are exact and nothing enters the ball. */
static void test_pins_and_contacts(void **state) {
    (void)state;
    pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 0.01}, .velocity = {0.1, 0, 0}};
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0.2, 0.15, -0.25},
                     .size = {0.15},
                     .friction = 0.4,
                     .gap = 0.01};
    for (int kind = INTEGRATOR_EULER; kind <= INTEGRATOR_MIDPOINT; kind++) {
        stage on = {.s = cloth_scene()};
        on.s.pins = &hold;
        on.s.pin_count = 1;
        on.s.colliders = &ball;
        on.s.collider_count = 1;
        begin(&on, (integrator_kind)kind, 0.02);
        on.s.solution.newton_tolerance = 1e-5;
        assert_int_equal(on.sim->collisions.pinned.count, 1);
        const int held = on.sim->collisions.pinned.list[0];
        run(&on, 60);
        assert_near(on.sim->state.x[held][0],
                    on.m.position[held][0] + 0.1 * simulation_time(on.sim), 1e-15);
        long contacts;
        collisions_count(&on.sim->collisions, &contacts, NULL);
        assert_true(contacts > 0);
        for (int i = 0; i < COUNT; i++) {
            double off[3];
            vector_subtract(on.sim->state.x[i], ball.position, off);
            assert_true(vector_length(off) > 0.15 + 0.01 - 2e-3);
        }
        end(&on);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S31_orders),
        cmocka_unit_test(test_backward_euler_equation),
        cmocka_unit_test(S31_orders_across_events),
        cmocka_unit_test(test_steps_end_at_events),
        cmocka_unit_test(test_energy),
        cmocka_unit_test(S07_angular_momentum),
        cmocka_unit_test(test_damping_forces),
        cmocka_unit_test(test_pins_and_contacts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
