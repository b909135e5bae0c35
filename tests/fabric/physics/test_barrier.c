/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The barrier's parts, each compared with a slow independent computation. */
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "check.h"
#include "cloth.h"
#include "contact/barrier_system.h"

/* Returns the least distance of two features, by sampling many points of both. */
static double sampled_distance(int is_edges, const double x[4][3]) {
    enum { parts = 60 };
    double least = INFINITY;
    for (int i = 0; i <= parts; i++)
        for (int j = 0; j <= (is_edges ? parts : parts - i); j++) {
            const double s = (double)i / (int)parts, t = (double)j / (int)parts;
            const double weight[4] = {is_edges ? 1 - s : 1, is_edges ? s : s + t - 1,
                                      is_edges ? t - 1 : -s, -t};
            double apart[3] = {0};
            for (int k = 0; k < 4; k++)
                vector_add_scaled(apart, weight[k], x[k], apart);
            least = fmin(least, vector_length(apart));
        }
    return least;
}

/* Draws four points in a cube of 2 m; in some kinds they are coplanar, parallel, or in one
 * position. */
static void random_points(unsigned *seed, int kind, double x[4][3]) {
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++)
            x[k][a] = random_number(seed);
    if (kind == 1) /* parallel edges */
        for (int a = 0; a < 3; a++)
            x[3][a] = x[2][a] + 0.7 * (x[1][a] - x[0][a]);
    if (kind == 2) /* coplanar points */
        for (int k = 0; k < 4; k++)
            x[k][2] = 0;
    if (kind == 3) /* an edge without length, a triangle without area */
        memcpy(x[2], x[3], sizeof x[2]);
}

static void nearest_points(void **state) {
    unsigned seed = 5;
    (void)state;
    for (int n = 0; n < 400; n++)
        for (int is_edges = 0; is_edges < 2; is_edges++) {
            double x[4][3];
            nearest found;
            random_points(&seed, n % 4, x);
            const double(*at)[3] = (const double(*)[3])x;
            if (is_edges)
                nearest_edges(at, &found);
            else
                nearest_vertex_triangle(at, &found);
            const double sampled = sampled_distance(is_edges, at);
            assert_below(found.distance, sampled + 1e-12);
            assert_near(found.distance, sampled, 0.03);
            assert_near(found.weight[0] + found.weight[1] + found.weight[2] + found.weight[3], 0,
                        1e-12);
        }
}

/* Returns a barrier with one pair, or with one triangle above a plane and a ball. */
static barrier one_pair(barrier_pair *pair, mesh *m, scene *s, int *owner) {
    barrier b = {.scene = s, .cloth = m, .surface = *m, .stiffness = 2e-3, .slip_speed = 0.1};
    b.collider = owner;
    b.list.pair = pair;
    b.list.pairs = b.list.pair_room = 1;
    return b;
}

/* No features may pass, at sampled times, within the fraction of the displacement that
 * barrier_allowed_part returns. It must return at least half of the fraction that is free. */
static void parts_of_ways_do_not_pass(void **state) {
    enum { samples = 2000 };
    unsigned seed = 9;
    int cut = 0;
    (void)state;
    for (int n = 0; n < 300; n++) {
        double x[4][3], way[4][3];
        int owner[4] = {-1, -1, -1, -1};
        barrier_pair pair = {{0, 1, 2, 3}, n % 2 ? BARRIER_EDGES : BARRIER_VERTEX, -1, 0.1};
        mesh m = {.vertex_count = 4, .position = x};
        scene s = {0};
        random_points(&seed, 0, x);
        random_points(&seed, 0, way);
        const double(*begin)[3] = (const double(*)[3])x;
        const barrier b = one_pair(&pair, &m, &s, owner);
        const double part = barrier_allowed_part(&b, begin, (const double(*)[3])way);
        const double first = sampled_distance(n % 2, begin);
        double least = INFINITY;
        for (int k = 0; k <= samples; k++) {
            double at[4][3];
            nearest found;
            for (int v = 0; v < 4; v++)
                vector_add_scaled(x[v], part * k / (int)samples, way[v], at[v]);
            if (n % 2)
                nearest_edges((const double(*)[3])at, &found);
            else
                nearest_vertex_triangle((const double(*)[3])at, &found);
            least = fmin(least, found.distance);
        }
        assert_true(part > 0 && part <= 1);
        assert_true(least > 0.05 * first);
        cut += part < 1;
        if (part < 1) /* the way is not shortened long before features are near */
            assert_below(least, 0.5 * first + 1e-3);
    }
    assert_in_range(cut, 20, 280);
}

/* A single vertex would move 3 times as far as the other feature is away: its displacement must be
 * shortened. */
static void each_vertex_is_cut(void **state) {
    (void)state;
    for (int is_edges = 0; is_edges < 2; is_edges++)
        for (int mover = 0; mover < 4; mover++) {
            double x[4][3] = {{0, 0, 0.1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, way[4][3] = {{0}};
            double edges[4][3] = {{0, 0, 0.1}, {1, 0, 0.1}, {0, 0, 0}, {0, 1, 0}};
            int owner[4] = {-1, -1, -1, -1};
            barrier_pair pair = {{0, 1, 2, 3}, is_edges ? BARRIER_EDGES : BARRIER_VERTEX, -1, 0.1};
            mesh m = {.vertex_count = 4, .position = x};
            scene s = {0};
            const double height = mover < (is_edges ? 2 : 1) ? -0.3 : 0.3;
            if (is_edges)
                memcpy(x, edges, sizeof x);
            else
                memcpy(x[0], (double[3]){x[mover][0], x[mover][1], 0.1}, sizeof x[0]);
            /* The edges' ends that meet are those that may move. */
            if (is_edges && mover % 2 == 1)
                for (int a = 0; a < 2; a++) {
                    x[2 * (1 - mover / 2)][a] = x[mover][a];
                    x[2 * (1 - mover / 2) + 1][a] = x[mover][a] + (a == 1);
                }
            way[mover][2] = height;
            const barrier b = one_pair(&pair, &m, &s, owner);
            const double part =
                barrier_allowed_part(&b, (const double(*)[3])x, (const double(*)[3])way);
            assert_true(part > 0.15 && part < 1.0 / 3);
        }
}

/* However often a vertex is moved towards a triangle, it must stay on its side, at least a
 * millionth of its reach away. */
static void many_ways_do_not_pass(void **state) {
    double x[4][3] = {{0.3, 0.3, 0.01}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const double way[4][3] = {{0.1, 0, -1}};
    int owner[4] = {-1, -1, -1, -1};
    barrier_pair pair = {{0, 1, 2, 3}, BARRIER_VERTEX, -1, 0.1};
    mesh m = {.vertex_count = 4, .position = x};
    scene s = {0};
    const barrier b = one_pair(&pair, &m, &s, owner);
    (void)state;
    for (int n = 0; n < 100; n++) {
        const double part = barrier_allowed_part(&b, (const double(*)[3])x, way);
        vector_add_scaled(x[0], part, way[0], x[0]);
        assert_true(x[0][2] > 0.99e-7);
    }
    assert_below(x[0][2], 1.01e-7);
}

/* Exactly parallel edges have no energy, since their nearest points are not unique. */
static void parallel_edges_do_not_push(void **state) {
    (void)state;
    for (int parallel = 0; parallel < 2; parallel++) {
        double x[4][3] = {{0, 0, 0}, {1, 0, 0}, {0.2, -0.5, 0.05}, {0.2, 0.5, 0.05}};
        int owner[4] = {-1, -1, -1, -1};
        barrier_pair pair = {{0, 1, 2, 3}, BARRIER_EDGES, -1, 0.1};
        mesh m = {.vertex_count = 4, .position = x};
        scene s = {0};
        if (parallel)
            memcpy(x[3], (double[3]){1.2, -0.5, 0.05}, sizeof x[3]);
        x[2][1] = parallel ? 0 : x[2][1];
        x[3][1] = parallel ? 0 : x[3][1];
        const barrier b = one_pair(&pair, &m, &s, owner);
        const double energy = barrier_energy(&b, (const double(*)[3])x);
        /* stiffness * ln 2 / 4, at half of the reach */
        assert_near(energy, parallel ? 0 : 2e-3 * log(2) / 4, 1e-15);
    }
}

/* Compares the gradient and Hessian of one pair with differences of the energy. kind 3: nearly
 * parallel edges. */
static void compare_pair(int kind, double reach, double slip, unsigned *seed) {
    double x[4][3], begin[4][3], gradient[4][3] = {{0}};
    int owner[4] = {-1, -1, -1, -1};
    collider plane = {.kind = COLLIDER_PLANE, .axis = {0, 0.6, 0.8}, .friction = 0.4};
    scene s = {.collider_count = 1, .colliders = &plane, .self_collision.friction = 0.5};
    random_points(seed, 0, x);
    barrier_pair pair = {{0, 1, 2, 3}, kind == 3 ? BARRIER_EDGES : (barrier_kind)kind, -1, reach};
    if (kind == 3) {
        for (int a = 0; a < 3; a++)
            x[3][a] = x[2][a] + (x[1][a] - x[0][a]) + 0.01 * random_number(seed);
    }
    if (kind == BARRIER_PLANE) {
        pair = (barrier_pair){{0, 1, 1, 1}, BARRIER_PLANE, 0, reach};
        vector_add_scaled(x[1], 0.3, plane.axis, x[0]);
        x[0][0] += 0.1;
    }
    mesh m = {.vertex_count = 4, .position = begin};
    memcpy(begin, x, sizeof x);
    barrier b = one_pair(&pair, &m, &s, owner);
    b.begin = begin;
    assert_int_equal(barrier_find_contacts(&b, (const double(*)[3])x), 0);
    if (b.list.contacts == 1) {
        const double h = 0.1, d = 1e-6;
        assert_int_equal(barrier_grip_contacts(&b), 0);
        for (int k = 0; k < 4; k++)
            for (int a = 0; a < 3; a++)
                x[k][a] += slip * random_number(seed);
        assert_int_equal(barrier_find_contacts(&b, (const double(*)[3])x), 0);
        assert_int_equal(barrier_make_elements(&b, h, (const double(*)[3])x), 0);
        double scale = 0;
        for (int e = 0; e < b.list.elements; e++)
            for (int k = 0; k < 4; k++)
                for (int a = 0; a < 3; a++) {
                    gradient[b.list.element[e].vertex[k]][a] += b.list.element[e].gradient[k][a];
                    scale = fmax(scale, fabs(b.list.element[e].gradient[k][a]));
                }
        for (int k = 0; k < (kind == BARRIER_PLANE ? 2 : 4); k++)
            for (int a = 0; a < 3; a++) {
                double energy[2];
                for (int side = 0; side < 2; side++) {
                    x[k][a] += side ? d : -d;
                    energy[side] = barrier_energy(&b, (const double(*)[3])x) +
                                   barrier_friction(&b, h, (const double(*)[3])x);
                    x[k][a] -= side ? d : -d;
                }
                assert_near(gradient[k][a], (energy[1] - energy[0]) / (2 * d), 2e-5 * scale);
            }
    }
    free(b.list.contact);
    free(b.list.grip);
    free(b.list.element);
}

static void gradients_are_those_of_the_energy(void **state) {
    unsigned seed = 77;
    (void)state;
    for (int n = 0; n < 200; n++)
        for (int kind = 0; kind < 4; kind++)
            compare_pair(kind, 1.5, n % 2 ? 3e-3 : 3e-2, &seed);
}

static int by_bytes(const void *a, const void *b) {
    return memcmp(a, b, sizeof(barrier_pair));
}

/* Pairs found among the candidates of an earlier search must be those of a new search. A wavy
 * sheet, a ball and a floor; vertices move at random. */
static void kept_candidates_miss_no_pair(void **state) {
    unsigned seed = 3;
    char error[256];
    collider bodies[2] = {
        {.kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .gap = 0.01},
        {.kind = COLLIDER_SPHERE, .position = {0.1, 0.1, 0.03}, .size = {0.02}, .gap = 0.01}};
    mesh m = cloth_sheet(6, 6, 0.04, 0.2, 3);
    scene s = cloth_scene();
    double mass[36], (*x)[3], (*way)[3];
    barrier kept, fresh;
    (void)state;
    s.self_collision.gap = 0.01;
    s.colliders = bodies;
    s.collider_count = 2;
    for (int i = 0; i < 36; i++) {
        mass[i] = 1e-3;
        m.position[i][2] = 0.055 + 0.03 * sin(60 * m.position[i][0]);
    }
    assert_int_equal(barrier_init(&kept, &m, &s, mass, error), 0);
    assert_int_equal(barrier_init(&fresh, &m, &s, mass, error), 0);
    fresh.margin = -1;
    x = kept.x;
    way = kept.displacement;
    memcpy(x, m.position, sizeof(double[36][3]));
    barrier_place_bodies(&kept, 0, x);
    int reused = 0, pairs = 0;
    for (int n = 0; n < 60; n++) {
        double before[3];
        memcpy(before, kept.searched[0], sizeof before);
        for (int i = 0; i < kept.surface.vertex_count; i++)
            for (int a = 0; a < 3; a++) {
                x[i][a] += i < 36 ? 0.2 * kept.margin * random_number(&seed) : 0;
                way[i][a] = i < 36 ? 0.5 * kept.margin * random_number(&seed) : 0;
            }
        assert_int_equal(barrier_find_pairs(&kept, read_only(x), read_only(way)), 0);
        assert_int_equal(barrier_find_pairs(&fresh, read_only(x), read_only(way)), 0);
        reused += memcmp(before, kept.searched[0], sizeof before) == 0;
        pairs += kept.list.pairs;
        assert_int_equal(kept.list.pairs, fresh.list.pairs);
        qsort(kept.list.pair, (size_t)kept.list.pairs, sizeof *kept.list.pair, by_bytes);
        qsort(fresh.list.pair, (size_t)fresh.list.pairs, sizeof *fresh.list.pair, by_bytes);
        assert_memory_equal(kept.list.pair, fresh.list.pair,
                            (size_t)kept.list.pairs * sizeof *kept.list.pair);
    }
    assert_in_range(reused, 20, 55);
    assert_true(pairs > 60 * 100);
    barrier_free(&kept);
    barrier_free(&fresh);
    cloth_free(&m);
}

/* Returns a sheet folded in two, with halves 6 mm apart: many pairs of edges are nearly
 * parallel. */
static mesh folded_sheet(void) {
    mesh m = cloth_sheet(6, 6, 0.04, 0.2, 3);
    for (int i = 0; i < m.vertex_count; i++) {
        const double x = m.position[i][0];
        m.position[i][0] = x < 0.1 ? x : 0.2 - x + 1e-4;
        m.position[i][2] = x < 0.1 ? 0 : 0.006;
    }
    return m;
}

/* Pairs that are near at the end of the way must be listed at its beginning. */
static void pairs_on_the_way_are_listed(void **state) {
    unsigned seed = 21;
    char error[256];
    double mass[36];
    mesh m = folded_sheet();
    scene s = cloth_scene();
    barrier from, to;
    int new_ones = 0;
    (void)state;
    s.self_collision.gap = 0.004;
    for (int i = 0; i < 36; i++)
        mass[i] = 1e-3;
    assert_int_equal(barrier_init(&from, &m, &s, mass, error), 0);
    assert_int_equal(barrier_init(&to, &m, &s, mass, error), 0);
    for (int n = 0; n < 20; n++) {
        for (int i = 0; i < 36; i++)
            for (int a = 0; a < 3; a++) {
                from.x[i][a] = m.position[i][a];
                from.displacement[i][a] = 0.008 * random_number(&seed);
                to.x[i][a] = from.x[i][a] + from.displacement[i][a];
            }
        assert_int_equal(barrier_find_pairs(&from, read_only(from.x), read_only(from.displacement)),
                         0);
        assert_int_equal(barrier_find_pairs(&to, read_only(to.x), NULL), 0);
        qsort(from.list.pair, (size_t)from.list.pairs, sizeof *from.list.pair, by_bytes);
        for (int k = 0; k < to.list.pairs; k++)
            assert_non_null(bsearch(&to.list.pair[k], from.list.pair, (size_t)from.list.pairs,
                                    sizeof *from.list.pair, by_bytes));
        new_ones += to.list.pairs;
        assert_int_equal(barrier_find_pairs(&from, read_only(from.x), NULL), 0);
        new_ones -= from.list.pairs;
    }
    assert_true(new_ones > 20);
    barrier_free(&from);
    barrier_free(&to);
    cloth_free(&m);
}

/* The system's matrix times y, and the right side, must be sums over the elements. */
static void systems_are_sums_of_elements(void **state) {
    enum { vertices = 36 };
    const double h = 0.01;
    unsigned seed = 9;
    char error[256];
    double mass[vertices], y[vertices][3], expected[vertices][3] = {{0}},
                                           found[vertices][3] = {{0}};
    mesh m = folded_sheet();
    scene s = cloth_scene();
    barrier b;
    barrier_system made;
    linear_system cloth;
    (void)state;
    s.self_collision.gap = 0.01;
    for (int i = 0; i < vertices; i++)
        mass[i] = 1e-3;
    const double none[vertices] = {0};
    const element_list triangles[1] = {{m.triangle_count, 3, &m.triangle[0][0]}};
    assert_int_equal(system_init(&cloth, vertices, 1, triangles), 0);
    system_reset(&cloth, none, none, h);
    assert_int_equal(barrier_init(&b, &m, &s, mass, error), 0);
    assert_int_equal(barrier_system_init(&made, &cloth.A, vertices), 0);
    for (int i = 0; i < vertices; i++)
        for (int a = 0; a < 3; a++) {
            b.x[i][a] = b.begin[i][a] = m.position[i][a] + 1e-3 * random_number(&seed);
            y[i][a] = random_number(&seed);
        }
    assert_int_equal(barrier_find_pairs(&b, read_only(b.x), NULL), 0);
    assert_int_equal(barrier_find_contacts(&b, read_only(b.x)), 0);
    assert_int_equal(barrier_make_elements(&b, h, read_only(b.x)), 0);
    int lower = 0;
    for (int n = 0; n < b.list.elements; n++) {
        const barrier_element *e = &b.list.element[n];
        for (int p = 0, k = 0; p < 4; p++)
            for (int q = p; q < 4; q++, k++) {
                const int i = e->vertex[p], j = e->vertex[q];
                lower += i > j;
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++) {
                        expected[i][r] += h * h * e->block[k][r][c] * y[j][c];
                        if (p != q)
                            expected[j][c] += h * h * e->block[k][r][c] * y[i][r];
                    }
            }
    }
    assert_int_equal(barrier_system_make(&made, &b, h, &cloth), 0);
    half_product(&made.all.A, read_only(y), found);
    assert_true(b.list.elements > 50 && lower > 50);
    double scale = 0;
    for (int i = 0; i < vertices; i++)
        scale = fmax(scale, vector_length(expected[i]));
    for (int i = 0; i < vertices; i++)
        for (int a = 0; a < 3; a++)
            assert_near(found[i][a], expected[i][a], 1e-12 * scale);
    barrier_system_free(&made);
    barrier_free(&b);
    system_free(&cloth);
    cloth_free(&m);
}

/* Takes the first crossing of edge 3 4 and ends the search. */
static int take_crossing(void *to, const barrier *b, const barrier_crossing *found) {
    (void)b;
    if (found->edge[0] + found->edge[1] != 7)
        return 0;
    *(barrier_crossing *)to = *found;
    return 1;
}

/* An edge passes through a triangle. One end is 1 mm beyond the triangle's plane, the other 5
 * mm. */
static void crossings_know_the_nearer_end(void **state) {
    static const double material[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {3, 0}, {2, 1}};
    static const int triangle[2][3] = {{0, 1, 2}, {3, 4, 5}};
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        char error[256];
        double mass[6] = {1, 1, 1, 1, 1, 1};
        mesh m = cloth_of(6, material, 2, triangle);
        scene s = cloth_scene();
        barrier b;
        barrier_crossing found = {.nearer = -1};
        s.self_collision.gap = 0.01;
        assert_int_equal(barrier_init(&b, &m, &s, mass, error), 0);
        const double above[3] = {0.2, 0.2, turned ? 0.005 : 0.001};
        const double below[3] = {0.2, 0.2, turned ? -0.001 : -0.005}, far[3] = {2, 2, 0.1};
        memcpy(b.x, m.position, sizeof(double[6][3]));
        memcpy(b.x[3], above, sizeof above);
        memcpy(b.x[4], below, sizeof below);
        memcpy(b.x[5], far, sizeof far);
        assert_int_equal(barrier_visit_crossings(&b, take_crossing, &found), 1);
        assert_near(found.depth, 1e-3, 1e-12);
        assert_near(b.x[found.edge[found.nearer]][2], turned ? -1e-3 : 1e-3, 1e-12);
        assert_near(found.normal[2], turned ? -1 : 1, 1e-12);
        barrier_free(&b);
        cloth_free(&m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nearest_points),
        cmocka_unit_test(parts_of_ways_do_not_pass),
        cmocka_unit_test(each_vertex_is_cut),
        cmocka_unit_test(many_ways_do_not_pass),
        cmocka_unit_test(parallel_edges_do_not_push),
        cmocka_unit_test(gradients_are_those_of_the_energy),
        cmocka_unit_test(kept_candidates_miss_no_pair),
        cmocka_unit_test(pairs_on_the_way_are_listed),
        cmocka_unit_test(crossings_know_the_nearer_end),
        cmocka_unit_test(systems_are_sums_of_elements),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
