/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The methods that keep cloth apart after the system is solved, each compared with mechanics or a
 * simple computation: zones that move as rigid bodies, the search for near bodies and triangles,
 * and friction of several bodies. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "contact/impact.h"
#include "contact/shape_triangle.h"
#include "mesh/mesh_parts.h"
#include "mesh/surface.h"

/* Momentum and angular momentum about the origin, and energy. */
typedef struct motion_sum {
    double linear[3], angular[3]; /* N s, N m s */
    double energy;                /* J */
} motion_sum;

static motion_sum sum_of(const stage *on, const double (*x)[3], const double (*v)[3]) {
    motion_sum sum = {{0}, {0}, 0};
    for (int i = 0; i < on->m.vertex_count; i++) {
        const double mass = on->sim->cloth.mass[i];
        double turn[3];
        vector_cross(x[i], v[i], turn);
        vector_add_scaled(sum.linear, mass, v[i], sum.linear);
        vector_add_scaled(sum.angular, mass, turn, sum.angular);
        sum.energy += mass * vector_dot(v[i], v[i]) / 2;
    }
    return sum;
}

/* Returns three triangles with different masses, in general position. Without `grows` only the
 * first two meet. With it, these two, moving on together, then meet the third. */
static stage triangles_askew(int grows) {
    static const double material[9][2] = {{0, 0},   {0.2, 0}, {0, 0.3},   {1, 0},  {1.3, 0},
                                          {1, 0.2}, {2, 0},   {2.3, 0.1}, {2, 0.3}};
    static const int triangle[3][3] = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    static const double at[9][3] = {{0, 0, 0.01},   {0.2, 0.03, 0.06}, {0.04, 0.3, 0.02},
                                    {0, 0.1, 0.09}, {0.26, 0.1, 0.07}, {0.05, 0.13, -0.06},
                                    {0, 0, -0.02},  {0.3, 0.1, 0.01},  {0.05, 0.3, -0.04}};
    stage on = stage_of(cloth_of(9, material, 3, triangle), cloth_scene());
    memcpy(on.m.position, at, sizeof at);
    for (int i = 3; i < 6; i++)
        on.m.position[i][2] += grows ? 0.5 : 0.1;
    for (int i = 6; i < 9; i++)
        on.m.position[i][2] -= grows ? 0.15 : 10;
    return on;
}

/* A zone's vertices keep momentum and angular momentum, changed vertices keep their distances, and
 * the reported work is the change of energy. */
static void zones_are_rigid(void **state) {
    (void)state;
    for (int grows = 0; grows < 2; grows++) {
        stage on = triangles_askew(grows);
        double v[9][3] = {{1, 0, 9},   {2, 1, 7},   {0, 3, 8},    {3, 0, -9},  {0, 1, -8},
                          {1, 2, -12}, {0, 0, 0.1}, {0, 0, 0.15}, {0, 0, 0.05}};
        double before[9][3], work = 0;
        int changed[9];
        self_collision s;
        stage_begin(&on);
        for (int i = 0; i < 6 && grows; i++)
            v[i][2] = i < 3 ? 0.1 * v[i][0] : -26 - v[i][1];
        memcpy(before, v, sizeof v);
        const double(*x)[3] = (const double(*)[3])on.m.position;
        const movable of = {on.sim->cloth.mass, &on.sim->collisions};
        assert_int_equal(self_collision_init(&s, &on.m, 0.005, 0, 0.02), 0);
        assert_int_equal(self_grid_find(&s, 0.02, x, (const double(*)[3])v, INFINITY), 0);
        const motion_sum had = sum_of(&on, x, (const double(*)[3])before);
        assert_int_equal(impact_zones_make(&s, &of, 0.02, x, v, &work), 0);
        assert_int_equal(s.left, 0);
        const motion_sum has = sum_of(&on, x, (const double(*)[3])v);
        int moved = 0;
        for (int i = 0; i < 9; i++)
            moved += changed[i] = memcmp(v[i], before[i], sizeof v[i]) != 0;
        print_message("a zone of %d vertices, work %.3g J\n", moved, work);
        assert_int_equal(moved, grows ? 9 : 6);
        for (int a = 0; a < 3; a++) {
            assert_near(has.linear[a], had.linear[a], 1e-13);
            assert_near(has.angular[a], had.angular[a], 1e-13);
        }
        assert_true(work < -1e-3);
        assert_near(has.energy - had.energy, work, 1e-13);
        for (int i = 0; i < 9; i++)
            for (int k = 0; k < i; k++) {
                double apart[3], past[3];
                vector_subtract(x[i], x[k], apart);
                vector_subtract(v[i], v[k], past);
                if (changed[i] && changed[k])
                    assert_near(vector_dot(apart, past), 0, 1e-12);
            }
        self_collision_free(&s);
        stage_end(&on);
    }
}

/* A zone with a pinned vertex moves like the vertex and does not turn. */
static void held_zones_go_with_what_holds_them(void **state) {
    (void)state;
    pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 0.01}, .velocity = {0.3, 0, 0.1}};
    stage on = triangles_askew(0);
    on.s.pins = &hold;
    on.s.pin_count = 1;
    double v[9][3] = {{0.3, 0, 0.1}, {2, 1, 7}, {0, 3, 8}, {3, 0, -9}, {0, 1, -8}, {1, 2, -12}};
    double work = 0;
    self_collision s;
    stage_begin(&on);
    const double(*x)[3] = (const double(*)[3])on.m.position;
    const movable of = {on.sim->cloth.mass, &on.sim->collisions};
    assert_int_equal(self_collision_init(&s, &on.m, 0.005, 0, 0.02), 0);
    assert_int_equal(self_grid_find(&s, 0.02, x, (const double(*)[3])v, INFINITY), 0);
    assert_int_equal(impact_zones_make(&s, &of, 0.02, x, v, &work), 0);
    assert_int_equal(s.left, 0);
    for (int i = 0; i < 6; i++)
        for (int a = 0; a < 3; a++)
            assert_near(v[i][a], hold.velocity[a], 1e-14);
    self_collision_free(&s);
    stage_end(&on);
}

/* The grid finds every vertex that passes through a triangle, or begins or ends nearer to one than
 * the gap, on a way past several triangles. */
static void grid_follows_ways(void **state) {
    (void)state;
    static const double material[6][2] = {{0, 0}, {0.1, 0}, {0, 0.1}, {1, 0}, {1.1, 0}, {1, 0.1}};
    static const int triangle[2][3] = {{0, 1, 2}, {3, 4, 5}};
    mesh m = cloth_of(6, material, 2, triangle);
    self_collision s;
    unsigned seed = 8;
    int through = 0, near = 0;
    assert_int_equal(self_collision_init(&s, &m, 0.05, 0, 1), 0);
    for (int n = 0; n < 2000; n++) {
        double x[6][3], v[6][3] = {{0}}, start[4][3], end[4][3];
        self_contact found;
        for (int i = 0; i < 6; i++)
            for (int a = 0; a < 3; a++) {
                x[i][a] = 0.1 * random_number(&seed) + (i > 2 && a == 2 ? 0.3 : 0);
                v[i][a] = i > 2 && a == 2 ? 0.6 * random_number(&seed) : 0;
            }
        assert_int_equal(
            self_grid_find(&s, 1, (const double(*)[3])x, (const double(*)[3])v, INFINITY), 0);
        const int vertex[4] = {3, 0, 1, 2};
        for (int k = 0; k < 4; k++)
            for (int a = 0; a < 3; a++) {
                start[k][a] = x[vertex[k]][a];
                end[k][a] = start[k][a] + v[vertex[k]][a];
            }
        const int passes =
            self_pair_passes(0, (const double(*)[3])start, (const double(*)[3])end, &found);
        const int ends = self_pair_is_near(0, (const double(*)[3])end, 0.05, &found);
        int listed = 0;
        for (int k = 0; k < s.pair_count; k++)
            listed |= !s.pair[k].is_edges && s.pair[k].vertex[0] == 3;
        through += passes;
        near += ends && !passes;
        assert_true(listed || !(passes || ends));
    }
    print_message("%d ways through, %d near\n", through, near);
    assert_true(through > 20 && near > 10);
    self_collision_free(&s);
    cloth_free(&m);
}

/* A body that turns and moves within a step. If it is nearer to a vertex than its gap at one of 21
 * times of the step, collisions_find_near must report it. */
static void turning_bodies_are_near(void **state) {
    (void)state;
    unsigned seed = 4;
    int met = 0, off = 0;
    for (int n = 0; n < 400; n++) {
        keyframe path[2] = {{0, {0}, 0},
                            {1, {0.3 * random_number(&seed)}, 360 * random_number(&seed)}};
        collider rod = {.kind = COLLIDER_BOX,
                        .size = {1.5, 0.01, 0.01},
                        .gap = 0.01,
                        .turn_axis = {0, 0, 1},
                        .keyframe_count = 2,
                        .keyframes = path};
        for (int a = 0; a < 2; a++)
            rod.position[a] = 2 * random_number(&seed);
        stage on = stage_with(&rod);
        on.s.surroundings.gravity[2] = 0;
        stage_begin(&on);
        const double(*x)[3] = (const double(*)[3])on.m.position, h = 0.15;
        collisions_find_near(&on.sim->collisions, 0.2, h, x, NULL, NULL);
        int touched = 0;
        for (int part = 0; part <= 20; part++)
            for (int i = 0; i < on.m.vertex_count; i++) {
                double p[3], normal[3];
                motion_to_body(&rod, 0.2 + h * part / 20.0, x[i], p);
                touched |= shape_distance(&rod, p, normal) < rod.gap;
            }
        met += touched;
        off += !touched && on.sim->collisions.any_near == 0;
        assert_true(on.sim->collisions.any_near == 1 || !touched);
        stage_end(&on);
    }
    print_message("%d of 400 rods met, %d far\n", met, off);
    assert_true(met > 40 && off > 40);
}

/* Vertices above a tumbling cylinder: with the velocity that the contact prescribes along its
 * normal, they end the step outside of the body's final position. */
static void ways_over_turning_bodies_end_outside(void **state) {
    (void)state;
    unsigned seed = 6;
    int looked = 0;
    double deepest = 0, highest = 0;
    for (unsigned n = 0; n < 100; n++) {
        keyframe path[2] = {{0, {0}, -60}, {1, {0}, 540}};
        collider body = {.kind = COLLIDER_CYLINDER,
                         .position = {0.15, 0.15, -0.28},
                         .axis = {1, 0, 0},
                         .size = {0.25, 0.3},
                         .gap = 0.01,
                         .turn_axis = {0, 1, 0},
                         .keyframe_count = 2,
                         .keyframes = path};
        stage on = stage_with(&body);
        const double h = 0.02, time = 0.1;
        double(*v)[3] = cloth_moved(&on.m, 2, n + 1), (*still)[3] = calloc(16, sizeof *still);
        stage_begin(&on);
        collisions *c = &on.sim->collisions;
        for (int i = 0; i < 16; i++) {
            vector_subtract(v[i], on.m.position[i], v[i]);
            on.m.position[i][2] = -0.01 * random_number(&seed);
        }
        const double(*x)[3] = (const double(*)[3])on.m.position;
        collisions_detect(c, time, h, x, (const double(*)[3])v, (const double(*)[3])still);
        for (int i = 0; i < 16; i++) {
            double p[3], normal[3], end[3];
            motion_to_body(&body, time, x[i], p);
            if (c->now[i].count != 1 || shape_distance(&body, p, normal) < body.gap)
                continue;
            const contact *touch = &c->now[i].list[0];
            const double lacking = touch->speed - vector_dot(touch->normal, v[i]);
            vector_add_scaled(v[i], lacking > 0 ? lacking : 0, touch->normal, end);
            vector_add_scaled(x[i], h, end, end);
            motion_to_body(&body, time + h, end, p);
            const double room = shape_distance(&body, p, normal) - body.gap;
            deepest = fmax(deepest, -room);
            highest = fmax(highest, lacking > 0 ? room : 0);
            looked++;
        }
        free(v);
        free(still);
        stage_end(&on);
    }
    print_message("%d ways over a turning cylinder end %.2g m within its gap at most, %.2g m off\n",
                  looked, deepest, highest);
    assert_true(looked > 100);
    assert_below(deepest, 1e-9);
    assert_below(highest, 1e-9);
}

/* A distant ball that comes between a triangle's vertices is found. The remaining penetration is
 * counted if the triangle can move, but not if pins hold it. */
static void triangles_are_found_and_counted(void **state) {
    (void)state;
    pin hold = {.low = {-1, -1}, .high = {1, 1}};
    for (int held = 0; held < 2; held++) {
        collider ball = {.kind = COLLIDER_SPHERE,
                         .position = {0.13, 0.12, 1},
                         .velocity = {0, 0, -50},
                         .size = {0.02},
                         .friction = 0.3,
                         .gap = 0.002};
        stage on = stage_with(&ball);
        on.s.pins = &hold;
        on.s.pin_count = held;
        stage_begin(&on);
        const double(*x)[3] = (const double(*)[3])on.m.position, h = 0.02;
        double v[16][3] = {{0}}, work = 0;
        collisions *c = &on.sim->collisions;
        const movable of = {on.sim->cloth.mass, c};
        collisions_find_near(c, 0, h, x, (const double(*)[3])v, NULL);
        assert_int_equal(collisions_find_triangles(c, 0, h, x, (const double(*)[3])v), 0);
        assert_true(c->met.count > 0);
        collisions_check_triangles(c, &of, 0, h, x, (const double(*)[3])v);
        assert_true(held ? c->met.left == 0 : c->met.left > 0);
        for (int n = 0; n < 40 && collisions_push_triangles(c, &of, 0, h, x, v, &work) > 0; n++)
            ;
        collisions_check_triangles(c, &of, 0, h, x, (const double(*)[3])v);
        assert_int_equal(c->met.left, 0);
        stage_end(&on);
    }
}

/* Computes the momentum that a ball gives to a triangle when it moves into and along it, N s. */
static void pushed_by_a_ball(double friction, double pushed[3]) {
    static const double material[3][2] = {{0, 0}, {0.4, 0}, {0, 0.4}};
    static const int triangle[1][3] = {{0, 1, 2}};
    collider ball = {.kind = COLLIDER_SPHERE,
                     .position = {0.13, 0.13, 0.03},
                     .velocity = {1, 0, -2},
                     .size = {0.02},
                     .friction = friction,
                     .gap = 0.002};
    stage on = stage_of(cloth_of(3, material, 1, triangle), cloth_scene());
    collider two[2] = {ball, ball}; /* the first one is next to the triangle */
    two[0].position[0] += 0.2;
    on.s.colliders = two;
    on.s.collider_count = 2;
    stage_begin(&on);
    const double(*x)[3] = (const double(*)[3])on.m.position, h = 0.02;
    double v[3][3] = {{0}}, work = 0;
    collisions *c = &on.sim->collisions;
    const movable of = {on.sim->cloth.mass, c};
    collisions_find_near(c, 0, h, x, (const double(*)[3])v, NULL);
    assert_int_equal(collisions_find_triangles(c, 0, h, x, (const double(*)[3])v), 0);
    assert_true(collisions_push_triangles(c, &of, 0, h, x, v, &work) > 0);
    const motion_sum sum = sum_of(&on, x, (const double(*)[3])v);
    memcpy(pushed, sum.linear, sizeof sum.linear);
    stage_end(&on);
}

/* With friction the ball drags the triangle along, by Coulomb's fraction of the push. */
static void bodies_drag_triangles_along(void **state) {
    (void)state;
    double smooth[3], rough[3], along[3];
    pushed_by_a_ball(0, smooth);
    pushed_by_a_ball(0.2, rough);
    vector_subtract(rough, smooth, along);
    assert_true(smooth[2] < 0 && along[0] > 0);
    assert_near(along[0], 0.2 * vector_length(smooth), 0.03 * vector_length(smooth));
}

/* A mesh with a pit is not convex: a triangle above its rim meets the rim and not the pit's floor,
 * and a triangle within the pit meets nothing. */
static void meshes_are_not_convex(void **state) {
    (void)state;
    enum { around = 12, rings = 4 };
    static const double radius[rings] = {0.3, 0.3, 0.28, 0.26}, height[rings] = {0, 0.3, 0.3, 0.2};
    char error[256] = "";
    mesh m;
    int t = 0;
    assert_int_equal(mesh_allocate(&m, rings * around + 2, 2 * rings * around), 0);
    for (int k = 0; k < around; k++)
        for (int r = 0; r < rings; r++) {
            double *at = m.position[r * around + k];
            at[0] = radius[r] * cos(2 * acos(-1) * k / (int)around);
            at[1] = radius[r] * sin(2 * acos(-1) * k / (int)around);
            at[2] = height[r];
        }
    memset(m.position[rings * around], 0, sizeof *m.position);
    memset(m.position[rings * around + 1], 0, sizeof *m.position);
    m.position[rings * around + 1][2] = height[rings - 1];
    for (int k = 0; k < around; k++) {
        const int next = (k + 1) % around, last = (rings - 1) * around;
        const int below[3] = {rings * around, next, k};
        const int within[3] = {last + k, last + next, rings * around + 1};
        memcpy(m.triangle[t++], below, sizeof below);
        memcpy(m.triangle[t++], within, sizeof within);
        for (int r = 0; r < last; r += around) {
            const int one[3] = {r + k, r + next, r + around + next};
            const int other[3] = {r + k, r + around + next, r + around + k};
            memcpy(m.triangle[t++], one, sizeof one);
            memcpy(m.triangle[t++], other, sizeof other);
        }
    }
    collider pot = {.kind = COLLIDER_MESH, .gap = 0.01};
    pot.surface = surface_new(&m, error);
    if (!pot.surface)
        fail_msg("%s", error);
    /* The middle is above the pit's floor, which is nearest there, and the corners are above the
     * rim. */
    const double over[3][3] = {{-0.3, -0.18, 0.33}, {0.3, -0.18, 0.33}, {0, 0.36, 0.33}};
    const double down[3][3] = {{0, 0, -0.1}, {0, 0, -0.1}, {0, 0, -0.1}};
    double weight[3], at[3] = {0};
    approach found;
    assert_true(shape_meets_triangle(&pot, over, down, weight, &found));
    for (int n = 0; n < 3; n++)
        vector_add_scaled(at, weight[n], over[n], at);
    assert_true(hypot(at[0], at[1]) > 0.2);
    const double within[3][3] = {{-0.02, -0.02, 0.24}, {0.02, -0.02, 0.24}, {0, 0.02, 0.24}};
    const double little[3][3] = {{0, 0, -0.02}, {0, 0, -0.02}, {0, 0, -0.02}};
    assert_false(shape_meets_triangle(&pot, within, little, weight, &found));
    surface_free(pot.surface);
}

/* A sheet lies on a rough slope, which is the second body after a distant smooth one. With the
 * frictions exchanged the sheet slides as on a smooth slope. */
static void each_body_has_its_friction(void **state) {
    (void)state;
    for (int rough = 0; rough < 3; rough++) { /* slides freely, slides with friction, or sticks */
        const double angle = 0.4, friction = rough * 0.8 * tan(angle);
        collider bodies[2] = {
            {.kind = COLLIDER_SPHERE, .position = {9, 9, 9}, .size = {1}, .gap = 0.005},
            {.kind = COLLIDER_PLANE, .position = {0, 0, -0.005}, .axis = {0, 0, 1}, .gap = 0.005}};
        bodies[0].friction = rough ? 0 : 5;
        bodies[1].friction = friction;
        stage on = stage_with(bodies);
        on.s.collider_count = 2;
        on.s.surroundings.gravity[0] = 9.81 * sin(angle);
        on.s.surroundings.gravity[2] = -9.81 * cos(angle);
        stage_begin(&on);
        stage_run(&on, 60);
        const double free_fall = 9.81 * sin(angle) * 0.6, held = 9.81 * friction * cos(angle) * 0.6;
        const double expected = rough == 2 ? 0 : free_fall - held;
        for (int i = 0; i < on.m.vertex_count; i++)
            assert_near(on.sim->state.v[i][0], expected, rough == 2 ? 1e-9 : 0.06 * free_fall);
        stage_end(&on);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zones_are_rigid),
        cmocka_unit_test(held_zones_go_with_what_holds_them),
        cmocka_unit_test(grid_follows_ways),
        cmocka_unit_test(turning_bodies_are_near),
        cmocka_unit_test(ways_over_turning_bodies_end_outside),
        cmocka_unit_test(triangles_are_found_and_counted),
        cmocka_unit_test(bodies_drag_triangles_along),
        cmocka_unit_test(meshes_are_not_convex),
        cmocka_unit_test(each_body_has_its_friction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
