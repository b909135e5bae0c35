/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Contact of cloth with itself: pairs of features are compared with simple computations, and whole
 * cloths are run. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "contact/self_collision.h"
#include "crossings.h"

static void random_points(double size, unsigned *seed, double x[4][3]) {
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++)
            x[k][a] = size * random_number(seed);
}

/* A vertex moves past a triangle at rest. It passes exactly if its path crosses the triangle. */
static void test_vertex_through_triangle(void **state) {
    (void)state;
    unsigned seed = 1;
    int passed = 0;
    for (int n = 0; n < 20000; n++) {
        double x[4][3], y[4][3];
        self_contact found;
        random_points(1, &seed, x);
        memcpy(y, x, sizeof y);
        for (int a = 0; a < 3; a++)
            y[0][a] = random_number(&seed);
        const int expected = segment_crosses(x[0], y[0], x[1], x[2], x[3]);
        assert_int_equal(self_pair_passes(0, (const double(*)[3])x, (const double(*)[3])y, &found),
                         expected);
        passed += expected;
    }
    assert_in_range(passed, 500, 10000);
}

/* An edge sweeps a parallelogram, and another edge is in its way. The result is compared with the
 * crossings of the second edge and the parallelogram's two triangles. */
static void test_edge_through_edge(void **state) {
    (void)state;
    unsigned seed = 2;
    int passed = 0;
    for (int n = 0; n < 20000; n++) {
        double x[4][3], y[4][3], shift[3];
        self_contact found;
        random_points(1, &seed, x);
        memcpy(y, x, sizeof y);
        for (int a = 0; a < 3; a++)
            shift[a] = random_number(&seed);
        for (int k = 0; k < 2; k++)
            vector_add_scaled(x[k], 1, shift, y[k]);
        const int expected = segment_crosses(x[2], x[3], x[0], x[1], y[1]) ||
                             segment_crosses(x[2], x[3], x[0], y[1], y[0]);
        assert_int_equal(self_pair_passes(1, (const double(*)[3])x, (const double(*)[3])y, &found),
                         expected);
        passed += expected;
    }
    assert_in_range(passed, 500, 10000);
}

/* Features that stay apart along some line neither pass nor end near, whatever the line. */
static void test_apart_is_sure(void **state) {
    (void)state;
    static const double distance = 0.05;
    unsigned seed = 3;
    int apart = 0;
    for (int n = 0; n < 40000; n++) {
        double start[4][3], end[4][3];
        const double(*x)[3] = (const double(*)[3])start, (*y)[3] = (const double(*)[3])end;
        self_contact nearest = {.weight = {0}}, found;
        random_points(1, &seed, start);
        for (int k = 0; k < 4; k++)
            for (int a = 0; a < 3; a++)
                end[k][a] = start[k][a] + 0.5 * random_number(&seed);
        if (n % 4 < 2)
            self_pair_ends_near(n % 2, x, x, INFINITY, &nearest);
        for (int k = 0; k < 4 && n % 4 >= 2; k++)
            nearest.weight[k] = 8 * random_number(&seed);
        if (!self_pair_stays_apart(n % 2, x, y, nearest.weight, distance))
            continue;
        apart++;
        assert_false(self_pair_passes(n % 2, x, y, &found));
        assert_false(self_pair_ends_near(n % 2, x, y, distance, &found));
        assert_false(self_pair_ends_near(n % 2, x, x, distance, &found));
    }
    assert_in_range(apart, 4000, 20000);
}

/* In every part of a step the grid finds the pairs that a comparison of all pairs of triangles
 * finds. */
static void test_grid_misses_no_pair(void **state) {
    (void)state;
    mesh m = cloth_sheet(7, 6, 0.1, 0.3, 4);
    self_collision s;
    int in_part[SELF_PARTS] = {0};
    assert_int_equal(self_collision_init(&s, &m, 0.01, 0, 0.1), 0);
    for (unsigned seed = 1; seed < 100; seed++) {
        double(*x)[3] = cloth_moved(&m, 0.2, seed), (*v)[3] = cloth_moved(&m, 1, seed + 99);
        const double h = seed == 5 ? 10 : 0.1;
        for (int i = 0; i < m.vertex_count; i++) /* moves vertices to other cells */
            for (int a = 0; a < 3; a++)
                x[i][a] += 3.7 * seed * (a + 1);
        assert_int_equal(
            self_grid_find(&s, h, (const double(*)[3])x, (const double(*)[3])v, INFINITY), 0);
        int vertices = 0, expected = 0;
        for (int n = 0; n < s.pair_count; n++)
            vertices += !s.pair[n].is_edges;
        for (int i = 0; i < m.vertex_count; i++)
            for (int t = 0; t < m.triangle_count; t++) {
                int owner = -1, meet = 1;
                for (int u = m.triangle_count - 1; u >= 0; u--)
                    for (int p = 0; p < 3; p++)
                        owner = m.triangle[u][p] == i ? u : owner;
                for (int p = 0; p < 3; p++)
                    meet &= m.triangle[t][p] != i;
                for (int a = 0; a < 3 && owner >= 0; a++)
                    meet &= s.grid.box[owner][0][a] <= s.grid.box[t][1][a] &&
                            s.grid.box[t][0][a] <= s.grid.box[owner][1][a];
                expected += meet && owner >= 0;
            }
        assert_int_equal(vertices, expected);
        for (int part = 0; part < SELF_PARTS; part++)
            for (int n = 0; n < s.grid.part[part].count; n++)
                in_part[part] += !s.grid.part[part].pair[n].is_edges;
        free(x);
        free(v);
    }
    for (int part = 0; part < SELF_PARTS; part++)
        assert_true(in_part[part] > 0);
    self_collision_free(&s);
    cloth_free(&m);
}

/* Positions that are not finite have no cell in a grid: this is reported, and the search ends. */
static void test_not_finite_is_refused(void **state) {
    (void)state;
    mesh m = cloth_sheet(4, 4, 0.1, 0.3, 4);
    self_collision s;
    double(*x)[3] = cloth_moved(&m, 0.1, 1), (*v)[3] = cloth_moved(&m, 1, 2);
    assert_int_equal(self_collision_init(&s, &m, 0.01, 0, 0.1), 0);
    v[3][1] = INFINITY;
    assert_int_equal(
        self_grid_find(&s, 0.1, (const double(*)[3])x, (const double(*)[3])v, INFINITY), -1);
    v[3][1] = 1e200;
    assert_int_equal(
        self_grid_find(&s, 0.1, (const double(*)[3])x, (const double(*)[3])v, INFINITY), 0);
    free(x);
    free(v);
    self_collision_free(&s);
    cloth_free(&m);
}

/* A cloth held at one edge hangs down to the ground. When let go, it falls onto itself. */
static stage folding(double gap) {
    static collider ground = {.kind = COLLIDER_PLANE,
                              .position = {0, 0, -0.3},
                              .axis = {0, 0, 1},
                              .friction = 1,
                              .gap = 0.01};
    static pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}, .until = 0.6};
    stage on = stage_of(cloth_sheet(13, 7, 0.05, 0.3, 1), cloth_scene());
    on.s.time.step = 0.02;
    on.s.solution.tolerance = 1e-4;
    on.s.surroundings.drag = 0.1;
    on.s.material.bend = 1e-5;
    on.s.colliders = &ground;
    on.s.collider_count = 1;
    on.s.pins = &hold;
    on.s.pin_count = 1;
    on.s.self_collision.gap = gap;
    on.s.self_collision.friction = 0.3;
    return on;
}

static void test_cloth_folds_on_itself(void **state) {
    (void)state;
    int most[2] = {0, 0};
    for (int kept = 0; kept < 2; kept++) {
        stage on = folding(kept ? 0.008 : 0);
        stage_begin(&on);
        for (int n = 0; n < 100; n++) {
            stage_run(&on, 1);
            const int now = crossings(&on);
            most[kept] = now > most[kept] ? now : most[kept];
        }
        stage_assert_finite(&on);
        print_message("self-collision %s: %d crossings at most, %ld rejected, visited %ld\n",
                      kept ? "on" : "off", most[kept], simulation_counts(on.sim).rejected,
                      on.sim->account.effects[EFFECT_SELF_COLLISION].visited);
        stage_end(&on);
    }
    assert_true(most[0] > 0);
    assert_int_equal(most[1], 0);
}

/* Impulses are equal and opposite: without gravity, cloth that collides with itself conserves
 * momentum. */
static void test_momentum_stays(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(8, 6, 0.1, 0.3, 1), cloth_scene());
    double before[3] = {0, 0, 0}, after[3] = {0, 0, 0}, size = 0;
    memset(on.s.surroundings.gravity, 0, sizeof on.s.surroundings.gravity);
    on.s.self_collision.gap = 0.01;
    on.s.material.bend = 0;
    on.s.time.step = 0.02;
    on.s.solution.tolerance = 1e-12;
    on.s.monitor.energy = 1e300;                  /* the monitor does not know of this velocity */
    for (int i = 0; i < on.m.vertex_count; i++) { /* folds the right half over the left */
        if (on.m.position[i][0] < 0.36)
            continue;
        on.m.position[i][0] = 0.72 - on.m.position[i][0];
        on.m.position[i][2] = 0.06;
    }
    stage_begin(&on);
    for (int i = 0; i < on.m.vertex_count; i++) {
        on.sim->state.v[i][2] = on.sim->state.x[i][2] > 0 ? -1 : 1;
        vector_add_scaled(before, on.sim->cloth.mass[i], on.sim->state.v[i], before);
        size += on.sim->cloth.mass[i];
    }
    stage_changed(&on);
    stage_run(&on, 20);
    for (int i = 0; i < on.m.vertex_count; i++)
        vector_add_scaled(after, on.sim->cloth.mass[i], on.sim->state.v[i], after);
    vector_subtract(after, before, after);
    assert_below(vector_length(after) / size, 1e-10);
    assert_int_equal(crossings(&on), 0);
    stage_end(&on);
}

/* A flat cloth does not touch itself, so the bits are those without self-collision. */
static void test_flat_cloth_has_its_bits(void **state) {
    (void)state;
    stage with = stage_of(cloth_sheet(7, 7, 0.1, 0.3, 1), cloth_scene());
    stage without = stage_of(cloth_sheet(7, 7, 0.1, 0.3, 1), cloth_scene());
    static pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}};
    with.s.pins = without.s.pins = &hold;
    with.s.pin_count = without.s.pin_count = 1;
    with.s.self_collision.gap = 0.005;
    stage_begin(&with);
    stage_begin(&without);
    stage_run(&with, 20);
    stage_run(&without, 20);
    assert_memory_equal(with.sim->state.x, without.sim->state.x, sizeof(double[3]) * 49);
    assert_true(with.sim->account.effects[EFFECT_SELF_COLLISION].visited > 0);
    assert_int_equal(without.sim->account.effects[EFFECT_SELF_COLLISION].visited, 0);
    assert_null(without.sim->self_collision.grid.box);
    stage_end(&with);
    stage_end(&without);
}

/* A triangle is thinner than the gap. Its tip is too near to the opposite edge and stays there. If
 * the rest shape has room for the tip, the tip moves away. */
static void test_thin_triangles_stay(void **state) {
    (void)state;
    static const int triangle[4][3] = {{0, 1, 2}, {1, 3, 2}, {2, 3, 0}, {0, 4, 1}};
    const double h = 0.02, gap = 0.005;
    for (int n = 0; n < 8; n++) {
        const int is_thin = n & 1, falls_back = n >> 1 & 1, in_space = n >> 2;
        const double height = is_thin ? 0.002 : 0.02;
        const double material[5][2] = {{0, 0}, {0.1, 0}, {0.05, height}, {0.05, 0.1}, {0.05, -0.1}};
        double x[5][3] = {{0}}, v[5][3] = {{0}}, work = 0;
        stage on = stage_of(cloth_of(5, material, 4, triangle), cloth_scene());
        self_collision s;
        stage_begin(&on);
        for (int i = 0; i < 5; i++)
            memcpy(x[i], on.m.position[i], sizeof x[i]);
        x[2][1] = falls_back ? 0.006 : 0.002;
        v[2][1] = falls_back ? (0.0003 - x[2][1]) / h : 0;
        on.m.rest_in_space = in_space;
        for (int i = 0; i < 5 && in_space; i++)
            on.m.material[i][0] = on.m.material[i][1] = 0; /* must not decide */
        assert_int_equal(self_collision_init(&s, &on.m, gap, 0, h), 0);
        assert_int_equal(self_collision_find(&s, h, (const double(*)[3])x, (const double(*)[3])v),
                         0);
        const movable of = {on.sim->cloth.mass, &on.sim->collisions};
        const double change = self_collision_push(&s, &of, h, (const double(*)[3])x, v, &work);
        assert_int_equal(change > 0, !is_thin);
        self_collision_free(&s);
        stage_end(&on);
    }
}

/* A mesh slightly wider than the gap is pressed together: neighbours are nearer than the gap and
 * are not pushed apart. */
static void test_neighbours_stay(void **state) {
    (void)state;
    const double h = 0.02, gap = 0.005;
    stage on = stage_of(cloth_sheet(4, 4, 1.5 * gap, 0, 1), cloth_scene());
    double x[16][3], v[16][3] = {{0}}, work = 0;
    self_collision s;
    stage_begin(&on);
    for (int i = 0; i < 16; i++)
        for (int a = 0; a < 3; a++)
            x[i][a] = on.m.position[i][a] / 2;
    assert_int_equal(self_collision_init(&s, &on.m, gap, 0, h), 0);
    assert_int_equal(self_collision_find(&s, h, (const double(*)[3])x, (const double(*)[3])v), 0);
    assert_true(s.pair_count > 0);
    const movable of = {on.sim->cloth.mass, &on.sim->collisions};
    assert_true(self_collision_push(&s, &of, h, (const double(*)[3])x, v, &work) == 0);
    self_collision_free(&s);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_vertex_through_triangle),
        cmocka_unit_test(test_edge_through_edge),
        cmocka_unit_test(test_apart_is_sure),
        cmocka_unit_test(test_not_finite_is_refused),
        cmocka_unit_test(test_grid_misses_no_pair),
        cmocka_unit_test(test_momentum_stays),
        cmocka_unit_test(test_flat_cloth_has_its_bits),
        cmocka_unit_test(test_thin_triangles_stay),
        cmocka_unit_test(test_neighbours_stay),
        cmocka_unit_test(test_cloth_folds_on_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
