/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Effects that a scene does not use take neither memory nor time. The same holds for distant
 * colliders, sleeping cloth, and a monitor that is off. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "output/memory.h"
#include "step/rest.h"

static pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}};
static collider ball = {
    .kind = COLLIDER_SPHERE, .position = {0.3, 0.3, -3}, .size = {0.2}, .gap = 0.01};

enum { ALONG = 30 };

/* Returns 900 vertices with all effects, of which tests remove some. */
static stage full_sheet(void) {
    stage on = stage_of(cloth_sheet(ALONG, ALONG, 0.03, 0.3, 1), cloth_scene());
    on.s.time.step = 0.01;
    on.s.pins = &hold;
    on.s.pin_count = 1;
    on.s.colliders = &ball;
    on.s.collider_count = 1;
    on.s.material.strain_limit = 0.5;
    on.s.surroundings.drag = 0.2;
    on.s.self_collision.gap = 0.004;
    on.s.material.bend = 1e-4;
    on.s.material.bend_damping = 1e-6;
    return on;
}

/* Returns the number of blocks between domains with even and with odd numbers, which Gauss-Seidel
 * lists. */
static double blocks_across(const block_matrix *A) {
    enum { DOMAINS = 6, EACH = ALONG * ALONG / DOMAINS };
    double across = 0;
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            across += (i / EACH + A->column[k] / EACH) % 2;
    return across;
}

/* Returns the memory that the simulation needs before its first step, from the sizes of its arrays.
 * The comments name the arrays in the order of the numbers. */
static double needed_bytes(const stage *on) {
    const simulation *sim = on->sim;
    const double vertices = on->m.vertex_count, triangles = on->m.triangle_count;
    const double hinges = on->m.hinge_count, blocks = (double)simulation_counts(sim).matrix_blocks;
    const scene *s = &on->s;
    const int has_bend = s->material.bend > 0,
              has_triangles = s->material.stretch > 0 || s->material.shear > 0;
    double bytes = sizeof *sim;
    bytes += vertices * (8 + 6 * 24); /* mass; x, v, guess, dv, x_next, v_next */
    bytes += triangles * (12 + 56);   /* vertices, rest shape */
    bytes += vertices * (4 + 24 + 1) + blocks * (4 + 72); /* rows, b, given; columns, values */
    bytes += vertices * 2 * 24;                           /* the solver's residual, product */
    bytes += blocks * (4 + 4 + 72);                       /* Gauss-Seidel: place, column, value */
    bytes += vertices * (4 + 3 * 4 + 4 + 72 + 5 * 24);    /* domain, rows, columns, root, vectors */
    bytes += 8 * blocks_across(&sim->system.A);
    if (has_triangles)
        bytes += triangles * 24;
    if (has_bend) /* corner, vertex, role, block, weight, angle */
        bytes += hinges * (16 + 16 + 16 + 40 + 8 + 8);
    if (has_bend && !s->monitor.off)
        bytes += hinges * 8 + vertices * 24;
    if (s->material.strain_limit > 0)
        bytes += triangles * (4 + 1);
    if (s->pin_count > 0)
        bytes += vertices * 4 + sim->collisions.pinned.count * 4;
    if (s->collider_count > 0)
        bytes += vertices * 2 * 200;
    if (s->self_collision.gap > 0)
        bytes += triangles * (48 + 4) + vertices * (24 + 4); /* box, owned; v, turn */
    return bytes;
}

static void assert_takes_what_it_needs(void (*change)(scene *), const char *what) {
    stage on = full_sheet();
    change(&on.s);
    const double before = memory_allocated();
    stage_begin(&on);
    const double taken = memory_allocated() - before, needed = needed_bytes(&on);
    print_message("%-14s %7.0f bytes, needed %7.0f\n", what, taken, needed);
    if (before > 0) /* otherwise a sanitizer is active and allocations are not counted */
        assert_true(fabs(taken - needed) < 0.01 * needed);
    stage_end(&on);
}

static void no_change(scene *s) {
    (void)s;
}
static void no_bend(scene *s) {
    s->material.bend = s->material.bend_damping = 0;
}
static void no_shear(scene *s) {
    s->material.shear = s->material.shear_damping = 0;
}
static void no_pins(scene *s) {
    s->pin_count = 0;
}
static void no_colliders(scene *s) {
    s->collider_count = 0;
}
static void no_self_collision(scene *s) {
    s->self_collision.gap = 0;
}
static void no_limit(scene *s) {
    s->material.strain_limit = 0;
}
static void no_monitor(scene *s) {
    s->monitor.off = 1;
}
static void nothing(scene *s) {
    no_bend(s);
    no_pins(s);
    no_colliders(s);
    no_self_collision(s);
    no_limit(s);
    no_monitor(s);
    s->material.stretch = s->material.shear = s->material.stretch_damping =
        s->material.shear_damping = s->surroundings.drag = 0;
}

static void test_storage_goes_by_the_effects(void **state) {
    (void)state;
    assert_takes_what_it_needs(no_change, "everything");
    assert_takes_what_it_needs(no_bend, "no bend");
    assert_takes_what_it_needs(no_shear, "no shear");
    assert_takes_what_it_needs(no_pins, "no pins");
    assert_takes_what_it_needs(no_colliders, "no colliders");
    assert_takes_what_it_needs(no_self_collision, "no self");
    assert_takes_what_it_needs(no_limit, "no limit");
    assert_takes_what_it_needs(no_monitor, "no monitor");
    assert_takes_what_it_needs(nothing, "nothing");
}

/* Memory is allocated only for vertices that are constrained. */
static void test_constraints_of_the_constrained(void **state) {
    (void)state;
    stage on = full_sheet();
    stage_begin(&on);
    stage_run(&on, 2);
    assert_int_equal(on.sim->constraints.used, ALONG);
    stage_end(&on);
    on = full_sheet();
    no_pins(&on.s);
    stage_begin(&on);
    stage_run(&on, 2);
    assert_null(on.sim->constraints.place);
    stage_end(&on);
}

/* A thousand distant balls are examined once. The nearest one moves and is met in time, with the
 * same bits as if it were alone. */
static void test_a_thousand_colliders(void **state) {
    (void)state;
    enum { MANY = 1000, STEPS = 60 };
    collider *all = calloc(MANY, sizeof *all);
    assert_non_null(all);
    for (int n = 0; n < MANY; n++)
        all[n] = (collider){.kind = COLLIDER_SPHERE,
                            .position = {100 + n, 0.1 * n, -n},
                            .size = {0.3},
                            .gap = 0.005};
    all[500].position[0] = all[500].position[1] = 0.1;
    all[500].position[2] = -12;
    all[500].velocity[2] = 20;
    stage many = full_sheet(), one = full_sheet();
    no_self_collision(&many.s);
    no_self_collision(&one.s);
    many.s.colliders = all;
    many.s.collider_count = MANY;
    one.s.colliders = &all[500];
    one.s.collider_count = 1;
    stage_begin(&many);
    stage_begin(&one);
    stage_run(&many, 20);
    assert_int_equal(many.sim->collisions.visits, 0);
    assert_int_equal(many.sim->collisions.others.count, 0);
    const double looked = many.sim->collisions.others.time;
    stage_run(&one, 20);
    stage_run(&many, 1);
    stage_run(&one, 1);
    assert_true(many.sim->collisions.others.time ==
                looked); /* the distant colliders were not examined again */
    stage_run(&many, STEPS - 21);
    stage_run(&one, STEPS - 21);
    assert_true(many.sim->collisions.visits > 0);
    assert_true(many.sim->collisions.visits == one.sim->collisions.visits);
    const size_t bytes = sizeof(double[3]) * (size_t)one.m.vertex_count;
    assert_memory_equal(many.sim->state.x, one.sim->state.x, bytes);
    stage_end(&many);
    stage_end(&one);
    free(all);
}

/* Free fall onto a floor that was out of reach: the cloth comes near it. */
static void test_falls_into_reach(void **state) {
    (void)state;
    collider floor = {
        .kind = COLLIDER_BOX, .position = {0.3, 0.3, -8}, .size = {3, 3, 0.1}, .gap = 0.01};
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    on.s.colliders = &floor;
    on.s.collider_count = 1;
    on.s.time.step = 0.02;
    stage_begin(&on);
    stage_run(&on, 100);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_true(on.sim->state.x[i][2] > -7.9);
    assert_true(on.sim->state.x[0][2] < -7.8);
    stage_end(&on);
}

static stage lying_sheet(collider *table) {
    stage on = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
    on.s.time.step = 0.02;
    on.s.colliders = table;
    on.s.collider_count = 1;
    on.s.solution.sleep = 1e-3;
    return on;
}

/* Cloth on a table falls asleep, sleeps while nothing happens, and falls when the table is
 * removed. */
static void test_cloth_sleeps(void **state) {
    (void)state;
    collider table = {.kind = COLLIDER_PLANE,
                      .position = {0, 0, -0.1},
                      .axis = {0, 0, 1},
                      .friction = 0.5,
                      .gap = 0.005,
                      .until = 4};
    stage on = lying_sheet(&table);
    stage_begin(&on);
    stage_run(&on, 4);
    assert_int_equal(simulation_counts(on.sim).slept, 0); /* the cloth is falling */
    assert_true(on.sim->step.slow_steps == 0);
    stage_run(&on, 146);
    const long taken = simulation_counts(on.sim).taken, slept = simulation_counts(on.sim).slept;
    const long visited = on.sim->account.effects[EFFECT_STRETCH].visited;
    print_message("slept through %ld of 150 steps\n", slept);
    assert_true(slept > 20);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_true(vector_length(on.sim->state.v[i]) == 0);
    stage_run(&on, 50);
    assert_int_equal(simulation_counts(on.sim).slept, slept + 50);
    assert_int_equal(simulation_counts(on.sim).taken, taken);
    assert_int_equal(on.sim->account.effects[EFFECT_STRETCH].visited, visited);
    assert_near(simulation_time(on.sim), 4, 1e-12);
    stage_run(&on, 10);
    assert_int_equal(simulation_counts(on.sim).slept, slept + 50);
    assert_true(on.sim->state.x[0][2] < -0.2);
    stage_end(&on);
}

/* The cloth falls from the exact time at which the table is removed, within a step. */
static void test_cloth_wakes_within_a_step(void **state) {
    (void)state;
    const double gone = 4.005;
    collider table = {.kind = COLLIDER_PLANE,
                      .position = {0, 0, -0.1},
                      .axis = {0, 0, 1},
                      .friction = 0.5,
                      .gap = 0.005,
                      .until = gone};
    stage on = lying_sheet(&table);
    stage_begin(&on);
    stage_run(&on, 200);
    assert_true(simulation_counts(on.sim).slept > 50);
    assert_true(vector_length(on.sim->state.v[0]) == 0);
    stage_run(&on, 10);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_near(on.sim->state.v[i][2], -9.81 * (simulation_time(on.sim) - gone), 1e-3);
    stage_end(&on);
}

/* A ball that approaches, a pin that will move, or wind prevents sleep. */
static void test_what_is_driven_is_awake(void **state) {
    (void)state;
    for (int what = 0; what < 4; what++) {
        collider two[2] = {{.kind = COLLIDER_PLANE,
                            .position = {0, 0, -0.005},
                            .axis = {0, 0, 1},
                            .friction = 0.5,
                            .gap = 0.005},
                           {.kind = COLLIDER_SPHERE,
                            .position = {0, 0, 50},
                            .velocity = {0, 0, what == 0 ? -1 : 0},
                            .size = {1},
                            .gap = 0.005}};
        pin corner = {.low = {-0.01, -0.01},
                      .high = {0.01, 0.01},
                      .velocity = {0, 0, what == 1 ? 1 : 0},
                      .move_from = 100};
        stage on = lying_sheet(two);
        on.s.collider_count = 2;
        on.s.pins = &corner;
        on.s.pin_count = 1;
        on.s.surroundings.drag = 1e-9;
        on.s.surroundings.wind[0] = what == 2 ? 1e-6 : 0;
        stage_begin(&on);
        stage_run(&on, 60);
        assert_int_equal(simulation_counts(on.sim).slept > 0, what == 3);
        stage_end(&on);
    }
}

/* Cloth that was saved asleep is asleep when restored. */
static void test_sleep_is_saved(void **state) {
    (void)state;
    collider table = {.kind = COLLIDER_PLANE,
                      .position = {0, 0, -0.005},
                      .axis = {0, 0, 1},
                      .friction = 0.5,
                      .gap = 0.005};
    stage on = lying_sheet(&table), other = lying_sheet(&table);
    stage_begin(&on);
    stage_begin(&other);
    stage_run(&on, 60);
    assert_true(simulation_counts(on.sim).slept > 0);
    const size_t size = simulation_saved_size(on.sim);
    unsigned char *bytes = malloc(size);
    assert_non_null(bytes);
    simulation_save(on.sim, bytes, size);
    assert_int_equal(simulation_restore(other.sim, bytes, size), 0);
    stage_run(&other, 1);
    assert_int_equal(simulation_counts(other.sim).slept, simulation_counts(on.sim).slept + 1);
    assert_memory_equal(on.sim->state.x, other.sim->state.x,
                        sizeof(double[3]) * (size_t)on.m.vertex_count);
    free(bytes);
    stage_end(&on);
    stage_end(&other);
}

/* Without the monitor the bits are the same, as long as it finds no fault; and it uses no
 * memory. */
static void test_monitor_can_be_off(void **state) {
    (void)state;
    stage on = full_sheet(), off = full_sheet();
    no_monitor(&off.s);
    stage_begin(&on);
    stage_begin(&off);
    stage_run(&on, 20);
    stage_run(&off, 20);
    assert_memory_equal(on.sim->state.x, off.sim->state.x,
                        sizeof(double[3]) * (size_t)on.m.vertex_count);
    assert_true(on.sim->account.effects[EFFECT_MONITOR].visited > 0);
    assert_int_equal(off.sim->account.effects[EFFECT_MONITOR].visited, 0);
    assert_true(on.sim->monitor.energy > 0 && off.sim->monitor.energy == 0);
    assert_true(simulation_faults(on.sim).watched && !simulation_faults(off.sim).watched);
    stage_end(&on);
    stage_end(&off);
}

/* Checks that continue without the monitor: for infinities, for solutions, and for passing. */
static void test_monitor_that_is_off(void **state) {
    (void)state;
    stage on = full_sheet();
    no_monitor(&on.s);
    stage_begin(&on);
    monitored_step step = simulation_monitored(on.sim);
    step.finite = 1;
    step.status = SOLVER_CONVERGED;
    step.passing = 0;
    step.shortest = 0;
    for (int i = 0; i < on.m.vertex_count; i++)
        on.sim->step.v_next[i][0] = 1e6; /* energy from nowhere */
    assert_int_equal(monitor_check(&on.sim->monitor, &step), STEP_GOOD);
    step.passing = 1;
    assert_int_equal(monitor_check(&on.sim->monitor, &step), STEP_PASSING);
    step.status = SOLVER_BREAKDOWN;
    assert_int_equal(monitor_check(&on.sim->monitor, &step), STEP_NOT_SOLVED);
    step.finite = 0;
    assert_int_equal(monitor_check(&on.sim->monitor, &step), STEP_NOT_FINITE);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_storage_goes_by_the_effects),
        cmocka_unit_test(test_constraints_of_the_constrained),
        cmocka_unit_test(test_a_thousand_colliders),
        cmocka_unit_test(test_falls_into_reach),
        cmocka_unit_test(test_cloth_sleeps),
        cmocka_unit_test(test_cloth_wakes_within_a_step),
        cmocka_unit_test(test_what_is_driven_is_awake),
        cmocka_unit_test(test_sleep_is_saved),
        cmocka_unit_test(test_monitor_can_be_off),
        cmocka_unit_test(test_monitor_that_is_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
