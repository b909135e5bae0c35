/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The rules of contact and of impulses, each alone, since a whole scene may not show that one is
 * broken. Numbers such as S39 refer to docs/fabric-hard-cases.md. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "contact/impact.h"
#include "contact/self_collision.h"
#include "contact/shape.h"
#include "mesh/mesh_parts.h"
#include "mesh/surface.h"

static collider plane = {.kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .friction = 0.5, .gap = 0.005};

/* A vertex inside a body is pushed out by at most one gap per step of the scene, whatever part of
 * the step h is. */
static void test_push_is_limited(void **state) {
    (void)state;
    stage on = stage_with(&plane);
    stage_begin(&on);
    const approach deep = {.normal = {0, 0, 1}, .room = -0.5};
    const approach little = {.normal = {0, 0, 1}, .room = -1e-4};
    const approach away = {.normal = {0, 0, 1}, .room = 0.02};
    const collisions *c = &on.sim->collisions;
    for (double h = on.s.time.step; h > on.s.time.step / 10; h /= 2) {
        assert_near(collisions_given_speed(c, &plane, &deep, h), 0.005 / on.s.time.step, 1e-12);
        assert_near(collisions_given_speed(c, &plane, &away, h), -0.02 / h, 1e-12);
    }
    assert_near(collisions_given_speed(c, &plane, &little, on.s.time.step), 1e-4 / on.s.time.step,
                1e-12);
    stage_end(&on);
}

/* Pins put their vertices into the prescribed positions, wherever they were. */
static void test_pins_place(void **state) {
    (void)state;
    pin moving = {.low = {-0.01, -1}, .high = {0.01, 1}, .velocity = {0.5, 0, -1}};
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.2, 3), cloth_scene());
    on.s.pins = &moving;
    on.s.pin_count = 1;
    stage_begin(&on);
    double(*x)[3] = cloth_moved(&on.m, 1, 5), (*v)[3] = cloth_moved(&on.m, 1, 6);
    collisions_place_pins(&on.sim->collisions, 2, x, v);
    int held = 0;
    for (int i = 0; i < on.m.vertex_count; i++) {
        if (on.m.material[i][0] > 0.01)
            continue;
        held++;
        for (int a = 0; a < 3; a++)
            assert_near(x[i][a], on.m.position[i][a] + 2 * moving.velocity[a], 1e-14);
    }
    assert_int_equal(held, 4);
    free(x);
    free(v);
    stage_end(&on);
}

/* Computes the depth in a moving collider at its position at that time, and the number of vertices
 * inside. */
static void test_depth(void **state) {
    (void)state;
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0, 0, -2},
                     .velocity = {0, 0, 1},
                     .size = {0.05},
                     .gap = 0.005};
    stage on = stage_with(&ball);
    stage_begin(&on);
    const double(*x)[3] = (const double(*)[3])on.m.position;
    collisions_find_near(&on.sim->collisions, 0, 2, x, NULL, NULL);
    assert_near(collisions_depth(&on.sim->collisions, 2, x), 0.05, 1e-14); /* at the corner */
    assert_near(collisions_depth(&on.sim->collisions, 1.96, x), 0.01, 1e-14);
    assert_near(collisions_depth(&on.sim->collisions, 0, x), 0, 0);
    assert_int_equal(collisions_inside(&on.sim->collisions, 2, x), 1);
    assert_int_equal(collisions_inside(&on.sim->collisions, 0, x), 0);
    stage_end(&on);
}

static void test_cylinder_has_ends(void **state) {
    (void)state;
    const collider rod = {.kind = COLLIDER_CYLINDER, .axis = {0, 0, 1}, .size = {3, 0.5}};
    const double above[3] = {0.1, 0, 2}, beside[3] = {5, 0, 0}, within[3] = {0, 0, 0.1};
    double normal[3];
    assert_near(shape_distance(&rod, above, normal), 1.5, 1e-14);
    assert_near(normal[2], 1, 1e-14);
    assert_near(shape_distance(&rod, beside, normal), 2, 1e-14);
    assert_near(shape_distance(&rod, within, normal), -0.4, 1e-14);
    assert_near(normal[2], 1, 1e-14);
}

/* Friction acts only in the plane of contact. */
static void test_friction_is_tangential(void **state) {
    (void)state;
    stage on = stage_with(&plane);
    stage_begin(&on);
    simulation *sim = on.sim;
    collisions *c = &sim->collisions;
    const contact slides = {.normal = {0, 0, 1}, .force = 2, .slip_speed = 0.1};
    c->now_empty = 0;
    c->now[5] = c->before[5] = (vertex_contacts){.count = 1, .list = {slides}};
    double(*v)[3] = calloc((size_t)on.m.vertex_count, sizeof *v);
    v[5][0] = 0.1;
    v[5][2] = -3;
    system_reset(&sim->system, sim->cloth.mass, on.s.surroundings.gravity, 0);
    const int d = sim->system.A.row_start[5];
    collisions_add_friction(c, 0.01, (const double(*)[3])v, &sim->system);
    const double factor = 0.01 * 0.5 * 2 / 0.1;
    assert_near(sim->system.A.value[d][2][2], sim->cloth.mass[5], 1e-14);
    assert_near(sim->system.A.value[d][0][0], sim->cloth.mass[5] + factor, 1e-14);
    assert_near(sim->system.b[5][0], -factor * 0.1, 1e-14);
    assert_near(sim->system.b[5][2], 0, 1e-14);
    free(v);
    stage_end(&on);
}

/* Two vertices that collide: the impulses are equal and opposite, friction is Coulomb's, and no
 * vertex is pushed into a body. */
static void test_impulses(void **state) {
    (void)state;
    stage on = stage_with(&plane);
    stage_begin(&on);
    const double *mass = on.sim->cloth.mass;
    const movable of = {mass, &on.sim->collisions};
    const feature both = {.count = 2, .vertex = {2, 7}, .weight = {1, -1}};
    const double up[3] = {0, 0, 1};
    double(*v)[3] = calloc((size_t)on.m.vertex_count, sizeof *v), work = 0, speed[3];
    const double light = 1 / mass[2] + 1 / mass[7];
    for (int slow = 0; slow < 2; slow++) {
        memset(v, 0, sizeof *v * (size_t)on.m.vertex_count);
        v[2][0] = slow ? 0.01 : 1;
        const double before = mass[2] * v[2][0];
        assert_true(impulse_give(&of, &both, up, 0.5, 0.3, NULL, v, &work));
        feature_velocity(&both, (const double(*)[3])v, speed);
        assert_near(speed[2], 0.5, 1e-13);
        assert_near(speed[0], slow ? 0 : 1 - 0.3 * 0.5, 1e-13);
        assert_near(mass[2] * v[2][2] + mass[7] * v[7][2], 0, 1e-16);
        assert_near(mass[2] * v[2][0] + mass[7] * v[7][0], before, 1e-16);
    }
    assert_true(light > 0);
    /* Vertex 7 lies on the plane and cannot move down, so vertex 2 takes the whole impulse. */
    memset(v, 0, sizeof *v * (size_t)on.m.vertex_count);
    on.sim->collisions.now[7] = (vertex_contacts){.count = 1, .list = {{.normal = {0, 0, 1}}}};
    assert_true(impulse_give(&of, &both, up, 0.5, 0, NULL, v, &work));
    assert_near(v[7][2], 0, 0);
    assert_near(v[2][2], 0.5, 1e-14);
    /* An impulse may lift vertex 7 from the plane. */
    const double down[3] = {0, 0, -1};
    assert_true(impulse_give(&of, &both, down, 0.5, 0, NULL, v, &work));
    assert_true(v[7][2] > 0.01);
    /* While lifted, it is slowed down like a free vertex. */
    const double lifted = v[7][2], together = mass[2] * v[2][2] + mass[7] * v[7][2];
    assert_true(impulse_give(&of, &both, up, lifted / 4, 0, NULL, v, &work));
    assert_true(v[7][2] > 0 && v[7][2] < lifted);
    assert_near(mass[2] * v[2][2] + mass[7] * v[7][2], together, 1e-16);
    /* If the plane moves up, vertex 7 is not slowed down below the plane's speed. */
    on.sim->collisions.now[7].list[0].speed = 0.25;
    v[7][2] = 0.5;
    assert_true(impulse_give(&of, &both, up, 100, 0, NULL, v, &work));
    assert_near(v[7][2], 0.25, 1e-15);
    free(v);
    stage_end(&on);
}

/* Layers that are farther apart than the gap need no impulses until they move far enough. */
static void test_apart_until_moved(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(7, 3, 0.1, 0.2, 3), cloth_scene());
    double(*v)[3] = calloc((size_t)on.m.vertex_count, sizeof *v), work = 0;
    static const double faster[] = {-0.15, -0.05, -1}; /* the upper layer's way: 3, 4, 24 mm */
    for (int i = 0; i < on.m.vertex_count; i++)
        if (on.m.position[i][0] > 0.35) { /* folds the right half over the left one */
            on.m.position[i][0] = 0.71 - on.m.position[i][0];
            on.m.position[i][2] = 0.006;
        }
    stage_begin(&on);
    const movable of = {on.sim->cloth.mass, &on.sim->collisions};
    const double(*x)[3] = (const double(*)[3])on.m.position;
    self_collision s;
    assert_int_equal(self_collision_init(&s, &on.m, 0.004, 0, 0.02), 0);
    assert_int_equal(self_collision_find(&s, 0.02, x, (const double(*)[3])v), 0);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < on.m.vertex_count; i++)
            v[i][2] += x[i][2] > 0 ? faster[k] : 0;
        const double largest = self_collision_push(&s, &of, 0.02, x, v, &work);
        assert_true(k < 2 ? largest == 0 : largest > 0.5);
    }
    /* Nothing is known of the pairs of another search. */
    for (int i = 0; i < on.m.vertex_count; i++) {
        on.m.position[i][2] /= 2;
        v[i][0] = v[i][1] = v[i][2] = 0;
    }
    assert_int_equal(self_collision_find(&s, 0.02, x, (const double(*)[3])v), 0);
    assert_true(self_collision_push(&s, &of, 0.02, x, v, &work) > 0);
    self_collision_free(&s);
    free(v);
    stage_end(&on);
}

/* Parts of the cloth that are nearer than the gap move apart, but neighbours in flat cloth do not.
 * Edges are examined as well as vertices. */
static void test_drawing_apart(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(7, 3, 0.1, 0.2, 3), cloth_scene());
    for (int i = 0; i < on.m.vertex_count; i++)
        if (on.m.position[i][0] > 0.35) { /* folds the right half over the left one */
            on.m.position[i][0] = 0.71 - on.m.position[i][0];
            on.m.position[i][2] = 0.006;
        }
    stage_begin(&on);
    const movable of = {on.sim->cloth.mass, &on.sim->collisions};
    double(*v)[3] = calloc((size_t)on.m.vertex_count, sizeof *v), work = 0;
    const double(*x)[3] = (const double(*)[3])on.m.position;
    self_collision s;
    assert_int_equal(self_collision_init(&s, &on.m, 0.01, 0, 0.02), 0);
    assert_int_equal(self_collision_find(&s, 0.02, x, (const double(*)[3])v), 0);
    int edges = 0;
    for (int n = 0; n < s.pair_count; n++)
        edges += s.pair[n].is_edges;
    assert_true(edges > 10 && edges < s.pair_count);
    const double largest = self_collision_push(&s, &of, 0.02, x, v, &work);
    assert_near(largest, 0.25 * 0.004 / 0.02, 1e-4);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_true(x[i][2] > 0 ? v[i][2] >= 0 : v[i][2] <= 0);
    /* Pairs without a demand are examined again when another pair has moved them. */
    for (int n = 0; n < 100 && self_collision_push(&s, &of, 0.02, x, v, &work) > 0; n++)
        ;
    assert_near(self_collision_push(&s, &of, 0.02, x, v, &work), 0, 0);
    for (int i = 0; i < on.m.vertex_count; i++)
        v[i][2] -= x[i][2] > 0 ? 1 : 0;
    assert_true(self_collision_push(&s, &of, 0.02, x, v, &work) > 0.5);
    self_collision_free(&s);
    free(v);
    stage_end(&on);

    mesh fine = cloth_sheet(5, 5, 0.01, 0.2, 3); /* its vertices are nearer than the gap */
    stage flat = stage_of(fine, cloth_scene());
    stage_begin(&flat);
    const movable all = {flat.sim->cloth.mass, &flat.sim->collisions};
    double(*still)[3] = calloc((size_t)flat.m.vertex_count, sizeof *still);
    assert_int_equal(self_collision_init(&s, &flat.m, 0.03, 0, 0.02), 0);
    const double(*at)[3] = (const double(*)[3])flat.m.position;
    assert_int_equal(self_collision_find(&s, 0.02, at, (const double(*)[3])still), 0);
    assert_true(s.pair_count > 100);
    assert_near(self_collision_push(&s, &all, 0.02, at, still, &work), 0, 0);
    self_collision_free(&s);
    free(still);
    stage_end(&flat);
}

static double volume(const double a[3], const double b[3], const double c[3], const double d[3]) {
    double ab[3], ac[3], ad[3], cross[3];
    vector_subtract(b, a, ab);
    vector_subtract(c, a, ac);
    vector_subtract(d, a, ad);
    vector_cross(ab, ac, cross);
    return vector_dot(cross, ad);
}

/* All four vertices move. The result is compared with the path in many small steps, also if the
 * vertex returns to its first side. */
static void test_vertex_through_moving_triangle(void **state) {
    (void)state;
    enum { parts = 400 };
    unsigned seed = 7;
    int passed = 0, came_back = 0;
    for (int n = 0; n < 3000; n++) {
        double x[4][3], y[4][3], before = 0, first = 0, last = 0;
        self_contact found;
        int through = 0;
        for (int k = 0; k < 4; k++)
            for (int a = 0; a < 3; a++) {
                x[k][a] = random_number(&seed);
                y[k][a] = random_number(&seed);
            }
        for (int part = 0; part <= parts; part++) {
            double at[4][3];
            for (int k = 0; k < 4; k++)
                for (int a = 0; a < 3; a++)
                    at[k][a] = x[k][a] + (y[k][a] - x[k][a]) * part / (double)parts;
            const double now = volume(at[1], at[2], at[3], at[0]);
            if (part > 0 && (now < 0) != (before < 0)) {
                double normal[3], one[3], other[3], least = INFINITY;
                vector_subtract(at[2], at[1], one);
                vector_subtract(at[3], at[1], other);
                vector_cross(one, other, normal);
                for (int p = 1; p < 4; p++) { /* the part of the area on each edge's inner side */
                    double edge[3], to[3], cross[3];
                    vector_subtract(at[p % 3 + 1], at[p], edge);
                    vector_subtract(at[0], at[p], to);
                    vector_cross(edge, to, cross);
                    least = fmin(least, vector_dot(cross, normal) / vector_dot(normal, normal));
                }
                through |= least > 0.05;
            }
            first = part == 0 ? now : first;
            last = before = now;
        }
        if (!through)
            continue;
        passed++;
        came_back += (first < 0) == (last < 0);
        assert_true(self_pair_passes(0, (const double(*)[3])x, (const double(*)[3])y, &found));
    }
    print_message("%d pass, %d of them come back\n", passed, came_back);
    assert_true(passed > 150 && came_back > 50);
}

/* Cloth that starts inside a collider is counted, and its later state is reported. */
static void test_start_inside(void **state) {
    (void)state;
    collider ball = {
        .kind = COLLIDER_SPHERE, .position = {0.15, 0.15, -0.02}, .size = {0.12}, .gap = 0.005};
    stage on = stage_with(&ball);
    on.s.surroundings.gravity[2] = 0;
    stage_begin(&on);
    stage_run(&on, 60);
    const run_faults f = simulation_faults(on.sim);
    long inside = 0;
    for (int i = 0; i < on.m.vertex_count; i++) {
        double away[3];
        vector_subtract(on.m.position[i], ball.position, away);
        inside += vector_length(away) < 0.12;
    }
    print_message("S39 start inside: %ld vertices, %.3g m deep; stretched to %.3g\n",
                  f.start_inside, f.start_depth, 1 + f.greatest_strain);
    assert_true(inside > 2);
    assert_int_equal(f.start_inside, inside);
    assert_true(f.start_depth > 0.02 && f.start_depth < 0.12);
    assert_near(collisions_depth(&on.sim->collisions, simulation_time(on.sim),
                                 (const double(*)[3])on.sim->state.x),
                0, 1e-6);
    assert_below(f.greatest_strain, 1);
    stage_end(&on);
}

/* Returns a sheet folded over itself, with its upper half `apart` above the lower one. */
static stage folded(double apart) {
    stage on = stage_of(cloth_sheet(7, 3, 0.1, 0.2, 3), cloth_scene());
    for (int i = 0; i < on.m.vertex_count; i++)
        if (on.m.position[i][0] > 0.35) {
            on.m.position[i][0] = 0.71 - on.m.position[i][0];
            on.m.position[i][2] = apart;
        }
    return on;
}

/* The upper half would end the step exactly on the lower one. It must end a tenth of the gap above
 * it, and another round must have nothing left to push. */
static void test_ends_in_touch(void **state) {
    (void)state;
    stage on = folded(0.02);
    stage_begin(&on);
    const double h = 0.01;
    double(*v)[3] = calloc((size_t)on.m.vertex_count, sizeof *v), work = 0;
    const double(*x)[3] = (const double(*)[3])on.m.position;
    self_collision s;
    assert_int_equal(self_collision_init(&s, &on.m, 0.01, 0, 0.02), 0);
    for (int i = 0; i < on.m.vertex_count; i++)
        v[i][2] = x[i][2] > 0 ? (1e-6 - 0.02) / h : 0;
    impact_step step = {.h = h,
                        .x = x,
                        .v = v,
                        .of = {on.sim->cloth.mass, &on.sim->collisions},
                        .itself = &s,
                        .bodies = &on.sim->collisions};
    assert_int_equal(impact_resolve(&step, &work), 0);
    assert_int_equal(s.left, 0);
    assert_below(self_collision_push(&s, &step.of, h, x, v, &work), 2e-3 * 0.01 / h);
    double lowest = INFINITY, highest = -INFINITY;
    for (int i = 0; i < on.m.vertex_count; i++)
        if (on.m.material[i][0] > 0.45)
            lowest = fmin(lowest, x[i][2] + h * v[i][2]);
        else if (on.m.material[i][0] < 0.25 && on.m.material[i][0] > 0.15)
            highest = fmax(highest, x[i][2] + h * v[i][2]);
    print_message("upper half down to %g m, lower up to %g m\n", lowest, highest);
    assert_true(lowest > highest + 8e-4);
    self_collision_free(&s);
    free(v);
    stage_end(&on);
}

/* Gives each vertex of a folded cloth a random velocity of up to `wild` m/s and checks that nothing
 * passes. Returns how much another round would still push, m/s. */
static double thrown_at_itself(double wild, unsigned seed) {
    stage on = folded(0.012);
    stage_begin(&on);
    const double h = 0.01;
    double(*v)[3] = cloth_moved(&on.m, wild, seed), work = 0;
    const double(*x)[3] = (const double(*)[3])on.m.position;
    self_collision s;
    assert_int_equal(self_collision_init(&s, &on.m, 0.01, 0.3, 0.02), 0);
    for (int i = 0; i < on.m.vertex_count; i++)
        v[i][2] -= x[i][2] > 0 ? 1 : 0;
    impact_step step = {.h = h,
                        .x = x,
                        .v = v,
                        .of = {on.sim->cloth.mass, &on.sim->collisions},
                        .itself = &s,
                        .bodies = &on.sim->collisions};
    assert_int_equal(impact_resolve(&step, &work), 0);
    assert_int_equal(s.left, 0);
    const double more = self_collision_push(&s, &step.of, h, x, v, &work);
    print_message("wild by %g m/s: another round pushes by %g m/s\n", wild, more);
    self_collision_free(&s);
    free(v);
    stage_end(&on);
    return more;
}

/* Rounds continue until almost nothing is left to push. Very fast motions must also end apart. */
static void test_rounds_and_zones(void **state) {
    (void)state;
    assert_below(thrown_at_itself(0.2, 9), 1e-4);
    for (unsigned seed = 9; seed < 29; seed++)
        thrown_at_itself(seed % 2 == 0 ? 20 : 100, seed);
}

/* If demands contradict each other, the first one is satisfied. */
static void test_first_demand_wins(void **state) {
    (void)state;
    const double d[3][3] = {{0, 0, 2}, {0, 0, 1}, {1, 0, 1}}, change[3] = {2, 5, 4};
    constraints c;
    assert_int_equal(constraints_init(&c, 1), 0);
    assert_int_equal(constraint_place(&c, 0), 0);
    constraint_give(&c, 0, 3, d, change);
    assert_int_equal(c.given[0], 2);
    assert_near(constraint_change(&c, 0)[2], 1, 1e-14);
    assert_near(constraint_change(&c, 0)[0], 3, 1e-14);
    constraints_free(&c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_push_is_limited),
        cmocka_unit_test(test_pins_place),
        cmocka_unit_test(test_depth),
        cmocka_unit_test(test_cylinder_has_ends),
        cmocka_unit_test(test_friction_is_tangential),
        cmocka_unit_test(test_impulses),
        cmocka_unit_test(test_apart_until_moved),
        cmocka_unit_test(test_drawing_apart),
        cmocka_unit_test(test_vertex_through_moving_triangle),
        cmocka_unit_test(test_ends_in_touch),
        cmocka_unit_test(test_rounds_and_zones),
        cmocka_unit_test(test_first_demand_wins),
        cmocka_unit_test(test_start_inside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
