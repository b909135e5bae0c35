/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Hard cases of contact between cloth, cloth and bodies: piles, folds, and bodies that pass
 * between vertices. Numbers such as S36 refer to docs/fabric-hard-cases.md. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/vector.h"
#include "contact/impact.h"
#include "crossings.h"
#include "mesh/mesh_parts.h"
#include "mesh/surface.h"

static collider floor_at(double z) {
    return (collider){.kind = COLLIDER_PLANE,
                      .position = {0, 0, z},
                      .axis = {0, 0, 1},
                      .friction = 0.5,
                      .gap = 0.004};
}

/* Returns sheets above each other as one mesh. */
static mesh layers(int count, int columns, double spacing, double apart) {
    const mesh one = cloth_sheet(columns, columns, spacing, 0.2, 3);
    const int vertices = one.vertex_count, triangles = one.triangle_count;
    double(*material)[2] = calloc((size_t)(vertices * count), sizeof *material);
    int(*triangle)[3] = calloc((size_t)(triangles * count), sizeof *triangle);
    for (int n = 0; n < count; n++) {
        for (int i = 0; i < vertices; i++) {
            material[n * vertices + i][0] = one.material[i][0] + 10 * n;
            material[n * vertices + i][1] = one.material[i][1];
        }
        for (int t = 0; t < triangles; t++)
            for (int p = 0; p < 3; p++)
                triangle[n * triangles + t][p] = one.triangle[t][p] + n * vertices;
    }
    mesh all = cloth_of(vertices * count, (const double(*)[2])material, triangles * count,
                        (const int(*)[3])triangle);
    for (int n = 0; n < count; n++)
        for (int i = 0; i < vertices; i++) {
            /* Each sheet is shifted slightly, so that no vertex lies exactly above another. */
            all.position[n * vertices + i][0] = one.position[i][0] + 0.013 * n;
            all.position[n * vertices + i][2] = apart * (n + 1);
        }
    mesh gone = one;
    cloth_free(&gone);
    free(material);
    free(triangle);
    return all;
}

/* Sheets fall onto a floor and come to rest there. None may enter the floor or pass through
 * another. */
static void pile(int count, int steps, double deepest_allowed) {
    collider ground = floor_at(0);
    stage on = stage_of(layers(count, 5, 0.05, 0.012), cloth_scene());
    double deepest = 0, speed = 0;
    int crossed = 0;
    const clock_t begin = clock();
    on.s.time.step = 0.02;
    on.s.solution.tolerance = 1e-4;
    on.s.material.bend = 1e-4;
    on.s.surroundings.drag = 0.2;
    on.s.self_collision.gap = 0.006;
    on.s.self_collision.friction = 0.3;
    on.s.colliders = &ground;
    on.s.collider_count = 1;
    stage_begin(&on);
    for (int n = 0; n < steps; n++) {
        stage_run(&on, 1);
        const int now = crossings(&on);
        crossed = now > crossed ? now : crossed;
        for (int i = 0; i < on.m.vertex_count; i++)
            deepest = fmax(deepest, -on.sim->state.x[i][2]);
    }
    for (int i = 0; i < on.m.vertex_count; i++)
        speed = fmax(speed, vector_length(on.sim->state.v[i]));
    print_message("S36 %d layers, %d steps: depth %.3g m, %d crossings, fastest %.3g m/s, %ld "
                  "rejected, %.1f s\n",
                  count, steps, deepest, crossed, speed, simulation_counts(on.sim).rejected,
                  (double)(clock() - begin) / CLOCKS_PER_SEC);
    assert_below(deepest, deepest_allowed);
    assert_int_equal(crossed, 0);
    assert_in_range(simulation_counts(on.sim).rejected, 0, count * steps / 12);
    stage_end(&on);
}

static void S36_two_layers_on_a_floor(void **state) {
    (void)state;
    pile(2, 50, 1e-9);
}

static void S36_ten_layers_on_a_floor(void **state) {
    (void)state;
    pile(10, 25, 1e-9);
}

/* A plate comes down on a sheet that lies on a floor, until there is less room than the gaps need.
 * This must be reported, in the account or as the reason for which the run ends. The sheet must not
 * tear, and a step must not take a thousand parts. */
static void S43_squeezed(void **state) {
    (void)state;
    const char *const names[] = {"stops at half of the gaps", "goes on through the floor"};
    for (int through = 0; through < 2; through++) {
        keyframe path[2] = {{0.1, {0, 0, 0}, 0}, {0.5, {0, 0, through ? -0.12 : -0.096}, 0}};
        collider bodies[2] = {floor_at(-0.004),
                              {.kind = COLLIDER_BOX,
                               .position = {0.15, 0.15, 0.116},
                               .size = {0.1, 0.1, 0.02},
                               .friction = 0.3,
                               .gap = 0.004,
                               .turn_axis = {0, 0, 1},
                               .keyframe_count = 2,
                               .keyframes = path}};
        stage on = stage_of(cloth_sheet(9, 9, 0.0375, 0.2, 3), cloth_scene());
        on.s.solution.tolerance = 1e-4;
        on.s.material.bend = 1e-4;
        on.s.surroundings.drag = 0.2;
        on.s.self_collision.gap = 0.004;
        on.s.colliders = bodies;
        on.s.collider_count = 2;
        char error[256] = "";
        int ended = 0;
        stage_begin(&on);
        for (int n = 0; n < 80 && !ended; n++)
            ended = simulation_step(on.sim, error) != 0;
        stage_assert_finite(&on);
        const run_faults f = simulation_faults(on.sim);
        print_message("S43 plate that %s: strain %.2g, depth %.2g m, %ld and %ld let pass, %ld "
                      "steps, %ld taken again%s%s\n",
                      names[through], f.greatest_strain, f.deepest, f.penetration, f.passing,
                      simulation_counts(on.sim).taken, simulation_counts(on.sim).rejected,
                      ended ? "; ended: " : "", error);
        assert_below(f.greatest_strain, 0.5);
        assert_true(simulation_counts(on.sim).taken < 4000);
        assert_true(ended == (error[0] != '\0'));
        if (through)
            assert_true(ended || f.penetration + f.passing > 0);
        else
            assert_true(!ended && f.deepest < 1e-6);
        stage_end(&on);
    }
}

/* Twenty-four sheets collide from both sides. Rounds of impulses cannot resolve all contacts, so
 * the rest moves on as one rigid zone. Nothing passes, and momentum is conserved. */
static void S44_sheets_crash(void **state) {
    (void)state;
    enum { count = 24 };
    stage on = stage_of(layers(count, 4, 0.05, 0.012), cloth_scene());
    double work = 0, momentum[3] = {0, 0, 0}, after[3] = {0, 0, 0};
    self_collision s;
    stage_begin(&on);
    const int each = on.m.vertex_count / count;
    const double(*x)[3] = (const double(*)[3])on.m.position;
    double(*v)[3] = cloth_moved(&on.m, 5, 3);
    for (int i = 0; i < on.m.vertex_count; i++) {
        for (int a = 0; a < 3; a++)
            v[i][a] -= x[i][a];
        v[i][2] += i / each < count / 2 ? 100 : -100;
        vector_add_scaled(momentum, on.sim->cloth.mass[i], v[i], momentum);
    }
    assert_int_equal(self_collision_init(&s, &on.m, 0.006, 0.3, 0.02), 0);
    impact_step step = {.h = 0.02,
                        .x = x,
                        .v = v,
                        .of = {on.sim->cloth.mass, &on.sim->collisions},
                        .itself = &s,
                        .bodies = &on.sim->collisions};
    assert_int_equal(impact_resolve(&step, &work), 0);
    for (int i = 0; i < on.m.vertex_count; i++)
        vector_add_scaled(after, on.sim->cloth.mass[i], v[i], after);
    print_message("S44 %d sheets: %d pairs pass, work %.3g J\n", (int)count, s.left, work);
    assert_int_equal(s.left, 0);
    assert_true(work <= 0);
    for (int a = 0; a < 3; a++)
        assert_near(after[a], momentum[a], 1e-9);
    self_collision_free(&s);
    free(v);
    stage_end(&on);
}

/* A ribbon falls upright onto a plane and folds onto itself. */
static void S37_ribbon_folds_onto_itself(void **state) {
    (void)state;
    collider ground = floor_at(-0.02);
    stage on = stage_of(cloth_sheet(4, 40, 0.02, 0.2, 5), cloth_scene());
    int crossed = 0;
    for (int i = 0; i < on.m.vertex_count; i++) {
        on.m.position[i][2] = on.m.position[i][1];
        on.m.position[i][1] = 0.004 * sin(9 * on.m.position[i][2]);
    }
    on.s.time.step = 0.02;
    on.s.solution.tolerance = 1e-4;
    on.s.surroundings.drag = 0.1;
    on.s.material.bend = 1e-6;
    on.s.self_collision.gap = 0.004;
    on.s.self_collision.friction = 0.3;
    on.s.colliders = &ground;
    on.s.collider_count = 1;
    stage_begin(&on);
    double deepest = 0;
    for (int n = 0; n < 70; n++) {
        stage_run(&on, 1);
        const int now = crossings(&on);
        crossed = now > crossed ? now : crossed;
        for (int i = 0; i < on.m.vertex_count; i++)
            deepest = fmax(deepest, -0.02 - on.sim->state.x[i][2]);
    }
    print_message("S37 ribbon: %d crossings at most, depth %.3g m, %ld rejected\n", crossed,
                  deepest, simulation_counts(on.sim).rejected);
    assert_int_equal(crossed, 0);
    assert_below(deepest, 1e-9);
    stage_end(&on);
}

/* A coarse cloth, held all around or at two sides, meets a body that fits between its vertices.
 * Returns how far the body's top ends below the cloth's edge, m: a positive value means that the
 * body has passed through. */
static double body_through(collider *body, int steps, double speed, double h) {
    static pin hold[4] = {{.low = {-0.01, -1}, .high = {0.01, 1}},
                          {.low = {0.59, -1}, .high = {0.61, 1}},
                          {.low = {-1, -0.01}, .high = {1, 0.01}},
                          {.low = {-1, 0.59}, .high = {1, 0.61}}};
    stage on = stage_of(cloth_sheet(7, 7, 0.1, 0, 1), cloth_scene());
    double lowest = INFINITY;
    on.s.time.step = h;
    on.s.solution.tolerance = 1e-4;
    on.s.material.stretch = 30;
    on.s.surroundings.gravity[2] = 0;
    on.s.pins = hold;
    on.s.pin_count = 4;
    body->velocity[2] = -speed;
    on.s.colliders = body;
    on.s.collider_count = 1;
    on.s.monitor.energy = 1e300; /* the pins hold the cloth, whatever energy this takes */
    stage_begin(&on);
    stage_run(&on, steps);
    stage_assert_finite(&on);
    for (int i = 0; i < on.m.vertex_count; i++)
        lowest = fmin(lowest, on.sim->state.x[i][2]);
    const double top = body->position[2] - speed * simulation_time(on.sim);
    print_message("  body at %.3f m, cloth down to %.3f m, %ld rejected\n", top, lowest,
                  simulation_counts(on.sim).rejected);
    stage_end(&on);
    return lowest - top;
}

static void S38_thin_rod_between_vertices(void **state) {
    (void)state;
    collider rod = {.kind = COLLIDER_CYLINDER,
                    .position = {0.35, 0.3, 0.15},
                    .axis = {0, 1, 0},
                    .size = {0.004, 0.12},
                    .friction = 0.3,
                    .gap = 0.002};
    assert_below(body_through(&rod, 19, 1, 0.01), 0.02);
}

static void S38_small_fast_ball(void **state) {
    (void)state;
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0.27, 0.34, 0.15},
                     .size = {0.01},
                     .friction = 0.3,
                     .gap = 0.002};
    assert_below(body_through(&ball, 6, 10, 0.005), 0.02);
}

/* Returns a cone with its tip downwards. */
static surface *cone(double radius, double height) {
    enum { around = 16 };
    char error[256] = "";
    mesh m;
    assert_int_equal(mesh_allocate(&m, around + 2, 2 * around), 0);
    for (int k = 0; k < around; k++) {
        m.position[k][0] = radius * cos(2 * acos(-1) * k / (int)around);
        m.position[k][1] = radius * sin(2 * acos(-1) * k / (int)around);
        m.position[k][2] = height;
    }
    memset(m.position[around], 0, sizeof m.position[around]);
    m.position[around + 1][0] = m.position[around + 1][1] = 0;
    m.position[around + 1][2] = height;
    for (int k = 0; k < around; k++) {
        const int next = (k + 1) % around;
        const int side[3] = {around, next, k}, top[3] = {around + 1, k, next};
        memcpy(m.triangle[2 * k], side, sizeof side);
        memcpy(m.triangle[2 * k + 1], top, sizeof top);
    }
    surface *s = surface_new(&m, error);
    if (!s)
        fail_msg("%s", error);
    return s;
}

static void S38_tip_of_a_cone(void **state) {
    (void)state;
    collider body = {.kind = COLLIDER_MESH,
                     .position = {0.27, 0.34, 0.1},
                     .surface = cone(0.03, 0.1),
                     .friction = 0.3,
                     .gap = 0.004};
    assert_below(body_through(&body, 18, 1, 0.01), 0.03);
    surface_free(body.surface);
}

/* Runs until a pile has settled; only in the slow tests (test_fabric_hard_piles long). */
static void S36_ten_layers_for_long(void **state) {
    (void)state;
    const clock_t begin = clock();
    pile(10, 150, 1e-9);
    assert_below((double)(clock() - begin) / CLOCKS_PER_SEC, 60);
}

int main(int argc, char **argv) {
    const struct CMUnitTest long_tests[] = {cmocka_unit_test(S36_ten_layers_for_long)};
    if (argc > 1 && strcmp(argv[1], "long") == 0)
        return cmocka_run_group_tests(long_tests, NULL, NULL);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S36_two_layers_on_a_floor),
        cmocka_unit_test(S36_ten_layers_on_a_floor),
        cmocka_unit_test(S43_squeezed),
        cmocka_unit_test(S44_sheets_crash),
        cmocka_unit_test(S37_ribbon_folds_onto_itself),
        cmocka_unit_test(S38_thin_rod_between_vertices),
        cmocka_unit_test(S38_small_fast_ball),
        cmocka_unit_test(S38_tip_of_a_cone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
