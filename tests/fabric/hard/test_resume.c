/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A simulation that was saved after any step and restored continues with the same bits. */
#include <stdlib.h>
#include <string.h>

#include "solver/solver_direct.h"
#include "stage.h"

enum { STEPS = 8 };

/** A simulation that was saved after some step. */
typedef struct saved {
    unsigned char *bytes;
    size_t size;
} saved;

/* Measured seconds need not be equal. */
static void forget_seconds(simulation *sim) {
    for (int k = 0; k < PHASE_COUNT; k++)
        sim->account.phases[k].seconds = 0;
    for (int k = 0; k < EFFECT_COUNT; k++)
        sim->account.effects[k].seconds = 0;
}

static saved save(simulation *sim) {
    saved s = {.size = simulation_saved_size(sim)};
    s.bytes = malloc(s.size);
    assert_non_null(s.bytes);
    forget_seconds(sim);
    simulation_save(sim, s.bytes, s.size);
    return s;
}

static void assert_same(const saved *a, const saved *b) {
    assert_int_equal(a->size, b->size);
    assert_memory_equal(a->bytes, b->bytes, a->size);
}

/* Events of the run that was interrupted after each step, so that a test can check that its event
 * occurred. */
typedef struct met {
    int halved, sticking, sliding, two_states, plan_changed;
    long rejected, self_visits, limited;
} met;

static void look(const stage *on, met *found) {
    const simulation *sim = on->sim;
    long contacts = 0, sticking = 0;
    collisions_count(&sim->collisions, &contacts, &sticking);
    found->halved |= sim->step.ticks < TICKS_PER_STEP;
    found->sticking |= sticking > 0;
    found->sliding |= contacts > sticking;
    found->two_states |= sim->integrator.h_before > 0;
    found->plan_changed |= sim->account.plans_changed > 0;
    found->rejected = sim->account.steps_rejected;
    found->self_visits = sim->self_collision.visits;
    found->limited = sim->account.effects[EFFECT_STRAIN_LIMIT].visited;
}

/* Runs a stage, saves it after every step, and continues from each. make: returns a stage that has
 * not begun. */
static met go_on_from_everywhere(stage (*make)(int), int variant) {
    saved after[STEPS + 1];
    met found = {0};
    stage whole = make(variant);
    stage_begin(&whole);
    for (int n = 0; n <= STEPS; n++) {
        if (n > 0)
            stage_run(&whole, 1);
        after[n] = save(whole.sim);
        look(&whole, &found);
    }
    for (int n = 0; n <= STEPS; n += stage_compares_bits() ? STEPS / 2 : 1) {
        stage rest = make(variant);
        stage_begin(&rest);
        assert_int_equal(simulation_restore(rest.sim, after[n].bytes, after[n].size), 0);
        saved again = save(rest.sim);
        assert_same(&after[n], &again);
        stage_run(&rest, STEPS - n);
        saved end = save(rest.sim);
        assert_same(&after[STEPS], &end);
        assert_true(simulation_time(rest.sim) == simulation_time(whole.sim));
        free(again.bytes);
        free(end.bytes);
        stage_end(&rest);
    }
    for (int n = 0; n <= STEPS; n++)
        free(after[n].bytes);
    stage_end(&whole);
    return found;
}

static pin pins[2] = {{.low = {-0.01, -0.01},
                       .high = {0.01, 2},
                       .velocity = {0.3, 0, 0.2},
                       .move_from = 0.05,
                       .move_until = 0.11,
                       .until = 0.17},
                      {.low = {0.55, -0.01}, .high = {0.65, 0.02}}};
static collider balls[2] = {{.kind = COLLIDER_SPHERE,
                             .position = {0.35, 0.3, -0.11},
                             .velocity = {0, 0.05, 0},
                             .size = {0.1},
                             .friction = 0.2,
                             .gap = 0.01,
                             .from = 0.01},
                            {.kind = COLLIDER_PLANE,
                             .position = {0, 0, -0.03},
                             .axis = {0, 0, 1},
                             .friction = 0.9,
                             .gap = 0.005,
                             .until = 0.19}};

/* Wind that begins, pins that move and let go, a ball that arrives, and a floor that is removed. */
static stage crowded(int integrator) {
    stage on = stage_of(cloth_sheet(7, 6, 0.1, 0.3, 3), cloth_scene());
    on.s.time.integrator = integrator;
    on.s.time.step = 0.025;
    on.s.solution.tolerance = 1e-4;
    on.s.solution.newton_tolerance = 1e-4;
    on.s.solution.newton_iterations = 50;
    on.s.material.bend = 1e-4;
    on.s.surroundings.drag = 0.4;
    on.s.surroundings.wind[1] = 3;
    on.s.surroundings.wind_from = 0.06;
    on.s.surroundings.wind_until = 0.16;
    on.s.material.strain_limit = 0.01;
    on.s.self_collision.gap = 0.004;
    on.s.self_collision.friction = 0.3;
    on.s.pins = pins;
    on.s.pin_count = 2;
    on.s.colliders = balls;
    on.s.collider_count = 2;
    return on;
}

static void test_everything_at_once(void **state) {
    (void)state;
    for (int integrator = INTEGRATOR_LINEAR_EULER; integrator <= INTEGRATOR_MIDPOINT;
         integrator++) {
        const met found = go_on_from_everywhere(crowded, integrator);
        assert_true(found.sticking || found.sliding);
        assert_true(found.plan_changed);
        assert_true(found.self_visits > 0);
        assert_true(found.limited > 0);
    }
}

/* Without contacts BDF2 uses two previous states. */
static stage swinging(int integrator) {
    stage on = crowded(integrator);
    on.s.collider_count = 0;
    on.s.self_collision.gap = 0;
    return on;
}

static void test_integrators(void **state) {
    (void)state;
    for (int integrator = INTEGRATOR_LINEAR_EULER; integrator <= INTEGRATOR_MIDPOINT; integrator++)
        assert_int_equal(go_on_from_everywhere(swinging, integrator).two_states,
                         integrator == INTEGRATOR_BDF2);
}

/* A storm of 1 km/s with steps that are too long for it: they are halved and become longer
 * again. */
static stage stormy(int integrator) {
    static pin held = {.low = {-0.01, -0.01}, .high = {0.01, 2}};
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 6), cloth_scene());
    on.s.time.integrator = integrator;
    on.s.time.step = 0.033;
    on.s.surroundings.drag = 1;
    on.s.surroundings.wind[0] = on.s.surroundings.wind[2] = 1e3;
    on.s.surroundings.wind_from = 2 * 0.033;
    on.s.surroundings.wind_until = 4 * 0.033;
    on.s.solution.newton_tolerance = 1e-4;
    on.s.solution.newton_iterations = 50;
    on.s.material.bend = 1e-5;
    on.s.pins = &held;
    on.s.pin_count = 1;
    return on;
}

static void test_halved_steps(void **state) {
    (void)state;
    for (int integrator = INTEGRATOR_LINEAR_EULER; integrator <= INTEGRATOR_BDF2; integrator++) {
        const met found = go_on_from_everywhere(stormy, integrator);
        assert_true(found.halved);
        assert_true(found.rejected > 0);
    }
}

/* Steps that were halved are stopped after their first part: `stop` is the number of ticks that are
 * done. They are undone, and the saved simulation continues with the same bits. */
static void test_halved_steps_are_stopped(void **state) {
    (void)state;
    char error[256] = "";
    stage whole = stormy(INTEGRATOR_BDF2), part = stormy(INTEGRATOR_BDF2);
    int stopped = 0;
    stage_begin(&whole);
    stage_begin(&part);
    for (int n = 0; n < STEPS; n++) {
        simulation_stop_when(part.sim, &part.sim->state.ticks_done);
        const int status = simulation_step(part.sim, error);
        if (status != 0) {
            assert_int_equal(status, 1);
            assert_int_equal(part.sim->state.frame, n);
            assert_int_equal(part.sim->state.ticks_done, 0);
            saved before = save(part.sim);
            simulation_free(part.sim);
            stage_begin(&part);
            assert_int_equal(simulation_restore(part.sim, before.bytes, before.size), 0);
            free(before.bytes);
            stage_run(&part, 1);
            stopped++;
        }
        stage_run(&whole, 1);
        saved one = save(whole.sim), other = save(part.sim);
        assert_same(&one, &other);
        free(one.bytes);
        free(other.bytes);
    }
    assert_in_range(stopped, 2, STEPS - 2);
    stage_end(&whole);
    stage_end(&part);
}

/* A hinge's wing is turned around repeatedly: its angle must be remembered beyond full turns. */
static stage winding(int integrator) {
    static const double material[4][2] = {{0, 0}, {0, 1}, {-1, 0.5}, {1, 0.5}};
    static const int triangle[2][3] = {{0, 1, 2}, {1, 0, 3}};
    stage on = stage_of(cloth_of(4, material, 2, triangle), cloth_scene());
    static pin edge = {.low = {-1.1, -0.1}, .high = {0.1, 1.1}};
    on.s.time.integrator = integrator;
    on.s.time.step = 0.01;
    on.s.solution.newton_tolerance = 1e-6;
    on.s.solution.newton_iterations = 50;
    on.s.material.bend = 1e-3;
    on.s.pins = &edge;
    on.s.pin_count = 1;
    return on;
}

static void test_wound_hinge(void **state) {
    (void)state;
    stage whole = winding(INTEGRATOR_EULER), rest = winding(INTEGRATOR_EULER);
    stage_begin(&whole);
    stage_begin(&rest);
    whole.sim->cloth.hinges.angle[0] = 2 * acos(-1.0); /* one full turn, and flat again */
    stage_changed(&whole);
    saved before = save(whole.sim);
    assert_int_equal(simulation_restore(rest.sim, before.bytes, before.size), 0);
    stage_run(&whole, 2);
    stage_run(&rest, 2);
    saved one = save(whole.sim), other = save(rest.sim);
    assert_true(fabs(rest.sim->cloth.hinges.angle[0]) > 3.2);
    assert_same(&one, &other);
    free(before.bytes);
    free(one.bytes);
    free(other.bytes);
    stage_end(&whole);
    stage_end(&rest);
}

typedef struct solution {
    solver_method method;
    preconditioner_kind preconditioner;
    solver_precision precision;
} solution;

static const solution solutions[] = {
    {METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_BLOCK_JACOBI, PRECISION_DOUBLE},
    {METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_INCOMPLETE_CHOLESKY, PRECISION_DOUBLE},
    {METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_GAUSS_SEIDEL, PRECISION_FLOAT},
    {METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_JACOBI, PRECISION_MIXED},
    {METHOD_DIRECT, PRECONDITIONER_NONE, PRECISION_DOUBLE},
};

static stage solved(int number) {
    stage on = crowded(INTEGRATOR_LINEAR_EULER);
    on.s.solution.method = (int)solutions[number].method;
    on.s.solution.preconditioner = (int)solutions[number].preconditioner;
    on.s.solution.precision = (int)solutions[number].precision;
    return on;
}

static void test_solvers(void **state) {
    (void)state;
    for (int n = 0; n < (int)(sizeof solutions / sizeof *solutions); n++)
        if (solutions[n].method != METHOD_DIRECT || direct_solver_available())
            assert_true(go_on_from_everywhere(solved, n).limited > 0);
}

/* Slivers on which the conjugate gradients fail so often that systems are soon solved directly. */
static stage slivers(int integrator) {
    stage on = stage_of_slivers();
    on.s.time.integrator = integrator;
    return on;
}

static void test_direct_solutions_at_once(void **state) {
    (void)state;
    if (direct_solver_available())
        go_on_from_everywhere(slivers, INTEGRATOR_LINEAR_EULER);
}

/* Too few or too many bytes, or bytes that are no simulation, are refused. */
static void test_wrong_bytes(void **state) {
    (void)state;
    if (stage_compares_bits())
        return; /* would make a thousand simulations without steps */
    stage on = crowded(INTEGRATOR_LINEAR_EULER);
    stage_begin(&on);
    stage_run(&on, 4);
    saved whole = save(on.sim);
    unsigned char *longer = malloc(whole.size + 1);
    assert_non_null(longer);
    memcpy(longer, whole.bytes, whole.size);
    longer[whole.size] = 0;
    for (size_t size = 0; size <= whole.size + 1; size += size < whole.size - 300 ? 97 : 1) {
        stage other = crowded(INTEGRATOR_LINEAR_EULER);
        stage_begin(&other);
        assert_int_equal(simulation_restore(other.sim, longer, size), size == whole.size ? 0 : -1);
        stage_end(&other);
    }
    for (int ticks = -1; ticks < 5; ticks++) { /* a step's length depends on the frame's number */
        stage other = crowded(INTEGRATOR_LINEAR_EULER);
        stage_begin(&other);
        memcpy(longer + 8, &ticks, sizeof ticks);
        const int status = simulation_restore(other.sim, longer, whole.size);
        assert_int_equal(status, ticks == 1 || ticks == 2 || ticks == 4 ? 0 : -1);
        stage_end(&other);
    }
    free(longer);
    free(whole.bytes);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_everything_at_once),
        cmocka_unit_test(test_integrators),
        cmocka_unit_test(test_halved_steps),
        cmocka_unit_test(test_halved_steps_are_stopped),
        cmocka_unit_test(test_wound_hinge),
        cmocka_unit_test(test_solvers),
        cmocka_unit_test(test_direct_solutions_at_once),
        cmocka_unit_test(test_wrong_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
