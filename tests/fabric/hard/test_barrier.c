/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Scenes with `contact: barrier`: in no frame does anything pass through cloth or bodies, by a
 * comparison of all features with all. Or the start is refused, with features and a remedy.
 */
#include "barrier_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/mesh_parts.h"
#include "mesh/surface.h"
#include "step/barrier_step.h"

static void two_layers(void **state) {
    (void)state;
    collider floor_only[1] = {barrier_ground};
    barrier_run("two layers", barrier_layers(2, 7, 0.05, 0.012, 0.012, 0.013),
                barrier_scene(1, floor_only), 30);
}

/* Vertices lie exactly above vertices: all edges of two layers are parallel. */
static void aligned_layers_on_a_ball(void **state) {
    (void)state;
    collider bodies[2] = {barrier_ground,
                          {.kind = COLLIDER_SPHERE,
                           .position = {0.12, 0.13, 0.06},
                           .size = {0.04},
                           .friction = 0.3,
                           .gap = 0.004}};
    barrier_run("aligned, ball", barrier_layers(2, 7, 0.04, 0.11, 0.006, 0),
                barrier_scene(2, bodies), 25);
}

/* The layers are 3 mm apart and must be kept 4 mm apart: they move apart. */
static void close_layers(void **state) {
    (void)state;
    collider floor_only[1] = {barrier_ground};
    barrier_run("close", barrier_layers(2, 7, 0.04, 0.01, 0.003, 0), barrier_scene(1, floor_only),
                20);
}

/* A pole between the vertices of a coarse sheet. */
static void thin_pole(void **state) {
    (void)state;
    collider bodies[2] = {barrier_ground, barrier_pole(0.005)};
    barrier_run("pole", barrier_layers(1, 7, 0.04, 0.22, 0, 0), barrier_scene(2, bodies), 30);
}

static surface *surface_of(mesh *m) {
    char error[256] = "";
    surface *s = surface_new(m, error);
    if (!s)
        fail_msg("%s", error);
    return s;
}

/* Returns cones with four sides and no base, tips upwards: open surfaces. */
static surface *spikes(int count, double radius, double height) {
    mesh m;
    assert_int_equal(mesh_allocate(&m, 5 * count, 4 * count), 0);
    for (int n = 0; n < count; n++) {
        for (int k = 0; k < 4; k++) {
            const int side[3] = {5 * n + 4, 5 * n + k, 5 * n + (k + 1) % 4};
            memcpy(m.triangle[4 * n + k], side, sizeof side);
            m.position[5 * n + k][0] = 0.06 * n + radius * cos(acos(-1) / 2 * k);
            m.position[5 * n + k][1] = radius * sin(acos(-1) / 2 * k);
        }
        m.position[5 * n + 4][0] = 0.06 * n;
        m.position[5 * n + 4][2] = height;
    }
    return surface_of(&m);
}

static void spikes_and_cone(void **state) {
    (void)state;
    for (int many = 0; many < 2; many++) {
        collider bodies[2] = {barrier_ground,
                              {.kind = COLLIDER_MESH,
                               .position = {many ? 0.063 : 0.123, 0.127, 0},
                               .surface = spikes(many ? 3 : 1, many ? 0.01 : 0.05, 0.1),
                               .friction = 0.3,
                               .gap = 0.004}};
        barrier_run(many ? "spikes" : "cone, open", barrier_layers(1, 7, 0.04, 0.11, 0, 0),
                    barrier_scene(2, bodies), 30);
        surface_free(bodies[1].surface);
    }
}

/* A rod of 4 mm at 5 m/s, which moves 10 cm per step, hits a hanging sheet. */
static void fast_rod(void **state) {
    (void)state;
    collider rod = {.kind = COLLIDER_CYLINDER,
                    .position = {0.13, 0.123, 0.25},
                    .velocity = {0, 0, -5},
                    .axis = {1, 0, 0},
                    .size = {0.002, 0.2},
                    .friction = 0.3,
                    .gap = 0.004};
    scene s = barrier_scene(1, &rod);
    s.surroundings.gravity[2] = 0;
    barrier_run("fast rod", barrier_layers(1, 7, 0.04, 0, 0, 0), s, 12);
}

/* Returns a sheet with another one standing on its middle row: edges with three triangles. */
static mesh t_junction(int columns, double spacing) {
    const int half = columns / 2, vertices = columns * (columns + half);
    double(*material)[2] = calloc((size_t)vertices, sizeof *material);
    double(*at)[3] = calloc((size_t)vertices, sizeof *at);
    int(*triangle)[3] = calloc((size_t)vertices * 2, sizeof *triangle);
    int count = 0;
    for (int r = 0; r < columns + half; r++)
        for (int c = 0; c < columns; c++) {
            const int i = r * columns + c;
            const int below = r == columns ? half * columns + c : i - columns;
            material[i][0] = spacing * c;
            material[i][1] = spacing * r;
            at[i][0] = spacing * c;
            at[i][1] = spacing * (r < columns ? r : half);
            at[i][2] = r < columns ? 0 : spacing * (r - columns + 1);
            if (r == 0 || c == 0)
                continue;
            const int first[3] = {below - 1, below, i}, second[3] = {below - 1, i, i - 1};
            memcpy(triangle[count++], first, sizeof first);
            memcpy(triangle[count++], second, sizeof second);
        }
    mesh m = cloth_of(vertices, (const double(*)[2])material, count, (const int(*)[3])triangle);
    memcpy(m.position, at, (size_t)vertices * sizeof *at);
    m.rest_in_space = 1;
    free(material);
    free(at);
    free(triangle);
    return m;
}

static void garment_with_a_t_junction(void **state) {
    (void)state;
    collider bodies[2] = {barrier_ground,
                          {.kind = COLLIDER_SPHERE,
                           .position = {0.12, 0.1, 0.05},
                           .size = {0.04},
                           .friction = 0.3,
                           .gap = 0.004}};
    mesh m = t_junction(7, 0.04);
    for (int i = 0; i < m.vertex_count; i++)
        m.position[i][2] += 0.1;
    barrier_run("T-junction", m, barrier_scene(2, bodies), 30);
}

/* Returns a flat tube, like the front and back of a shirt 1 cm apart, which falls over a pole. */
static mesh flat_tube(int around, int rings, double width, double length) {
    double(*material)[2] = calloc((size_t)(around * rings), sizeof *material);
    int(*triangle)[3] = calloc((size_t)(around * rings * 2), sizeof *triangle);
    int count = 0;
    for (int r = 0; r + 1 < rings; r++)
        for (int k = 0; k < around; k++) {
            const int a = r * around + k, b = r * around + (k + 1) % around;
            const int first[3] = {a, b, b + around}, second[3] = {a, b + around, a + around};
            memcpy(triangle[count++], first, sizeof first);
            memcpy(triangle[count++], second, sizeof second);
        }
    mesh m =
        cloth_of(around * rings, (const double(*)[2])material, count, (const int(*)[3])triangle);
    for (int i = 0; i < m.vertex_count; i++) {
        const double angle = 2 * acos(-1) * (i % around) / around;
        m.position[i][0] = width / 2 * cos(angle);
        m.position[i][1] = length * ((double)(i / around) / (rings - 1) - 0.5);
        m.position[i][2] = 0.1 + 0.005 * sin(angle);
    }
    m.rest_in_space = 1;
    free(material);
    free(triangle);
    return m;
}

static void shirt(void **state) {
    (void)state;
    collider bodies[2] = {barrier_ground, barrier_pole(0.01)};
    bodies[1].position[0] = bodies[1].position[1] = 0.01;
    bodies[1].position[2] = -0.11;
    barrier_run("shirt", flat_tube(14, 7, 0.24, 0.24), barrier_scene(2, bodies), 25);
}

static mesh crossed_layers(void) {
    mesh m = barrier_layers(2, 4, 0.04, 0.02, 0, 0);
    for (int i = m.vertex_count / 2; i < m.vertex_count; i++) {
        m.position[i][2] = 0.02 + 0.3 * (m.position[i][0] - 0.05);
        m.position[i][1] += 0.003;
    }
    return m;
}

static void bad_starts_are_named(void **state) {
    (void)state;
    collider bodies[1] = {barrier_ground};
    barrier_refused("crossed", crossed_layers(), barrier_scene(0, NULL),
                    "starts in itself: edge 3 6");
    barrier_refused("coincident", barrier_layers(2, 4, 0.04, 0.02, 0, 0), barrier_scene(0, NULL),
                    "touching");
    barrier_refused("below the floor", barrier_layers(1, 4, 0.04, -0.001, 0, 0),
                    barrier_scene(1, bodies), "lies 1 mm in colliders.0");
    collider thin[1] = {barrier_pole(0.001)};
    thin[0].position[0] = thin[0].position[1] = 0.05;
    barrier_refused("around a pole", barrier_layers(1, 4, 0.04, 0, 0, 0), barrier_scene(1, thin),
                    "starts in a body: edge of colliders.0 goes");
    bodies[0].until = 1;
    barrier_refused("until", barrier_layers(1, 4, 0.04, 0.1, 0, 0), barrier_scene(1, bodies),
                    "no until");
}

/* The first layer lies slightly below the second one except at one corner. */
static mesh layers_but_for_a_corner(void) {
    mesh m = barrier_layers(2, 5, 0.04, 0.02, -0.002, 0.001);
    m.position[0][2] -= 0.005;
    return m;
}

/* Returns a shirt whose front lies up to 1 cm behind its back, aligned with it or not. */
static mesh crossed_shirt(double aside) {
    mesh m = flat_tube(14, 7, 0.24, 0.24);
    for (int i = 0; i < m.vertex_count; i++) {
        double *at = m.position[i];
        const int turned = at[0] * at[0] + at[1] * at[1] < 0.0036;
        at[0] += at[2] > 0.1 ? aside : 0;
        at[2] = (turned ? 0.2 - at[2] : at[2]) + 0.05 * at[0] * at[1];
    }
    return m;
}

/* Returns the mean height of vertices, m. */
static double mean_height(const stage *on, int from, int count) {
    double sum = 0;
    for (int i = from; i < from + count; i++)
        sum += simulation_positions(on->sim)[i][2] / count;
    return sum;
}

/* Overlapping starts, which are refused without contact.untangle, run with it. Layers take the
 * order that most of their vertices have. */
static void overlapping_starts_are_untangled(void **state) {
    (void)state;
    collider floor_only[1] = {barrier_ground}, bodies[2] = {barrier_ground,
                                                            {.kind = COLLIDER_SPHERE,
                                                             .position = {0.06, 0.06, 0.04},
                                                             .size = {0.05},
                                                             .friction = 0.3,
                                                             .gap = 0.004}};
    struct {
        const char *name;
        mesh m;
        int colliders;
    } starts[] = {{"crossed", crossed_layers(), 1},
                  {"coincident", barrier_layers(2, 5, 0.04, 0.02, 0, 0), 1},
                  {"reversed", layers_but_for_a_corner(), 1},
                  {"five coincident", barrier_layers(5, 5, 0.04, 0.02, 0, 0), 1},
                  {"below the floor", barrier_layers(1, 5, 0.04, -0.001, 0, 0), 1},
                  {"in a ball", barrier_layers(2, 5, 0.04, 0.07, 0.0002, 0.001), 2},
                  {"shirt", crossed_shirt(0), 1},
                  {"shirt, shifted", crossed_shirt(0.007), 1}};
    for (size_t k = 0; k < sizeof starts / sizeof *starts; k++) {
        scene s = barrier_scene(starts[k].colliders, starts[k].colliders > 1 ? bodies : floor_only);
        pin corner = {.by = PIN_NEAREST};
        memcpy(corner.nearest, starts[k].m.position[0], sizeof corner.nearest);
        s.contact.untangle = 1;
        s.pin_count = k < 2;
        s.pins = &corner;
        stage on = stage_of(starts[k].m, s);
        const int layer = k == 1 || k == 2 ? on.m.vertex_count / 2 : 0;
        stage_begin(&on);
        assert_int_equal(barrier_passing(&on), 0);
        if (s.pin_count > 0)
            assert_memory_equal(simulation_positions(on.sim)[0], corner.nearest,
                                sizeof corner.nearest);
        if (layer > 0) {
            const double first = mean_height(&on, 0, layer), then = mean_height(&on, layer, layer);
            assert_below(1e-3, k == 1 ? then - first : first - then);
        }
        barrier_run_stage(starts[k].name, &on, 12);
        stage_end(&on);
    }
}

/* A plate comes down onto a sheet on a floor and does not stop. There is no room left, which must
 * be reported. */
static void squeezed(void **state) {
    (void)state;
    collider bodies[2] = {barrier_ground,
                          {.kind = COLLIDER_BOX,
                           .position = {0.08, 0.08, 0.03},
                           .velocity = {0, 0, -0.1},
                           .size = {0.1, 0.1, 0.01},
                           .friction = 0.3,
                           .gap = 0.004}};
    char error[256] = "";
    stage on = stage_of(barrier_layers(1, 5, 0.04, 0.006, 0, 0), barrier_scene(2, bodies));
    stage_begin(&on);
    int steps = 0, crossed = 0;
    for (; steps < 40 && simulation_step(on.sim, error) == 0; steps++)
        crossed += barrier_passing(&on);
    printf("%-18s after %d steps: %s\n", "squeezed", steps, error);
    assert_in_range(steps, 8, 10);
    assert_int_equal(crossed, 0);
    assert_non_null(strstr(error, "no room"));
    stage_end(&on);
}

/* Pairs examined, contacts and the systems' blocks grow linearly with the number of layers. The
 * layers are 3 mm apart, with a gap of 4 mm. */
static void work_is_linear_in_contacts(void **state) {
    (void)state;
    enum { looked_at, near, touching, blocks, counts };
    static const char *const names[counts] = {"pairs looked at", "near", "touching", "blocks"};
    double count[3][counts];
    for (int k = 0; k < 3; k++) {
        stage on = stage_of(barrier_layers(3 << k, 5, 0.04, 0.1, 0.003, 0), barrier_scene(0, NULL));
        stage_begin(&on);
        const barrier *b = &on.sim->barrier->contact;
        count[k][looked_at] = b->search.pair_count;
        count[k][near] = b->list.pairs;
        stage_run(&on, 1);
        count[k][touching] = (double)on.sim->account.effects[EFFECT_SELF_COLLISION].visited;
        count[k][blocks] = on.sim->barrier->system.all.A.block_count;
        stage_end(&on);
    }
    for (int n = 0; n < counts; n++) {
        printf("%-18s 3, 6, 12 layers: %.0f %.0f %.0f\n", names[n], count[0][n], count[1][n],
               count[2][n]);
        assert_true(count[1][n] > count[0][n]);
        assert_near(count[2][n] - count[1][n], 2 * (count[1][n] - count[0][n]),
                    0.05 * (count[2][n] - count[1][n]));
    }
    assert_below(count[2][looked_at], 8 * count[2][touching]);
}

/* A sheet falls onto a ball and wraps around it. Parts of the Hessian are left out, but this must
 * not take more systems. */
static void directions_are_conjugate(void **state) {
    (void)state;
    collider bodies[1] = {{.kind = COLLIDER_SPHERE,
                           .position = {0.24, 0.24, 0},
                           .size = {0.12},
                           .friction = 0.3,
                           .gap = 0.008}};
    scene s = barrier_scene(1, bodies);
    s.material.stretch = 400;
    s.material.shear = 80;
    stage on = stage_of(barrier_layers(1, 13, 0.04, 0.33, 0, 0), s);
    stage_begin(&on);
    stage_run(&on, 20);
    const long systems = simulation_counts(on.sim).newton_iterations;
    printf("round a ball       %ld systems\n", systems);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    assert_in_range(systems, 40, 117); /* 130 with Newton's directions, 166 with his steps */
    stage_end(&on);
}

static void sixteen_layers(void **state) {
    (void)state;
    collider floor_only[1] = {barrier_ground};
    stage on = stage_of(barrier_layers(16, 7, 0.05, 0.012, 0.012, 0), barrier_scene(1, floor_only));
    assert_below(barrier_run_stage("sixteen layers", &on, 60), 60);
    stage_end(&on);
}

int main(int argc, char **argv) {
    const struct CMUnitTest long_tests[] = {cmocka_unit_test(sixteen_layers)};
    if (argc > 1 && strcmp(argv[1], "long") == 0)
        return cmocka_run_group_tests(long_tests, NULL, NULL);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_layers),
        cmocka_unit_test(aligned_layers_on_a_ball),
        cmocka_unit_test(close_layers),
        cmocka_unit_test(thin_pole),
        cmocka_unit_test(spikes_and_cone),
        cmocka_unit_test(fast_rod),
        cmocka_unit_test(garment_with_a_t_junction),
        cmocka_unit_test(shirt),
        cmocka_unit_test(bad_starts_are_named),
        cmocka_unit_test(overlapping_starts_are_untangled),
        cmocka_unit_test(squeezed),
        cmocka_unit_test(work_is_linear_in_contacts),
        cmocka_unit_test(directions_are_conjugate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
