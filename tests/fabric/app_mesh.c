/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Generated meshes, their edges and hinges, and orders of their vertices. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/mesh_parts.h"

static const uint64_t TABLECLOTH_HASH = 0x256c9cbf8cb3ed56u, PATCH_HASH = 0x502232c7b4da6f67u;

static mesh generate(int vertices, int boundary, unsigned seed) {
    mesh m;
    char error[256] = "";
    int non_manifold = -1;
    if (mesh_generate(&m, vertices, boundary, 1.0, seed, error) != 0)
        fail_msg("%s", error);
    assert_int_equal(mesh_connect(&m, &non_manifold, error), 0);
    assert_int_equal(non_manifold, 0);
    return m;
}

/* Checks Euler's formula, and that two ways to count the sides of triangles agree. */
static void check_counts(const mesh *m, int vertices, int boundary) {
    assert_int_equal(m->vertex_count, vertices);
    assert_int_equal(m->triangle_count, 2 * vertices - 2 - boundary);
    assert_int_equal(m->vertex_count - m->edge_count + m->triangle_count, 1);
    assert_int_equal(m->edge_count - m->hinge_count, boundary);
}

static void test_counts(void **unused) {
    static const int sizes[][2] = {{2602, 220}, {200, 48}, {5, 4}, {9, 8}, {30, 20}, {1000, 40}};
    (void)unused;
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
        for (unsigned seed = 0; seed < 20; seed++) {
            mesh m = generate(sizes[k][0], sizes[k][1], seed);
            check_counts(&m, sizes[k][0], sizes[k][1]);
            mesh_free(&m);
        }
}

/* The counts that the paper gives for its two meshes. */
static void test_counts_of_the_paper(void **unused) {
    (void)unused;
    mesh small = generate(2602, 220, 1), large = generate(218272, 1713, 1);
    assert_int_equal(small.triangle_count, 4982);
    assert_int_equal(large.vertex_count, 218272);
    assert_int_equal(large.edge_count, 653100);
    assert_int_equal(large.triangle_count, 434829);
    mesh_free(&small);
    mesh_free(&large);
}

static void test_bad_requests(void **unused) {
    mesh m;
    char error[256] = "";
    (void)unused;
    assert_int_equal(mesh_generate(&m, 10, 3, 1.0, 1, error), -1);
    assert_non_null(strstr(error, "not 3 of 10"));
    assert_int_equal(mesh_generate(&m, 10, 10, 1.0, 1, error), -1);
    assert_int_equal(mesh_generate(&m, 10, 5, 0.0, 1, error), -1);
    assert_null(m.position);
}

static double cross_of(const mesh *m, int a, int b, int c) {
    const double *p = m->material[a], *q = m->material[b], *r = m->material[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
}

/* Triangles are counter-clockwise and no slivers, and the boundary has exactly the points
 * requested. */
static void test_shape(void **unused) {
    (void)unused;
    mesh m = generate(2602, 220, 14);
    int on_border = 0, corners = 0;
    for (int v = 0; v < m.vertex_count; v++) {
        const int x = fabs(m.material[v][0]) == 0.5, y = fabs(m.material[v][1]) == 0.5;
        assert_true(fabs(m.material[v][0]) <= 0.5 && fabs(m.material[v][1]) <= 0.5);
        on_border += x || y;
        corners += x && y;
        assert_true(m.position[v][0] == m.material[v][0] && m.position[v][2] == 0.0);
    }
    assert_int_equal(on_border, 220);
    assert_int_equal(corners, 4);
    const double mean = 1.0 / m.triangle_count;
    for (int t = 0; t < m.triangle_count; t++) {
        const int *c = m.triangle[t];
        const double area = 0.5 * cross_of(&m, c[0], c[1], c[2]);
        assert_true(area > 0.3 * mean && area < 3.0 * mean);
    }
    mesh_free(&m);
}

/* Delaunay's condition: no vertex lies inside the circumcircle of a triangle, by comparing all with
 * all. */
static void test_delaunay(void **unused) {
    (void)unused;
    mesh m = generate(200, 48, 3);
    for (int t = 0; t < m.triangle_count; t++)
        for (int v = 0; v < m.vertex_count; v++) {
            double row[3][3];
            for (int k = 0; k < 3; k++) {
                const double *p = m.material[m.triangle[t][k]];
                row[k][0] = p[0] - m.material[v][0];
                row[k][1] = p[1] - m.material[v][1];
                row[k][2] = row[k][0] * row[k][0] + row[k][1] * row[k][1];
            }
            const double inside = row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
                                  row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
                                  row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0]);
            assert_true(inside < 1e-12);
        }
    mesh_free(&m);
}

/* FNV-1a over values, not over bytes in memory, so the result is the same in either byte order. */
static uint64_t mix(uint64_t hash, uint64_t value) {
    for (int k = 0; k < 64; k += 8)
        hash = (hash ^ (value >> k & 0xff)) * 0x100000001b3u;
    return hash;
}

static uint64_t hash_of(const mesh *m) {
    uint64_t hash = 0xcbf29ce484222325u, bits;
    for (int v = 0; v < m->vertex_count; v++)
        for (int k = 0; k < 2; k++) {
            memcpy(&bits, &m->material[v][k], sizeof bits);
            hash = mix(hash, bits);
        }
    for (int t = 0; t < m->triangle_count; t++)
        for (int k = 0; k < 3; k++)
            hash = mix(hash, (uint64_t)m->triangle[t][k]);
    return hash;
}

static uint64_t hash_generated(unsigned seed, int vertices, int boundary) {
    mesh m = generate(vertices, boundary, seed);
    const uint64_t hash = hash_of(&m);
    mesh_free(&m);
    return hash;
}

/* The meshes of the scenes have the same bits at every optimisation level. */
static void test_reproducible(void **unused) {
    (void)unused;
    assert_int_equal(hash_generated(14, 2602, 220), TABLECLOTH_HASH);
    assert_int_equal(hash_generated(3, 200, 48), PATCH_HASH);
    assert_int_not_equal(hash_generated(4, 200, 48), PATCH_HASH);
}

static int triangles_with(const mesh *m, int a, int b, int third[2]) {
    int count = 0;
    for (int t = 0; t < m->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int *c = m->triangle[t], p = c[k], q = c[(k + 1) % 3];
            if ((p == a && q == b) || (p == b && q == a)) {
                assert_true(count < 2);
                third[count++] = c[(k + 2) % 3];
            }
        }
    return count;
}

/* Compares each edge with all triangles. Wing 2 of a hinge is left of the edge, and wing 3
 * right. */
static void check_connections(const mesh *m) {
    int inner = 0;
    for (int e = 0; e < m->edge_count; e++) {
        int third[2];
        assert_true(m->edge[e][0] < m->edge[e][1]);
        const int count = triangles_with(m, m->edge[e][0], m->edge[e][1], third);
        assert_true(count >= 1);
        inner += count == 2;
    }
    assert_int_equal(inner, m->hinge_count);
    for (int h = 0; h < m->hinge_count; h++) {
        const int *x = m->hinge[h];
        int third[2];
        assert_int_equal(triangles_with(m, x[0], x[1], third), 2);
        assert_true((third[0] == x[2] && third[1] == x[3]) ||
                    (third[0] == x[3] && third[1] == x[2]));
        assert_true(cross_of(m, x[0], x[1], x[2]) > 0.0);
        assert_true(cross_of(m, x[0], x[1], x[3]) < 0.0);
    }
}

static void test_connect(void **unused) {
    (void)unused;
    mesh m = generate(200, 48, 3);
    check_connections(&m);
    mesh_free(&m);
}

/* Three triangles share an edge: the first two form the hinge, and the edge is counted as
 * non-manifold. */
static void test_non_manifold(void **unused) {
    (void)unused;
    double position[5][3] = {{0}}, material[5][2] = {{0, 0}, {1, 0}, {0, 1}, {0, -1}, {1, 1}};
    int triangle[3][3] = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, non_manifold;
    char error[256];
    mesh m = {.vertex_count = 5,
              .triangle_count = 3,
              .position = position,
              .material = material,
              .triangle = triangle};
    assert_int_equal(mesh_connect(&m, &non_manifold, error), 0);
    assert_int_equal(non_manifold, 1);
    assert_int_equal(m.edge_count, 7);
    assert_int_equal(m.hinge_count, 1);
    assert_memory_equal(m.hinge[0], ((int[4]){0, 1, 2, 3}), sizeof(int[4]));
    free(m.edge);
    free(m.hinge);
}

static int longest_span(const mesh *m) {
    int longest = 0;
    for (int e = 0; e < m->edge_count; e++) {
        const int span = abs(m->edge[e][1] - m->edge[e][0]);
        longest = span > longest ? span : longest;
    }
    return longest;
}

static int compare_ints(const void *a, const void *b) {
    const int first = *(const int *)a, second = *(const int *)b;
    return (first > second) - (first < second);
}

/* Returns a number that identifies three vertices in any order. */
static int64_t key_of(const int *triangle, const int *renamed) {
    int v[3];
    for (int k = 0; k < 3; k++)
        v[k] = renamed ? renamed[triangle[k]] : triangle[k];
    qsort(v, 3, sizeof *v, compare_ints);
    return ((int64_t)v[0] << 40) + ((int64_t)v[1] << 20) + v[2];
}

static int compare_keys(const void *a, const void *b) {
    const int64_t first = *(const int64_t *)a, second = *(const int64_t *)b;
    return (first > second) - (first < second);
}

static int64_t *sorted_keys(const mesh *m, const int *renamed) {
    int64_t *keys = malloc((size_t)m->triangle_count * sizeof *keys);
    assert_non_null(keys);
    for (int t = 0; t < m->triangle_count; t++)
        keys[t] = key_of(m->triangle[t], renamed);
    qsort(keys, (size_t)m->triangle_count, sizeof *keys, compare_keys);
    return keys;
}

/* Checks that the new mesh is the old one with renamed vertices. */
static void check_same_mesh(const mesh *old, const mesh *new, const int *new_of_old) {
    int64_t *expected = sorted_keys(old, new_of_old), *found = sorted_keys(new, NULL);
    assert_memory_equal(expected, found, (size_t)old->triangle_count * sizeof *found);
    free(expected);
    free(found);
    for (int v = 0; v < old->vertex_count; v++) {
        assert_memory_equal(old->position[v], new->position[new_of_old[v]], sizeof *old->position);
        assert_memory_equal(old->material[v], new->material[new_of_old[v]], sizeof *old->material);
    }
    for (int t = 0; t < new->triangle_count; t++)
        assert_true(cross_of(new, new->triangle[t][0], new->triangle[t][1], new->triangle[t][2]) >
                    0.0);
    check_connections(new);
}

static void check_order(mesh_order order) {
    mesh old = generate(200, 48, 3), new = generate(200, 48, 3);
    int new_of_old[200];
    char seen[200] = {0}, error[256];
    assert_int_equal(mesh_reorder(&new, order, 7, new_of_old, error), 0);
    for (int v = 0; v < 200; v++) {
        assert_true(new_of_old[v] >= 0 && new_of_old[v] < 200 && !seen[new_of_old[v]]);
        seen[new_of_old[v]] = 1;
    }
    check_same_mesh(&old, &new, new_of_old);
    mesh_free(&old);
    mesh_free(&new);
}

static void test_orders_keep_the_mesh(void **unused) {
    (void)unused;
    check_order(MESH_ORDER_GENERATED);
    check_order(MESH_ORDER_SORTED);
    check_order(MESH_ORDER_SHUFFLED);
    check_order(MESH_ORDER_HILBERT);
#ifdef FABRIC_WITH_METIS
    check_order(MESH_ORDER_DISSECTED);
#endif
}

/* mesh_renumber undoes each order. It refuses an array that is no permutation, and then changes
 * nothing. */
static void test_orders_are_undone(void **unused) {
    (void)unused;
    char error[256];
    static const mesh_order orders[] = {MESH_ORDER_SORTED, MESH_ORDER_SHUFFLED, MESH_ORDER_HILBERT};
    for (int k = 0; k < 3; k++) {
        mesh old = generate(200, 48, 3), new = generate(200, 48, 3);
        int new_of_old[200];
        mesh_sort_triangles(&old);
        assert_int_equal(mesh_reorder(&new, orders[k], 7, new_of_old, error), 0);
        assert_int_equal(mesh_renumber(&new, new_of_old, 1, error), 0);
        assert_memory_equal(old.position, new.position, 200 * sizeof *new.position);
        assert_memory_equal(old.triangle, new.triangle,
                            (size_t) new.triangle_count * sizeof *new.triangle);
        check_connections(&new);
        const int kept = new_of_old[5];
        new_of_old[5] = new_of_old[6];
        assert_int_equal(mesh_renumber(&new, new_of_old, 0, error), -1);
        assert_non_null(strstr(error, "no permutation"));
        new_of_old[5] = 200;
        assert_int_equal(mesh_renumber(&new, new_of_old, 1, error), -1);
        assert_memory_equal(old.position, new.position, 200 * sizeof *new.position);
        new_of_old[5] = kept;
        assert_int_equal(mesh_renumber(&new, new_of_old, 0, error), 0);
        assert_int_equal(mesh_renumber(&new, new_of_old, 1, error), 0);
        assert_memory_equal(old.position, new.position, 200 * sizeof *new.position);
        mesh_free(&old);
        mesh_free(&new);
    }
}

/* The points of a grid of 2^n * 2^n points: each must be a neighbour of its predecessor in the
 * order. */
static void test_curve_goes_from_neighbour_to_neighbour(void **unused) {
    (void)unused;
    enum { SIDE = 32, COUNT = SIDE * SIDE };
    static double material[COUNT][2];
    static int new_of_old[COUNT], old_of_new[COUNT];
    const mesh m = {.vertex_count = COUNT, .material = material};
    for (int v = 0; v < COUNT; v++) {
        material[v][0] = 3.0 + v % SIDE;
        material[v][1] = v / SIDE - 7.0;
    }
    assert_int_equal(mesh_order_by_curve(&m, new_of_old), 0);
    for (int v = 0; v < COUNT; v++)
        old_of_new[new_of_old[v]] = v;
    for (int i = 1; i < COUNT; i++) {
        const double *p = material[old_of_new[i - 1]], *q = material[old_of_new[i]];
        assert_true(fabs(p[0] - q[0]) + fabs(p[1] - q[1]) < 1.5);
    }
}

/* Coordinates that are no finite numbers must still give some order. */
static void test_curve_of_what_is_no_number(void **unused) {
    (void)unused;
    double material[3][2] = {{NAN, 1.0}, {INFINITY, 0.0}, {0.0, -INFINITY}};
    int new_of_old[3], sum = 0;
    const mesh m = {.vertex_count = 3, .material = material};
    assert_int_equal(mesh_order_by_curve(&m, new_of_old), 0);
    for (int v = 0; v < 3; v++)
        sum += 1 << new_of_old[v];
    assert_int_equal(sum, 7);
}

static void test_dissection_is_there_or_says_why_not(void **unused) {
    (void)unused;
    char error[256] = "";
    mesh m = generate(2602, 220, 14);
    const int status = mesh_reorder(&m, MESH_ORDER_DISSECTED, 1, NULL, error);
#ifdef FABRIC_WITH_METIS
    assert_int_equal(status, 0);
    int crossing = 0; /* vertices are in two halves and a separator: few edges connect the halves */
    for (int e = 0; e < m.edge_count; e++)
        crossing += m.edge[e][0] < 1100 && m.edge[e][1] >= 1500;
    assert_true(crossing < m.edge_count / 8);
#else
    assert_int_equal(status, -1);
    assert_non_null(strstr(error, "METIS"));
#endif
    mesh_free(&m);
}

static void test_orders_move_neighbours(void **unused) {
    (void)unused;
    char error[256];
    mesh m = generate(2602, 220, 14);
    assert_int_equal(mesh_reorder(&m, MESH_ORDER_SHUFFLED, 1, NULL, error), 0);
    assert_true(longest_span(&m) > 2000);
    assert_int_equal(mesh_reorder(&m, MESH_ORDER_SORTED, 1, NULL, error), 0);
    assert_true(longest_span(&m) < 110); /* the square root of 2602 is 51 */
    for (int t = 1; t < m.triangle_count; t++)
        assert_true(m.triangle[t - 1][0] <= m.triangle[t][0]);
    for (int e = 1; e < m.edge_count; e++)
        assert_true(m.edge[e - 1][0] <= m.edge[e][0]);
    for (int h = 1; h < m.hinge_count; h++)
        assert_true(m.hinge[h - 1][0] <= m.hinge[h][0]);
    mesh_free(&m);
}

/* A mesh in two parts, and a vertex without triangles. */
static void test_sort_of_parts(void **unused) {
    (void)unused;
    mesh m = {.vertex_count = 7, .triangle_count = 2};
    int new_of_old[7], sum = 0;
    char error[256];
    m.position = calloc(7, sizeof *m.position);
    m.material = calloc(7, sizeof *m.material);
    m.triangle = calloc(2, sizeof *m.triangle);
    assert_true(m.position && m.material && m.triangle);
    memcpy(m.triangle, ((int[2][3]){{0, 2, 4}, {1, 3, 5}}), 2 * sizeof *m.triangle);
    assert_int_equal(mesh_reorder(&m, MESH_ORDER_SORTED, 1, new_of_old, error), 0);
    for (int v = 0; v < 7; v++)
        sum += new_of_old[v];
    assert_int_equal(sum, 21);
    mesh_free(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counts),
        cmocka_unit_test(test_counts_of_the_paper),
        cmocka_unit_test(test_bad_requests),
        cmocka_unit_test(test_shape),
        cmocka_unit_test(test_delaunay),
        cmocka_unit_test(test_reproducible),
        cmocka_unit_test(test_connect),
        cmocka_unit_test(test_non_manifold),
        cmocka_unit_test(test_orders_keep_the_mesh),
        cmocka_unit_test(test_orders_are_undone),
        cmocka_unit_test(test_curve_goes_from_neighbour_to_neighbour),
        cmocka_unit_test(test_curve_of_what_is_no_number),
        cmocka_unit_test(test_dissection_is_there_or_says_why_not),
        cmocka_unit_test(test_orders_move_neighbours),
        cmocka_unit_test(test_sort_of_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
