/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Only effects that a scene uses are computed: others are not visited and change no bit. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

static pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}};

static stage held_sheet(void) {
    stage on = stage_of(cloth_sheet(7, 7, 0.1, 0.3, 1), cloth_scene());
    on.s.solution.tolerance = 1e-4;
    on.s.time.step = 0.02;
    on.s.surroundings.drag = 0.3;
    on.s.pins = &hold;
    on.s.pin_count = 1;
    return on;
}

static long visited(const stage *on, const char *name) {
    int count;
    const effect_account *all = simulation_effects(on->sim, &count);
    for (int k = 0; k < count; k++)
        if (strcmp(all[k].name, name) == 0)
            return all[k].visited;
    fail_msg("no effect is called %s", name);
    return -1;
}

/* Runs the plain scene and the scene changed by `change`. Both must have the same bits, and the
 * effect must not be visited. */
static void assert_changes_no_bit(void (*change)(scene *), const char *effect) {
    stage plain = held_sheet(), with = held_sheet();
    change(&with.s);
    stage_begin(&plain);
    stage_begin(&with);
    stage_run(&plain, 25);
    stage_run(&with, 25);
    const size_t bytes = sizeof(double[3]) * (size_t)plain.m.vertex_count;
    assert_memory_equal(plain.sim->state.x, with.sim->state.x, bytes);
    assert_memory_equal(plain.sim->state.v, with.sim->state.v, bytes);
    assert_int_equal(simulation_counts(plain.sim).iterations,
                     simulation_counts(with.sim).iterations);
    assert_int_equal(visited(&with, effect), 0);
    stage_end(&plain);
    stage_end(&with);
}

static collider shapes[] = {
    {.kind = COLLIDER_PLANE, .position = {0, 0, -50}, .axis = {0, 0, 1}, .gap = 0.01},
    {.kind = COLLIDER_BOX, .position = {0, 0, -50}, .size = {1, 1, 1}, .gap = 0.01},
    {.kind = COLLIDER_SPHERE, .position = {50, 0, 0}, .size = {1}, .friction = 1, .gap = 0.01},
    {.kind = COLLIDER_CYLINDER,
     .position = {0, 50, 0},
     .velocity = {0, 0, 9},
     .axis = {0, 0, 1},
     .size = {1, 2},
     .friction = 1,
     .gap = 0.01}};

static void add_far_colliders(scene *s) {
    s->colliders = shapes;
    s->collider_count = sizeof shapes / sizeof *shapes;
}

static void add_later_collider(scene *s) {
    static collider ball = {
        .kind = COLLIDER_SPHERE, .position = {0.3, 0.3, -0.1}, .size = {0.2}, .from = 0.5};
    s->colliders = &ball;
    s->collider_count = 1;
}

static void add_later_wind(scene *s) {
    s->surroundings.wind[1] = 5;
    s->surroundings.wind_from = 0.5;
}

static void add_pin_of_nothing(scene *s) {
    static pin pins[2];
    pins[0] = hold;
    pins[1] = (pin){.low = {7, 7}, .high = {8, 8}, .velocity = {1, 0, 0}};
    s->pins = pins;
    s->pin_count = 2;
}

static void test_far_colliders(void **state) {
    (void)state;
    assert_changes_no_bit(add_far_colliders, "contact");
    assert_changes_no_bit(add_far_colliders, "friction");
}

static void test_later_effects(void **state) {
    (void)state;
    assert_changes_no_bit(add_later_collider, "contact");
    assert_changes_no_bit(add_later_wind, "wind");
}

static void test_pin_of_nothing(void **state) {
    (void)state;
    assert_changes_no_bit(add_pin_of_nothing, "wind");
}

/* An effect with coefficient 0 is absent: neither visited nor stored. */
static void test_absent_effects_cost_nothing(void **state) {
    (void)state;
    static const char *const names[] = {
        "stretch", "shear", "bend", "stretch damping", "shear damping", "bend damping",   "gravity",
        "drag",    "wind",  "pins", "contact",         "friction",      "tangential drag"};
    stage on = stage_of(cloth_sheet(5, 5, 0.1, 0.3, 1), cloth_scene());
    on.s = (scene){.material.density = 0.2,
                   .time.step = 0.01,
                   .solution.tolerance = 1e-4,
                   .solution.max_iterations = 100,
                   .monitor = on.s.monitor};
    on.s.surroundings.gravity[2] = -9.81;
    stage_begin(&on);
    stage_run(&on, 3);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        assert_int_equal(visited(&on, names[k]), strcmp(names[k], "gravity") == 0 ? 3 * 25 : 0);
    assert_int_equal(simulation_counts(on.sim).matrix_blocks, 25);
    assert_int_equal(on.sim->cloth.hinges.count, 0);
    assert_null(on.sim->collisions.now);
    assert_null(on.sim->cloth.triangles.block);
    stage_end(&on);
}

/* Wind that begins and ends: until it begins the bits are those of calm air, and the times of
 * frames do not change. */
static void test_wind_begins_and_ends(void **state) {
    (void)state;
    stage calm = held_sheet(), windy = held_sheet();
    const size_t bytes = sizeof(double[3]) * (size_t)calm.m.vertex_count;
    windy.s.surroundings.wind[1] = 5;
    windy.s.surroundings.wind_from = 0.2;
    windy.s.surroundings.wind_until = 0.3;
    stage_begin(&calm);
    stage_begin(&windy);
    stage_run(&calm, 10);
    stage_run(&windy, 10);
    assert_memory_equal(calm.sim->state.x, windy.sim->state.x, bytes);
    stage_run(&calm, 1);
    stage_run(&windy, 1);
    assert_true(stage_distance(&calm, &windy, NULL) > 1e-5);
    stage_run(&windy, 14);
    const long triangles = windy.sim->cloth.triangles.count;
    assert_int_equal(visited(&windy, "wind"), 5 * triangles);
    assert_int_equal(visited(&windy, "drag"), 25 * triangles);
    assert_int_equal(windy.sim->account.plans_changed, 2);
    assert_near(simulation_time(windy.sim), 0.5, 1e-15);
    stage_end(&calm);
    stage_end(&windy);
}

/* A banner hangs edge-on to the wind. Drag across the cloth has no area to push, but drag along it
 * moves the lower end outwards. The wind's work must be in the energy account. */
static void test_wind_along_the_cloth(void **state) {
    (void)state;
    double out[2];
    for (int along = 0; along < 2; along++) {
        stage on = held_sheet();
        for (int i = 0; i < on.m.vertex_count; i++) { /* upright, with the held edge at the top */
            on.m.position[i][2] = -on.m.position[i][0];
            on.m.position[i][0] = 0;
        }
        on.s.surroundings.wind[1] = 8;
        on.s.surroundings.gravity[2] = 0; /* so that all energy gained is the wind's work */
        on.s.surroundings.tangential_drag = along ? 0.1 : 0;
        stage_begin(&on);
        stage_run(&on, 100);
        out[along] = -INFINITY;
        for (int i = 0; i < on.m.vertex_count; i++)
            out[along] = fmax(out[along], on.sim->state.x[i][1] - on.m.position[i][1]);
        assert_int_equal(simulation_counts(on.sim).rejected, 0);
        assert_int_equal(visited(&on, "tangential drag"), along ? 100 * on.m.triangle_count : 0);
        stage_end(&on);
    }
    print_message("wind along a banner: moved by %.2g m, with drag along it %.2g m\n", out[0],
                  out[1]);
    assert_true(out[0] < 1e-3 && out[1] > 0.005);
}

static void test_pin_is_released(void **state) {
    (void)state;
    stage kept = held_sheet(), released = held_sheet();
    pin let_go = hold;
    let_go.until = 0.3;
    released.s.pins = &let_go;
    stage_begin(&kept);
    stage_begin(&released);
    stage_run(&kept, 15);
    stage_run(&released, 15);
    const size_t bytes = sizeof(double[3]) * (size_t)kept.m.vertex_count;
    assert_memory_equal(kept.sim->state.x, released.sim->state.x, bytes);
    stage_run(&kept, 20);
    stage_run(&released, 20);
    for (int i = 0; i < kept.m.vertex_count; i++) {
        if (kept.m.material[i][0] > 0.01)
            continue;
        assert_true(simulation_positions(kept.sim)[i][2] == 0);
        assert_true(simulation_positions(released.sim)[i][2] < -0.3);
    }
    assert_int_equal(visited(&released, "pins"), 15 * 7);
    assert_int_equal(released.sim->account.effects[EFFECT_PINS].on, 0);
    stage_end(&kept);
    stage_end(&released);
}

/* A pin that moves from 0.05 s to 0.15 s, with steps that do not end at these times. */
static void test_pin_moves_for_a_while(void **state) {
    (void)state;
    stage on = held_sheet();
    pin moving = hold;
    moving.velocity[1] = 0.4;
    moving.move_from = 0.05;
    moving.move_until = 0.15;
    on.s.pins = &moving;
    on.s.time.step = 0.03;
    stage_begin(&on);
    for (int n = 1; n <= 10; n++) {
        stage_run(&on, 1);
        const double expected = 0.4 * fmin(0.1, fmax(0, n * 0.03 - 0.05));
        for (int i = 0; i < on.m.vertex_count; i++)
            if (on.m.material[i][0] < 0.01)
                assert_near(on.sim->state.x[i][1] - on.m.position[i][1], expected, 1e-14);
    }
    stage_end(&on);
}

/* A table is removed from under the cloth. */
static void test_collider_is_removed(void **state) {
    (void)state;
    collider table = {.kind = COLLIDER_PLANE,
                      .position = {0, 0, -0.01},
                      .axis = {0, 0, 1},
                      .friction = 0.5,
                      .gap = 0.005,
                      .until = 0.4};
    stage on = stage_of(cloth_sheet(5, 5, 0.1, 0.3, 1), cloth_scene());
    on.s.time.step = 0.02;
    on.s.colliders = &table;
    on.s.collider_count = 1;
    stage_begin(&on);
    stage_run(&on, 20);
    const long until_then = visited(&on, "contact");
    assert_near(on.sim->state.x[0][2], -0.005, 1e-6);
    stage_run(&on, 10);
    assert_true(on.sim->state.x[0][2] < -0.1);
    assert_int_equal(visited(&on, "contact"), until_then);
    stage_end(&on);
}

static double strain_of(const stage *on) {
    return triangle_greatest_strain(&on->sim->cloth.triangles, simulation_positions(on->sim));
}

/* A cloth hanging from one edge, whose weight strains it by more than a quarter at that edge,
 * without and with a strain limit of 5 %. Beyond the limit the cloth is STRAIN_LIMIT_FACTOR times
 * as stiff. So at rest the limited cloth may exceed the limit by at most twice the strain that its
 * weight causes at that stiffness. During the motion its strain stays below 7 %. */
static void test_strain_is_limited(void **state) {
    (void)state;
    double greatest[2] = {0, 0};
    for (int limited = 0; limited < 2; limited++) {
        stage on = stage_of(cloth_sheet(7, 7, 0.1, 0.3, 1), cloth_scene());
        on.s.pins = &hold;
        on.s.pin_count = 1;
        on.s.surroundings.gravity[0] = 9.81; /* along the cloth */
        on.s.surroundings.gravity[2] = 0;
        on.s.material.density = 1;
        on.s.material.stretch = 20;
        on.s.time.step = 0.02;
        on.s.solution.tolerance = 1e-6;
        on.s.surroundings.drag = 1;
        on.s.material.strain_limit = limited ? 0.05 : 0;
        stage_begin(&on);
        for (int n = 0; n < 150; n++) {
            stage_run(&on, 1);
            greatest[limited] = fmax(greatest[limited], strain_of(&on));
        }
        if (limited) {
            assert_below(strain_of(&on), 0.05 + 1.0 * 9.81 * 0.6 / 2000 * 2);
            assert_true(visited(&on, "strain limit") > 0);
        } else {
            assert_true(strain_of(&on) > 0.25);
        }
        assert_int_equal(simulation_counts(on.sim).rejected, 0);
        stage_end(&on);
    }
    print_message("greatest strain: %.3f, limited %.4f\n", greatest[0], greatest[1]);
    assert_below(greatest[1], 0.07);
}

/* The limit's force is the gradient of its energy, and its part beyond the limit is exact in A. */
static void test_strain_limit_is_a_gradient(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.3, 1), cloth_scene());
    const int n = 3 * on.m.vertex_count;
    const double d = 1e-7, none[3] = {0, 0, 0};
    on.s.material.strain_limit = 0.1;
    stage_begin(&on);
    simulation *sim = on.sim;
    double *still = calloc((size_t)on.m.vertex_count, sizeof *still);
    double(*rest)[3] = calloc((size_t)on.m.vertex_count, sizeof *rest);
    unsigned seed = 2;
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            sim->state.x[i][a] =
                (a < 2 ? 1.2 : 1) * sim->state.x[i][a] + 0.01 * random_number(&seed);
    const double(*x)[3] = (const double(*)[3])sim->state.x;
    strain_limit_find(&sim->cloth.strain_limit, &sim->cloth.triangles, x);
    assert_true(sim->cloth.strain_limit.count > 10);
    system_reset(&sim->system, still, none, 1);
    strain_limit_forces(&sim->cloth.strain_limit, &sim->cloth.triangles, 1, x,
                        (const double(*)[3])rest, &sim->system);
    for (int k = 0; k < n; k++) {
        double *at = &sim->state.x[0][0] + k, was = *at;
        *at = was + d;
        const double up = strain_limit_energy(&sim->cloth.strain_limit, &sim->cloth.triangles, x);
        *at = was - d;
        const double down = strain_limit_energy(&sim->cloth.strain_limit, &sim->cloth.triangles, x);
        *at = was;
        assert_near((&sim->system.b[0][0])[k], -(up - down) / (2 * d), 1e-4);
    }
    free(still);
    free(rest);
    stage_end(&on);
}

/* Computes b and A of a sheet that is displaced and moving, with only the triangles' forces of this
 * material. */
static void triangles_alone(stage *on, const triangle_material *material) {
    const double none[3] = {0, 0, 0};
    simulation *sim = on->sim;
    double *still = calloc((size_t)on->m.vertex_count, sizeof *still);
    system_reset(&sim->system, still, none, 0.02);
    triangle_forces(&sim->cloth.triangles, material, 0.02, (const double(*)[3])sim->state.x,
                    (const double(*)[3])sim->state.v, &sim->system);
    free(still);
}

/* a += b */
static void add_system(linear_system *to, const linear_system *from) {
    for (int k = 0; k < from->A.block_count * 9; k++)
        (&to->A.value[0][0][0])[k] += (&from->A.value[0][0][0])[k];
    for (int k = 0; k < from->A.row_count * 3; k++)
        (&to->b[0][0])[k] += (&from->b[0][0])[k];
}

/* The loops for stretch, for shear and for both: each must give the sum of its effects, damping
 * included. */
static void test_triangle_effects_add_up(void **state) {
    (void)state;
    static const triangle_material both = {400, 80, 0.5, 0.1}, without_damping = {400, 80, 0, 0},
                                   parts[] = {{400, 0, 0, 0}, {0, 80, 0, 0},    {0, 0, 0.5, 0},
                                              {0, 0, 0, 0.1}, {400, 0, 0.5, 0}, {0, 80, 0, 0.1}};
    stage sum = stage_of(cloth_sheet(4, 5, 0.1, 0.3, 1), cloth_scene());
    stage part = stage_of(cloth_sheet(4, 5, 0.1, 0.3, 1), cloth_scene());
    unsigned seed = 3;
    stage_begin(&sum);
    stage_begin(&part);
    for (int i = 0; i < sum.m.vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            sum.sim->state.x[i][a] = part.sim->state.x[i][a] += 0.02 * random_number(&seed);
            sum.sim->state.v[i][a] = part.sim->state.v[i][a] = random_number(&seed);
        }
    for (int way = 0; way < 3; way++) { /* the sum of parts from..until must be the whole */
        static const int from[] = {0, 4, 0}, until[] = {4, 6, 2};
        triangles_alone(&sum, &parts[from[way]]);
        for (int k = from[way] + 1; k < until[way]; k++) {
            triangles_alone(&part, &parts[k]);
            add_system(&sum.sim->system, &part.sim->system);
        }
        triangles_alone(&part, way < 2 ? &both : &without_damping);
        for (int k = 0; k < part.sim->system.A.block_count * 9; k++)
            assert_near((&sum.sim->system.A.value[0][0][0])[k],
                        (&part.sim->system.A.value[0][0][0])[k], 1e-14);
        for (int k = 0; k < part.m.vertex_count * 3; k++)
            assert_near((&sum.sim->system.b[0][0])[k], (&part.sim->system.b[0][0])[k], 1e-14);
    }
    stage_end(&sum);
    stage_end(&part);
}

static void add_wide_limit(scene *s) {
    s->material.strain_limit = 5;
}

static void test_wide_limit(void **state) {
    (void)state;
    assert_changes_no_bit(add_wide_limit, "strain limit");
}

static void test_events_are_listed(void **state) {
    (void)state;
    double time[7];
    keyframe keys[] = {{.time = 4}, {.time = 5}};
    collider ball = {.kind = COLLIDER_SPHERE, .from = 1, .until = 3};
    ball.keyframes = keys;
    ball.keyframe_count = 2;
    pin let_go = {.until = 2, .move_from = 0.5, .move_until = 1.5};
    scene s = cloth_scene();
    s.colliders = &ball;
    s.collider_count = 1;
    s.pins = &let_go;
    s.pin_count = 1;
    s.surroundings.wind_until = 2;
    const double expected[] = {0.5, 1, 1.5, 2, 3, 4, 5};
    assert_int_equal(plan_events(&s, time, 2), 7);
    assert_int_equal(plan_events(&s, time, 7), 7);
    assert_memory_equal(time, expected, sizeof expected);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_far_colliders),
        cmocka_unit_test(test_later_effects),
        cmocka_unit_test(test_pin_of_nothing),
        cmocka_unit_test(test_absent_effects_cost_nothing),
        cmocka_unit_test(test_wind_begins_and_ends),
        cmocka_unit_test(test_wind_along_the_cloth),
        cmocka_unit_test(test_pin_is_released),
        cmocka_unit_test(test_pin_moves_for_a_while),
        cmocka_unit_test(test_collider_is_removed),
        cmocka_unit_test(test_strain_is_limited),
        cmocka_unit_test(test_strain_limit_is_a_gradient),
        cmocka_unit_test(test_triangle_effects_add_up),
        cmocka_unit_test(test_wide_limit),
        cmocka_unit_test(test_events_are_listed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
