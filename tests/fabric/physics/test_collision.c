/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Shapes, swept paths, contact and friction. Numbers such as S28 refer to
 * docs/fabric-hard-cases.md. */
#include "check.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "cloth.h"
#include "contact/collision.h"
#include "contact/shape.h"
#include "mesh/mesh_parts.h"
#include "mesh/surface.h"
#include "step/simulation.h"

static collider shapes[] = {
    {.kind = COLLIDER_PLANE, .axis = {0, 0.6, 0.8}, .gap = 0.01},
    {.kind = COLLIDER_BOX, .size = {0.5, 0.3, 0.005}, .gap = 0.01},
    {.kind = COLLIDER_SPHERE, .size = {0.4, 0, 0}, .gap = 0.01},
    {.kind = COLLIDER_CYLINDER, .axis = {0.6, 0, 0.8}, .size = {0.2, 0.5, 0}, .gap = 0.01},
    {.kind = COLLIDER_MESH, .gap = 0.01}, /* the box of shape 1 as a mesh */
};
enum { shape_count = sizeof shapes / sizeof shapes[0] };

/* Returns a box with the given half edges. */
static surface *box_of_triangles(const double half[3]) {
    static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    char error[256] = "";
    mesh m;
    assert_int_equal(mesh_allocate(&m, 8, 12), 0);
    for (int v = 0; v < 8; v++)
        for (int a = 0; a < 3; a++)
            m.position[v][a] = (v >> a & 1) != 0 ? half[a] : -half[a];
    for (int f = 0; f < 6; f++)
        for (int p = 0; p < 3; p++) {
            m.triangle[2 * f][p] = face[f][p];
            m.triangle[2 * f + 1][p] = face[f][p == 0 ? 0 : p + 1];
        }
    surface *s = surface_new(&m, error);
    if (!s)
        fail_msg("%s", error);
    assert_null(m.position);
    return s;
}

static int make_box(void **state) {
    (void)state;
    shapes[4].surface = box_of_triangles(shapes[1].size);
    return 0;
}

static int free_box(void **state) {
    (void)state;
    surface_free(shapes[4].surface);
    return 0;
}

static void random_point(double size, unsigned *seed, double p[3]) {
    for (int a = 0; a < 3; a++)
        p[a] = size * random_number(seed);
}

static double distance(const collider *k, const double p[3]) {
    double normal[3];
    return shape_distance(k, p, normal);
}

/* The normal is the distance's gradient: a unit vector that agrees with differences, except at
 * creases. */
static void test_normal_is_the_gradient(void **state) {
    (void)state;
    unsigned seed = 1;
    const double d = 1e-6;
    for (int s = 0; s < shape_count; s++)
        for (int n = 0, creases = 0; n < 500; n++) {
            double p[3], normal[3], error = 0;
            random_point(0.8, &seed, p);
            shape_distance(&shapes[s], p, normal);
            for (int a = 0; a < 3; a++) {
                double up[3] = {p[0], p[1], p[2]}, down[3] = {p[0], p[1], p[2]};
                up[a] += d;
                down[a] -= d;
                const double slope =
                    (distance(&shapes[s], up) - distance(&shapes[s], down)) / (2 * d);
                error = fmax(error, fabs(slope - normal[a]));
            }
            creases += error > 1e-5;
            assert_in_range(creases, 0, 2);
            assert_near(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2], 1,
                        1e-12);
        }
}

/* A box as a mesh has the same distance as the box at any point and, away from creases, the same
 * normal. */
static void test_mesh_is_the_box(void **state) {
    (void)state;
    unsigned seed = 5;
    for (int n = 0; n < 20000; n++) {
        double p[3], normal[3], expected[3];
        random_point(n % 2 == 0 ? 1 : 0.1, &seed, p);
        const double should = shape_distance(&shapes[1], p, expected);
        assert_near(shape_distance(&shapes[4], p, normal), should, 1e-14);
        if (should > 0 && fabs(should) > 1e-6)
            for (int a = 0; a < 3; a++)
                assert_near(normal[a], expected[a], 1e-9);
    }
}

/* The distance to a bumpy ball is compared with the least distance to points spread over all its
 * triangles, and the sign with that of the ball. */
static void test_mesh_distance(void **state) {
    (void)state;
    enum { around = 24, down = 12, vertices = around * (down - 1) + 2 };
    char error[256];
    mesh m;
    unsigned seed = 3;
    assert_int_equal(mesh_allocate(&m, vertices, 2 * around * (down - 1)), 0);
    for (int k = 0; k < vertices; k++) {
        const int ring = k < vertices - 2 ? k / around + 1 : (k == vertices - 2 ? 0 : down);
        const double up = acos(-1) * ring / (int)down,
                     turn = 2 * acos(-1) * (k % around) / (int)around;
        const double radius = 0.5 + (k < vertices - 2 ? 0.1 * sin(3 * turn) * sin(up) : 0);
        m.position[k][0] = radius * sin(up) * cos(turn);
        m.position[k][1] = radius * sin(up) * sin(turn);
        m.position[k][2] = radius * cos(up);
    }
    int t = 0;
    for (int a = 0; a < around; a++) {
        const int b = (a + 1) % around;
        const int top[3] = {vertices - 2, a, b};
        const int end[3] = {vertices - 1, around * (down - 2) + b, around * (down - 2) + a};
        memcpy(m.triangle[t++], top, sizeof top);
        memcpy(m.triangle[t++], end, sizeof end);
        for (int r = 0; r + 2 < down; r++) {
            const int one[3] = {around * r + a, around * (r + 1) + a, around * (r + 1) + b};
            const int two[3] = {around * r + a, around * (r + 1) + b, around * r + b};
            memcpy(m.triangle[t++], one, sizeof one);
            memcpy(m.triangle[t++], two, sizeof two);
        }
    }
    assert_int_equal(t, m.triangle_count);
    surface *s = surface_new(&m, error);
    assert_non_null(s);
    const mesh *of = surface_mesh(s);
    for (int n = 0; n < 200; n++) {
        double p[3], normal[3], least = INFINITY;
        random_point(1, &seed, p);
        for (t = 0; t < of->triangle_count; t++)
            for (int u = 0; u <= 20; u++)
                for (int v = 0; u + v <= 20; v++) {
                    double away = 0;
                    for (int a = 0; a < 3; a++) {
                        const double at = (u * of->position[of->triangle[t][0]][a] +
                                           v * of->position[of->triangle[t][1]][a] +
                                           (20 - u - v) * of->position[of->triangle[t][2]][a]) /
                                          20;
                        away += (p[a] - at) * (p[a] - at);
                    }
                    least = fmin(least, sqrt(away));
                }
        const double distance = surface_distance(s, p, normal);
        const double size = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        assert_true(fabs(distance) <= least + 1e-12);
        assert_true(fabs(distance) >= least - 0.01);
        if (size < 0.35)
            assert_true(distance < 0);
        if (size > 0.65)
            assert_true(distance > 0);
    }
    surface_free(s);
}

/* Points with known distances. */
static void test_distances(void **state) {
    (void)state;
    const double origin[3] = {0, 0, 0}, above[3] = {0, 0, 2}, corner[3] = {3.5, 4.3, 0};
    double normal[3];
    assert_near(distance(&shapes[0], above), 1.6, 1e-15);
    assert_near(distance(&shapes[1], above), 1.995, 1e-15);
    assert_near(distance(&shapes[1], corner), 5, 1e-14);
    assert_near(distance(&shapes[1], origin), -0.005, 1e-15);
    assert_near(distance(&shapes[2], above), 1.6, 1e-15);
    assert_near(distance(&shapes[3], origin), -0.2, 1e-15);
    for (int s = 0; s < shape_count; s++) {
        shape_distance(&shapes[s], origin, normal);
        assert_near(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2], 1,
                    1e-12);
    }
}

/* S28: shape_approach is compared with the path in a thousand small steps. A point kept outside of
 * the plane found must never come nearer than the gap, and no path that stays clear may be
 * stopped. */
static void S28_no_path_gets_through(void **state) {
    (void)state;
    unsigned seed = 2;
    int touches = 0, grazing = 0;
    for (int s = 0; s < shape_count; s++)
        for (int n = 0; n < 2000; n++) {
            double p[3], end[3], u[3], least = INFINITY;
            approach found;
            random_point(1, &seed, p);
            random_point(1, &seed, end);
            if (distance(&shapes[s], p) < 0.0101)
                continue;
            for (int a = 0; a < 3; a++)
                u[a] = end[a] - p[a];
            for (int k = 0; k <= 1000; k++) {
                const double at[3] = {p[0] + k * 1e-3 * u[0], p[1] + k * 1e-3 * u[1],
                                      p[2] + k * 1e-3 * u[2]};
                least = fmin(least, distance(&shapes[s], at));
            }
            const int touched = shape_approach(&shapes[s], p, u, &found);
            if (least < 0.01)
                assert_true(touched);
            /* A long path close to a surface may count as a touch. */
            grazing += least > 0.0111 && touched && found.beyond > 0;
            if (!touched)
                continue;
            touches++;
            double kept[3];
            for (int a = 0; a < 3; a++)
                kept[a] = end[a] + (found.beyond > 0 ? found.beyond : 0) * found.normal[a];
            assert_true(distance(&shapes[s], kept) > 0.01 - 1e-7);
        }
    assert_in_range(touches, 1000, 10000);
    assert_in_range(grazing, 0, 2);
}

/* A cloth on a slope of the given angle: a plane, with gravity turned instead. */
typedef struct slope {
    mesh m;
    scene s;
    collider plane;
    simulation *sim;
} slope;

static void slope_new(slope *on, double angle, double friction) {
    char error[256];
    on->m = cloth_sheet(4, 4, 0.1, 0.2, 3);
    on->s = cloth_scene();
    on->plane =
        (collider){.kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .friction = friction, .gap = 0.005};
    on->plane.position[2] = -0.005;
    on->s.colliders = &on->plane;
    on->s.collider_count = 1;
    on->s.surroundings.gravity[0] = 9.81 * sin(angle);
    on->s.surroundings.gravity[2] = -9.81 * cos(angle);
    on->sim = simulation_new(&on->m, &on->s, error);
    assert_non_null(on->sim);
}

static void slope_end(slope *on) {
    simulation_free(on->sim);
    cloth_free(&on->m);
}

static void run(simulation *sim, int steps) {
    char error[256];
    for (int n = 0; n < steps; n++)
        assert_int_equal(simulation_step(sim, error), 0);
}

static double mean_speed(const simulation *sim, int vertices) {
    double sum = 0;
    for (int i = 0; i < vertices; i++)
        sum += simulation_velocities(sim)[i][0];
    return sum / vertices;
}

/* Coulomb's law: below the friction angle the cloth stays at rest; above it the cloth slides with
 * an acceleration of g (sin - mu cos). */
static void test_friction(void **state) {
    (void)state;
    const double angle = 0.5;
    slope on;
    slope_new(&on, angle, 1.2 * tan(angle));
    run(on.sim, 100);
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            assert_near(simulation_velocities(on.sim)[i][a], 0, 1e-9);
    slope_end(&on);

    slope_new(&on, angle, 0.5 * tan(angle));
    run(on.sim, 100);
    const double expected = 9.81 * (sin(angle) - 0.5 * tan(angle) * cos(angle)) * 1.0;
    assert_near(mean_speed(on.sim, on.m.vertex_count), expected, 0.05 * expected);
    slope_end(&on);

    slope_new(&on, angle, 0);
    run(on.sim, 100);
    assert_near(mean_speed(on.sim, on.m.vertex_count), 9.81 * sin(angle), 1e-6);
    slope_end(&on);
}

/* Cloth at rest on the plane must not stick to it when gravity is reversed. */
static void test_contact_does_not_hold_back(void **state) {
    (void)state;
    slope on;
    slope_new(&on, 0, 0.5);
    run(on.sim, 20);
    on.s.surroundings.gravity[2] = 9.81;
    run(on.sim, 30);
    const double moved = simulation_positions(on.sim)[0][2];
    assert_true(moved > 0.5 * 9.81 * 0.25 * 0.25);
    for (int i = 0; i < on.m.vertex_count; i++)
        assert_near(simulation_positions(on.sim)[i][2], moved, 0.02);
    slope_end(&on);
}

/* A moving plane carries what lies on it. */
static void test_moving_collider_carries(void **state) {
    (void)state;
    slope on;
    slope_new(&on, 0, 5);
    on.plane.velocity[0] = 0.2;
    on.plane.velocity[2] = 0.3;
    run(on.sim, 100);
    for (int i = 0; i < on.m.vertex_count; i++) {
        assert_near(simulation_velocities(on.sim)[i][0], 0.2, 1e-3);
        assert_near(simulation_positions(on.sim)[i][2], 0.3, 1e-4);
    }
    slope_end(&on);
}

/* S29: a pin and a wedge of two planes at one vertex, and three planes at one vertex: positions
 * stay finite and outside. */
static void S29_many_contacts_at_once(void **state) {
    (void)state;
    char error[256];
    collider walls[4];
    pin held = {.low = {-0.01, -0.01}, .high = {0.01, 0.01}, .velocity = {0, 0, 0}};
    mesh m = cloth_sheet(5, 5, 0.1, 0.2, 3);
    scene s = cloth_scene();
    const double normals[4][3] = {{0.6, 0, 0.8}, {-0.6, 0, 0.8}, {0, 0.6, 0.8}, {0, -0.6, 0.8}};
    for (int k = 0; k < 4; k++) {
        walls[k] = (collider){.kind = COLLIDER_PLANE, .friction = 0.3, .gap = 0.005};
        walls[k].position[0] = walls[k].position[1] = 0.2;
        walls[k].position[2] = -0.4;
        for (int a = 0; a < 3; a++)
            walls[k].axis[a] = normals[k][a];
    }
    s.colliders = walls;
    s.collider_count = 4;
    s.pins = &held;
    s.pin_count = 1;
    s.time.step = 0.033;
    simulation *sim = simulation_new(&m, &s, error);
    assert_non_null(sim);
    for (int n = 0; n < 60; n++) {
        run(sim, 1);
        for (int i = 0; i < m.vertex_count; i++)
            for (int k = 0; k < 4; k++) {
                double p[3];
                for (int a = 0; a < 3; a++)
                    p[a] = simulation_positions(sim)[i][a] - walls[k].position[a];
                assert_true(distance(&walls[k], p) > -1e-6);
            }
    }
    simulation_free(sim);
    cloth_free(&m);
}

/* Near a sharp edge or tip the normal of the nearest face alone may point to the wrong side. */
static void test_tip_is_outside(void **state) {
    (void)state;
    enum { around = 16 };
    char error[256] = "";
    mesh m;
    assert_int_equal(mesh_allocate(&m, around + 2, 2 * around), 0);
    for (int k = 0; k < around; k++) {
        m.position[k][0] = 0.03 * cos(2 * acos(-1) * k / (int)around);
        m.position[k][1] = 0.03 * sin(2 * acos(-1) * k / (int)around);
        m.position[k][2] = 0.1;
    }
    memset(m.position[around], 0, sizeof m.position[around]);
    m.position[around + 1][0] = m.position[around + 1][1] = 0;
    m.position[around + 1][2] = 0.1;
    for (int k = 0; k < around; k++) {
        const int next = (k + 1) % around;
        const int side[3] = {around, next, k}, top[3] = {around + 1, k, next};
        memcpy(m.triangle[2 * k], side, sizeof side);
        memcpy(m.triangle[2 * k + 1], top, sizeof top);
    }
    surface *s = surface_new(&m, error);
    assert_non_null(s);
    for (int k = 0; k < 100; k++) {
        const double p[3] = {0.01 * cos(k), 0.01 * sin(k), -0.01};
        double normal[3];
        assert_near(surface_distance(s, p, normal), vector_length(p), 1e-14);
    }
    surface_free(s);
}

/* A wedge of 20 degrees in any position. From all points in front of its edge the edge is nearest
 * and the point is outside, whichever face is examined. Rounding decides which face that is. */
static void test_edge_is_outside(void **state) {
    (void)state;
    unsigned seed = 11;
    for (int turned = 0; turned < 40; turned++) {
        char error[256] = "";
        double axes[3][3], flat[6][3];
        mesh m;
        for (int a = 0; a < 3; a++)
            axes[0][a] = random_number(&seed);
        const double other[3] = {random_number(&seed), random_number(&seed), random_number(&seed)};
        vector_cross(axes[0], other, axes[1]);
        for (int n = 0; n < 2; n++) {
            const double length = vector_length(axes[n]);
            for (int a = 0; a < 3; a++)
                axes[n][a] /= length;
        }
        vector_cross(axes[0], axes[1], axes[2]);
        for (int k = 0; k < 6; k++) { /* the edge, and two points behind each of its ends */
            flat[k][0] = k < 2 ? 0 : 1;
            flat[k][1] = k % 2 == 0 ? -2 : 2;
            flat[k][2] = k < 2 ? 0 : k < 4 ? tan(10 * acos(-1) / 180) : -tan(10 * acos(-1) / 180);
        }
        static const int faces[8][3] = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4},
                                        {2, 4, 3}, {3, 4, 5}, {0, 4, 2}, {1, 3, 5}};
        assert_int_equal(mesh_allocate(&m, 6, 8), 0);
        memcpy(m.triangle, faces, sizeof faces);
        for (int k = 0; k < 6; k++)
            for (int a = 0; a < 3; a++)
                m.position[k][a] =
                    flat[k][0] * axes[0][a] + flat[k][1] * axes[1][a] + flat[k][2] * axes[2][a];
        surface *s = surface_new(&m, error);
        if (!s)
            fail_msg("%s", error);
        for (int n = 0; n < 200; n++) {
            const double angle = acos(-1) * (0.5 + (n + 0.5) / 200), along = random_number(&seed);
            const double way = 0.3 * (1.1 + random_number(&seed));
            double p[3], normal[3];
            for (int a = 0; a < 3; a++)
                p[a] =
                    way * (cos(angle) * axes[0][a] + sin(angle) * axes[2][a]) + along * axes[1][a];
            /* In front of the edge: more than 10 degrees from both faces' normals, inwards. */
            if (fabs(angle - acos(-1)) < 79 * acos(-1) / 180)
                assert_near(surface_distance(s, p, normal), way, 1e-12);
        }
        surface_free(s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_normal_is_the_gradient),
        cmocka_unit_test(test_mesh_is_the_box),
        cmocka_unit_test(test_mesh_distance),
        cmocka_unit_test(test_tip_is_outside),
        cmocka_unit_test(test_edge_is_outside),
        cmocka_unit_test(test_distances),
        cmocka_unit_test(S28_no_path_gets_through),
        cmocka_unit_test(test_friction),
        cmocka_unit_test(test_contact_does_not_hold_back),
        cmocka_unit_test(test_moving_collider_carries),
        cmocka_unit_test(S29_many_contacts_at_once),
    };
    return cmocka_run_group_tests(tests, make_box, free_box);
}
