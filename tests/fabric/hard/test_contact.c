/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Hard cases of contact: rest, and thin or fast colliders. Numbers such as S27 refer to
 * docs/fabric-hard-cases.md. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

/* Encodes each vertex's contacts, and which of them stick, in one number. */
static void note_contacts(const stage *on, int *noted) {
    for (int i = 0; i < on->m.vertex_count; i++) {
        const vertex_contacts *of = &on->sim->collisions.before[i];
        noted[i] = 0;
        for (int n = 0; n < of->count; n++)
            noted[i] += 1 << of->list[n].collider;
    }
}

/* A cloth lies on the collider for 10 s: after 5 s nothing moves, and in the last second no contact
 * begins or ends. */
static void rests(collider *on_what, const char *name) {
    stage on = stage_of(cloth_sheet(9, 9, 0.05, 0.3, 1), cloth_scene());
    const int count = on.m.vertex_count, steps = 300;
    double worst_speed = 0, worst_move = 0;
    int flips = 0;
    on.s.time.step = 1.0 / 30;
    on.s.solution.tolerance = 1e-3;
    on.s.surroundings.drag = 1;
    on.s.material.bend = 1e-4;
    on.s.colliders = on_what;
    on.s.collider_count = 1;
    stage_begin(&on);
    double(*kept)[3] = calloc((size_t)count * (size_t)steps, sizeof *kept);
    int *before = calloc((size_t)count, sizeof *before), *now = calloc((size_t)count, sizeof *now);
    for (int n = 0; n < steps; n++) {
        stage_run(&on, 1);
        memcpy(kept + n * count, on.sim->state.x, sizeof *kept * (size_t)count);
        note_contacts(&on, now);
        double sum = 0;
        for (int i = 0; i < count; i++) {
            sum += vector_dot(on.sim->state.v[i], on.sim->state.v[i]);
            flips += n >= steps - 30 && now[i] != before[i];
        }
        memcpy(before, now, sizeof *now * (size_t)count);
        if (n >= steps / 2)
            worst_speed = fmax(worst_speed, sqrt(sum / count));
    }
    for (int k = steps / 2 * count; k < steps * count; k++) {
        double apart[3];
        vector_subtract(kept[k], kept[(steps - 1) * count + k % count], apart);
        worst_move = fmax(worst_move, vector_length(apart));
    }
    print_message("S27 %s: rms v %.3g m/s, moved %.3g m, flips %d\n", name, worst_speed, worst_move,
                  flips);
    assert_below(worst_speed, 1e-4);
    assert_below(worst_move, 1e-4);
    assert_int_equal(flips, 0);
    free(kept);
    free(before);
    free(now);
    stage_end(&on);
}

static void S27_cloth_rests_on_a_table(void **state) {
    (void)state;
    collider table = {.kind = COLLIDER_BOX,
                      .position = {0.2, 0.2, -0.1},
                      .size = {0.12, 0.12, 0.02},
                      .friction = 0.5,
                      .gap = 0.005};
    rests(&table, "table");
}

static void S27_cloth_rests_on_a_ball(void **state) {
    (void)state;
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0.2, 0.2, -0.3},
                     .size = {0.2},
                     .friction = 0.5,
                     .gap = 0.005};
    rests(&ball, "ball");
}

static void S28_nothing_falls_through_a_thin_table(void **state) {
    (void)state;
    collider table = {.kind = COLLIDER_BOX,
                      .position = {0.35, 0.35, -5},
                      .size = {2, 2, 0.005},
                      .friction = 0.3,
                      .gap = 0.004};
    stage on = stage_of(cloth_sheet(8, 8, 0.1, 0.3, 1), cloth_scene());
    on.s.time.step = 0.033;
    on.s.solution.tolerance = 1e-3;
    on.s.colliders = &table;
    on.s.collider_count = 1;
    stage_begin(&on);
    for (int n = 0; n < 60; n++) {
        stage_run(&on, 1);
        for (int i = 0; i < on.m.vertex_count; i++)
            assert_true(simulation_positions(on.sim)[i][2] > -4.995 + 0.004 - 1e-6);
    }
    assert_near(simulation_positions(on.sim)[0][2], -4.99, 0.01);
    stage_end(&on);
}

/* A thin rod at 5 m/s, five times its thickness per step, moves through a cloth held at two
 * edges. */
static void S28_nothing_is_run_through_by_a_fast_rod(void **state) {
    (void)state;
    collider rod = {.kind = COLLIDER_CYLINDER,
                    .position = {0.35, 0.35, 1},
                    .velocity = {0, 0, -5},
                    .axis = {1, 0, 0},
                    .size = {0.015, 2},
                    .friction = 0.3,
                    .gap = 0.004};
    pin hold[2] = {{.low = {-0.01, -1}, .high = {0.01, 1}, .velocity = {0, 0, 0}},
                   {.low = {0.69, -1}, .high = {0.71, 1}, .velocity = {0, 0, 0}}};
    stage on = stage_of(cloth_sheet(8, 8, 0.1, 0.3, 1), cloth_scene());
    double deepest = 0;
    on.s.time.step = 0.033;
    on.s.solution.tolerance = 1e-3;
    on.s.pins = hold;
    on.s.pin_count = 2;
    on.s.colliders = &rod;
    on.s.collider_count = 1;
    on.s.monitor.energy = 1e300; /* the pins hold the cloth, whatever energy this takes */
    stage_begin(&on);
    for (int n = 0; n < 9; n++) {
        stage_run(&on, 1);
        const double depth =
            collisions_depth(&on.sim->collisions, simulation_time(on.sim), on.sim->step.x_next);
        deepest = fmax(deepest, depth);
    }
    stage_assert_finite(&on);
    print_message("S28 rod: depth %.3g m\n", deepest);
    assert_below(deepest, 1e-6);
    stage_end(&on);
}

/* BDF2 needs smooth motion, which contact interrupts. After a step with contact it restarts from
 * that step's end; after a step without contact it uses the previous state. */
static void test_bdf2_forgets_at_contact(void **state) {
    (void)state;
    collider floor = {.kind = COLLIDER_PLANE,
                      .position = {0, 0, -0.05},
                      .axis = {0, 0, 1},
                      .friction = 0.3,
                      .gap = 0.005};
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.3, 2), cloth_scene());
    int with = 0, without = 0;
    on.s.time.integrator = INTEGRATOR_BDF2;
    on.s.solution.newton_tolerance = 1e-6;
    on.s.solution.newton_iterations = 50;
    on.s.colliders = &floor;
    on.s.collider_count = 1;
    stage_begin(&on);
    for (int n = 0; n < 20; n++) {
        long contacts;
        stage_run(&on, 1);
        collisions_count(&on.sim->collisions, &contacts, NULL);
        assert_int_equal(on.sim->integrator.h_before > 0, contacts == 0);
        with += contacts > 0;
        without += contacts == 0;
    }
    assert_true(with > 2 && without > 2);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S27_cloth_rests_on_a_table),
        cmocka_unit_test(S27_cloth_rests_on_a_ball),
        cmocka_unit_test(S28_nothing_falls_through_a_thin_table),
        cmocka_unit_test(S28_nothing_is_run_through_by_a_fast_rod),
        cmocka_unit_test(test_bdf2_forgets_at_contact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
