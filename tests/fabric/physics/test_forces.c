/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Forces and their derivatives are compared with differences of the energies, and must satisfy
 * laws that hold for any energy. Numbers such as S01 refer to docs/fabric-hard-cases.md. */
#include "check.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "cloth.h"
#include "dense.h"
#include "effects/drag.h"
#include "effects/hinge.h"
#include "effects/triangle.h"

/* A cloth with one material, and the system that its forces enter. */
typedef struct bench {
    mesh m;
    int n;
    triangle_elements triangles;
    hinge_elements hinges;
    linear_system system;
    triangle_material triangle;
    hinge_material hinge;
    double drag;
    double *no_mass;
    double (*rest)[3]; /* velocity 0 */
} bench;

static bench bench_of(mesh m) {
    bench b = {.m = m, .n = m.vertex_count};
    assert_int_equal(triangle_elements_init(&b.triangles, &m), 0);
    assert_int_equal(hinge_elements_init(&b.hinges, &m), 0);
    assert_int_equal(hinge_elements_cache_angles(&b.hinges), 0);
    const element_list lists[2] = {{b.triangles.count, 3, &b.triangles.vertex[0][0]},
                                   {b.hinges.count, 4, &b.hinges.vertex[0][0]}};
    assert_int_equal(system_init(&b.system, b.n, 2, lists), 0);
    assert_int_equal(triangle_elements_place(&b.triangles, &b.system.A), 0);
    assert_int_equal(hinge_elements_place(&b.hinges, &b.system.A), 0);
    b.no_mass = calloc((size_t)b.n, sizeof *b.no_mass);
    b.rest = calloc((size_t)b.n, sizeof *b.rest);
    return b;
}

static bench bench_sheet(void) {
    return bench_of(cloth_sheet(5, 4, 0.1, 0.3, 7));
}

static void bench_end(bench *b) {
    triangle_elements_free(&b->triangles);
    hinge_elements_free(&b->hinges);
    system_free(&b->system);
    cloth_free(&b->m);
    free(b->no_mass);
    free(b->rest);
}

static const double (*constant(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

/* Computes A and b of the elements alone. */
static void assemble(bench *b, double h, double (*x)[3], double (*v)[3]) {
    const double none[3] = {0, 0, 0};
    system_reset(&b->system, b->no_mass, none, h);
    triangle_forces(&b->triangles, &b->triangle, h, constant(x), constant(v), &b->system);
    hinge_update_angles(&b->hinges, constant(x));
    hinge_forces(&b->hinges, &b->hinge, h, constant(x), constant(v), &b->system);
    if (b->drag > 0)
        drag_forces(&b->triangles, DRAG_ACROSS, b->drag, none, h, constant(x), constant(v),
                    &b->system);
}

static double energy(bench *b, double (*x)[3]) {
    double stretch, shear;
    triangle_energies(&b->triangles, &b->triangle, constant(x), &stretch, &shear);
    hinge_update_angles(&b->hinges, constant(x));
    return stretch + shear + hinge_energy(&b->hinges, &b->hinge);
}

static double largest(const double *a, int n) {
    double most = 0;
    for (int i = 0; i < n; i++)
        if (fabs(a[i]) > most)
            most = fabs(a[i]);
    return most;
}

/* Returns max |f + dE/dx| / max |f| by central differences. */
static double force_error(bench *b, double (*x)[3]) {
    const double d = 1e-6;
    double worst = 0;
    assemble(b, 1, x, b->rest);
    double *f = malloc(sizeof *b->system.b * (size_t)b->n);
    memcpy(f, b->system.b, sizeof *b->system.b * (size_t)b->n);
    for (int k = 0; k < 3 * b->n; k++) {
        double *at = &x[0][0] + k;
        const double was = *at;
        *at = was + d;
        const double up = energy(b, x);
        *at = was - d;
        const double down = energy(b, x);
        *at = was;
        worst = fmax(worst, fabs(f[k] + (up - down) / (2 * d)));
    }
    const double size = largest(f, 3 * b->n);
    free(f);
    assert_true(size > 0);
    return worst / size;
}

/* S01, for each effect alone: the force is the energy's gradient. */
static void S01_forces_are_gradients(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 0.01, 5);
    b.triangle = (triangle_material){.stretch = 500};
    assert_below(force_error(&b, x), 1e-6);
    b.triangle = (triangle_material){.shear = 50};
    assert_below(force_error(&b, x), 1e-6);
    b.triangle = (triangle_material){0};
    b.hinge.bend = 2e-4;
    assert_below(force_error(&b, x), 1e-6);
    free(x);
    bench_end(&b);
}

/* Returns max |A_FD - A| / max |A|, where A_FD = -h^2 df/dx - h df/dv comes from differences of b
 * at v = 0, where b = h f. If `of_velocity`, differentiates by v instead, where b = h f(v). */
static double jacobian_error(bench *b, double (*x)[3], int of_velocity) {
    const int n = 3 * b->n;
    const double h = 1, d = 1e-6;
    assemble(b, h, x, b->rest);
    double *a = dense_of(&b->system.A);
    double *up = malloc(sizeof *up * (size_t)n);
    double(*v)[3] = calloc((size_t)b->n, sizeof *v);
    double worst = 0;
    for (int k = 0; k < n; k++) {
        double *at = of_velocity ? &v[0][0] + k : &x[0][0] + k;
        const double was = *at;
        *at = was + d;
        assemble(b, h, x, v);
        memcpy(up, b->system.b, sizeof *up * (size_t)n);
        *at = was - d;
        assemble(b, h, x, v);
        *at = was;
        for (int i = 0; i < n; i++) {
            const double slope = -(up[i] - (&b->system.b[0][0])[i]) / (2 * d);
            worst = fmax(worst, fabs(slope - a[i * n + k]));
        }
    }
    const double size = largest(a, n * n);
    free(a);
    free(up);
    free(v);
    return worst / size;
}

/* Returns positions in which every triangle is longer than at rest, in u and v. */
static double (*stretched(const mesh *m, double noise))[3] {
    double(*x)[3] = cloth_moved(m, noise, 11);
    for (int i = 0; i < m->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            x[i][a] *= 1.3;
    return x;
}

/* S02: the derivatives of stretch in tension, of shear without shear strain, of bending of a flat
 * cloth and of all damping are exact. */
static void S02_derivatives_are_exact(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = stretched(&b.m, 0.002);
    b.triangle = (triangle_material){.stretch = 500};
    assert_below(jacobian_error(&b, x, 0), 1e-6);
    b.triangle = (triangle_material){.stretch = 500, .shear = 50};
    b.hinge.bend = 2e-4;
    assert_below(jacobian_error(&b, b.m.position, 0), 1e-6);
    b.triangle = (triangle_material){.stretch_damping = 2, .shear_damping = 1};
    b.hinge = (hinge_material){.bend_damping = 1e-3};
    b.drag = 0.3;
    assert_below(jacobian_error(&b, x, 1), 1e-6);
    free(x);
    bench_end(&b);
}

/* b contains -(h^2 K) v in addition to h f: the term h^2 df/dx v of equation 4, with the matrix of
 * A. */
static void test_right_side_looks_ahead(void **state) {
    (void)state;
    bench b = bench_sheet();
    const int n = 3 * b.n;
    const double h = 0.02;
    double(*x)[3] = cloth_moved(&b.m, 0.01, 5);
    double(*v)[3] = cloth_moved(&b.m, 0.7, 6);
    b.triangle = (triangle_material){500, 50, 1, 0.3};
    b.hinge = (hinge_material){2e-4, 1e-5};
    assemble(&b, h, x, b.rest);
    double *still = malloc(sizeof *still * (size_t)n);
    memcpy(still, b.system.b, sizeof *still * (size_t)n);
    assemble(&b, h, x, v);
    double *a = dense_of(&b.system.A);
    const double *moving = &b.system.b[0][0];
    for (int i = 0; i < n; i++) {
        double expected = still[i];
        for (int k = 0; k < n; k++)
            expected -= a[i * n + k] * (&v[0][0])[k];
        assert_near(moving[i], expected, 1e-10 * largest(still, n) + 1e-12 * largest(moving, n));
    }
    free(still);
    free(a);
    free(x);
    free(v);
    bench_end(&b);
}

/* S03: half of a symmetric matrix is stored, so A is symmetric if its diagonal blocks are. */
static void S03_diagonal_blocks_are_symmetric(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 0.02, 3);
    double(*v)[3] = cloth_moved(&b.m, 1, 4);
    b.triangle = (triangle_material){500, 50, 1, 0.3};
    b.hinge = (hinge_material){2e-4, 1e-5};
    b.drag = 0.2;
    assemble(&b, 0.033, x, v);
    for (int i = 0; i < b.n; i++) {
        const double(*block)[3] = (const double(*)[3])b.system.A.value[b.system.A.row_start[i]];
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                assert_true(block[r][c] == block[c][r]);
    }
    free(x);
    free(v);
    bench_end(&b);
}

/* S04: rotations by 0.7 and 0.4, and translation by up to 1e6 m, cause no forces. */
static void S04_rigid_motion_makes_no_force(void **state) {
    (void)state;
    const double shift[3] = {0, 1e3, 1e6}, tolerance[3] = {1e-9, 1e-9, 1e-6};
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 0, 1);
    b.triangle = (triangle_material){500, 50, 0, 0};
    b.hinge = (hinge_material){2e-4, 0};
    for (int s = 0; s < 3; s++) {
        for (int i = 0; i < b.n; i++) {
            const double *p = b.m.position[i];
            x[i][0] = cos(0.7) * p[0] - sin(0.7) * p[1] + shift[s];
            x[i][1] = cos(0.4) * (sin(0.7) * p[0] + cos(0.7) * p[1]) - shift[s];
            x[i][2] = sin(0.4) * (sin(0.7) * p[0] + cos(0.7) * p[1]) + shift[s];
        }
        assemble(&b, 1, x, b.rest);
        assert_below(largest(&b.system.b[0][0], 3 * b.n) / (500 * 0.1), tolerance[s]);
    }
    free(x);
    bench_end(&b);
}

/* S05: the forces of the cloth's parts on each other sum to 0, and so do their torques. */
static void S05_no_net_force_nor_torque(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 0.02, 3);
    double force[3] = {0, 0, 0}, torque[3] = {0, 0, 0}, sum = 0;
    b.triangle = (triangle_material){500, 50, 0, 0};
    b.hinge = (hinge_material){2e-4, 0};
    assemble(&b, 1, x, b.rest);
    for (int i = 0; i < b.n; i++)
        for (int a = 0; a < 3; a++) {
            const int c = (a + 1) % 3, d = (a + 2) % 3;
            force[a] += b.system.b[i][a];
            torque[a] += x[i][c] * b.system.b[i][d] - x[i][d] * b.system.b[i][c];
            sum += fabs(b.system.b[i][a]);
        }
    assert_below(largest(force, 3) / sum, 1e-14);
    assert_below(largest(torque, 3) / sum, 1e-14);
    free(x);
    bench_end(&b);
}

/* Is A plus the least mass positive definite? */
static int is_semidefinite(bench *b, double (*x)[3], double h) {
    assemble(b, h, x, b->rest);
    double *a = dense_of(&b->system.A);
    const int n = 3 * b->n;
    const double least = 1e-12 * largest(a, n * n);
    for (int i = 0; i < n; i++)
        a[i * n + i] += least;
    const int failed = dense_cholesky(a, n);
    free(a);
    return !failed;
}

/* S09: under compression A is positive semidefinite, although the exact derivative of the forces is
 * indefinite. */
static void S09_matrix_is_semidefinite_under_compression(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 0.01, 9);
    for (int i = 0; i < b.n; i++)
        x[i][0] *= 0.8;
    b.triangle = (triangle_material){500, 50, 1, 0.3};
    b.hinge = (hinge_material){2e-4, 1e-5};
    assert_true(is_semidefinite(&b, x, 0.033));
    b.triangle = (triangle_material){.stretch = 500};
    b.hinge = (hinge_material){0};
    assert_true(is_semidefinite(&b, x, 0.033));

    const int n = 3 * b.n;
    const double d = 1e-6;
    double *exact = calloc((size_t)n * (size_t)n, sizeof *exact);
    for (int k = 0; k < n; k++) {
        double *at = &x[0][0] + k;
        const double was = *at;
        for (int side = -1; side <= 1; side += 2) {
            *at = was + side * d;
            assemble(&b, 1, x, b.rest);
            for (int i = 0; i < n; i++)
                exact[i * n + k] -= side * (&b.system.b[0][0])[i] / (2 * d);
        }
        *at = was;
    }
    for (int i = 0; i < n; i++)
        exact[i * n + i] += 1e-3; /* far more than the least mass above */
    assert_true(dense_cholesky(exact, n) != 0);
    free(exact);
    free(x);
    bench_end(&b);
}

static void assert_finite(const bench *b) {
    for (int i = 0; i < 3 * b->n; i++)
        assert_true(isfinite((&b->system.b[0][0])[i]));
    for (int k = 0; k < 9 * b->system.A.block_count; k++)
        assert_true(isfinite((&b->system.A.value[0][0][0])[k]));
}

/* S10: cloth collapsed to a line or a point has finite forces, up to a bound, and a finite matrix.
 */
static void S10_collapsed_cloth_is_finite(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 0, 1);
    b.triangle = (triangle_material){500, 50, 1, 0.3};
    b.hinge = (hinge_material){2e-4, 1e-5};
    b.drag = 0.2;
    for (int to_point = 0; to_point < 2; to_point++) {
        for (int i = 0; i < b.n; i++) {
            x[i][1] = x[i][2] = 0;
            x[i][0] = to_point ? 0 : x[i][0];
        }
        assemble(&b, 0.033, x, b.rest);
        assert_finite(&b);
        assert_true(largest(&b.system.b[0][0], 3 * b.n) > 0);
        assert_below(largest(&b.system.b[0][0], 3 * b.n), 0.033 * 500 * 0.1 * 10);
    }
    free(x);
    bench_end(&b);
}

static bench bench_hinge(void) {
    const double material[4][2] = {{0, 0}, {0, 1}, {1, 0.5}, {-1, 0.5}};
    const int triangle[2][3] = {{0, 2, 1}, {0, 1, 3}};
    bench b = bench_of(cloth_of(4, material, 2, triangle));
    assert_int_equal(b.hinges.count, 1);
    b.hinge.bend = 1;
    return b;
}

/* S14: folded beyond 180 degrees, the angle continues to grow, and with it energy and force. */
static void S14_angle_goes_on_past_the_fold(void **state) {
    (void)state;
    bench b = bench_hinge();
    double(*x)[3] = cloth_moved(&b.m, 0, 1);
    const double pi = acos(-1), step = pi / 180;
    double sign = 0;
    for (int degree = 1; degree <= 350; degree++) {
        x[2][0] = cos(degree * step);
        x[2][2] = sin(degree * step);
        assemble(&b, 1, x, b.rest);
        assert_finite(&b);
        if (degree == 1)
            sign = b.hinges.angle[0] > 0 ? 1 : -1;
        assert_near(b.hinges.angle[0], sign * degree * step, 1e-9);
        const double expected = 3.0 / 1.0 * (degree * step) * (degree * step) / 2;
        assert_near(hinge_energy(&b.hinges, &b.hinge), expected, 1e-8);
    }
    free(x);
    bench_end(&b);
}

/* Angles computed for the energy are reused at the same positions, also beyond the fold, and only
 * there. */
static void test_angles_of_the_energy_are_kept(void **state) {
    (void)state;
    bench b = bench_hinge();
    double(*x)[3] = cloth_moved(&b.m, 0, 1);
    const double step = acos(-1) / 180;
    double angle[351];
    for (int degree = 1; degree <= 350; degree++) {
        x[2][0] = cos(degree * step);
        x[2][2] = sin(degree * step);
        hinge_update_angles(&b.hinges, (const double(*)[3])x);
        angle[degree] = b.hinges.angle[0];
    }
    for (int degree = 349; degree >= 1; degree--) {
        x[2][0] = cos(degree * step);
        x[2][2] = sin(degree * step);
        const double ahead = hinge_energy_at(&b.hinges, &b.hinge, (const double(*)[3])x);
        assert_true(b.hinges.angle[0] == angle[degree + 1]);
        if (degree % 3 == 0) { /* angles of other positions are not reused */
            x[2][0] = cos(degree * step + 1e-6);
            x[2][2] = sin(degree * step + 1e-6);
            hinge_update_angles(&b.hinges, (const double(*)[3])x);
            assert_true(b.hinges.angle[0] != angle[degree]);
            x[2][0] = cos(degree * step);
            x[2][2] = sin(degree * step);
        }
        hinge_update_angles(&b.hinges, (const double(*)[3])x);
        assert_true(b.hinges.angle[0] == angle[degree]);
        assert_true(hinge_energy(&b.hinges, &b.hinge) == ahead);
    }
    free(x);
    bench_end(&b);
}

/* S15: the forces of a flat hinge are as small as the displacements of its vertices. */
static void S15_flat_hinge_has_no_noise(void **state) {
    (void)state;
    bench b = bench_sheet();
    double(*x)[3] = cloth_moved(&b.m, 1e-12, 2);
    b.hinge.bend = 1;
    assemble(&b, 1, x, b.rest);
    assert_below(largest(&b.system.b[0][0], 3 * b.n), 1e-12 * 1e3 / 0.1 / 0.1);
    free(x);
    bench_end(&b);
}

/* S16: a hinge with a vertex on the edge that its triangles share, or with an edge of length 0. */
static void S16_collapsed_hinge_is_finite(void **state) {
    (void)state;
    bench b = bench_hinge();
    double(*x)[3] = cloth_moved(&b.m, 0, 1);
    x[2][0] = 0;
    x[2][2] = 1e-9;
    assemble(&b, 1, x, b.rest);
    assert_finite(&b);
    const double pi = acos(-1);
    assert_below(largest(&b.system.b[0][0], 12), 3 * pi * 1e3 * 1.01);
    x[2][2] = 0;
    assemble(&b, 1, x, b.rest);
    assert_finite(&b);
    memcpy(x[1], x[0], sizeof x[1]);
    assemble(&b, 1, x, b.rest);
    assert_finite(&b);
    for (int i = 0; i < 12; i++)
        assert_true((&b.system.b[0][0])[i] == 0);
    free(x);
    bench_end(&b);
}

/* S12: a triangle without area is left out, but a sliver is not. */
static void S12_triangles_without_area_are_left_out(void **state) {
    (void)state;
    const double material[5][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {0.5, -1e-2}};
    const int triangle[3][3] = {{0, 1, 2}, {0, 3, 1}, {0, 4, 1}};
    bench b = bench_of(cloth_of(5, material, 3, triangle));
    assert_int_equal(b.triangles.count, 2);
    b.triangle = (triangle_material){500, 50, 1, 1};
    assemble(&b, 1, b.m.position, b.rest);
    assert_finite(&b);
    bench_end(&b);
}

/* The force on a square metre is drag x area x the wind's speed perpendicular to it, here 2 m/s. */
static void test_drag_is_force_per_area(void **state) {
    (void)state;
    const double material[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const int triangle[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const double none[3] = {0, 0, 0}, wind[3] = {5, 0, 2};
    bench b = bench_of(cloth_of(4, material, 2, triangle));
    double sum[3] = {0, 0, 0};
    system_reset(&b.system, b.no_mass, none, 0.5);
    drag_forces(&b.triangles, DRAG_ACROSS, 0.3, wind, 0.5, constant(b.m.position), constant(b.rest),
                &b.system);
    for (int i = 0; i < 4; i++)
        for (int a = 0; a < 3; a++)
            sum[a] += b.system.b[i][a];
    assert_near(sum[0], 0, 1e-15);
    assert_near(sum[1], 0, 1e-15);
    assert_near(sum[2], 0.5 * 0.3 * 2, 1e-15);
    bench_end(&b);
}

/* With one coefficient across and along the cloth, drag is the same in all directions, on a sheet
 * of any slope. Force and derivative are those of each vertex's share of the area. */
static void test_drag_along_makes_it_whole(void **state) {
    (void)state;
    const double none[3] = {0, 0, 0}, wind[3] = {3, -1, 2}, h = 0.5, drag = 0.3;
    bench b = bench_sheet();
    double(*v)[3] = cloth_moved(&b.m, 1, 5), *area = calloc((size_t)b.n, sizeof *area);
    for (int i = 0; i < b.n; i++) {
        b.m.position[i][2] = 0.8 * b.m.position[i][0] - 0.3 * b.m.position[i][1];
        area[i] = 0;
    }
    for (int t = 0; t < b.m.triangle_count; t++) {
        double one[3], other[3], cross[3];
        const int *k = b.m.triangle[t];
        vector_subtract(b.m.position[k[1]], b.m.position[k[0]], one);
        vector_subtract(b.m.position[k[2]], b.m.position[k[0]], other);
        vector_cross(one, other, cross);
        for (int p = 0; p < 3; p++)
            area[k[p]] += vector_length(cross) / 6;
    }
    system_reset(&b.system, b.no_mass, none, h);
    double work = 0, found = 0;
    for (int k = DRAG_ACROSS; k <= DRAG_ALONG; k++) {
        const drag_kind kind = (drag_kind)k;
        drag_forces(&b.triangles, kind, drag, wind, h, constant(b.m.position), constant(v),
                    &b.system);
        found += drag_work(&b.triangles, kind, drag, wind, h, constant(b.m.position), constant(v));
    }
    for (int i = 0; i < b.n; i++)
        for (int r = 0; r < 3; r++) {
            const double force = h * drag * area[i] * (wind[r] - v[i][r]);
            const double *row = b.system.A.value[b.system.A.row_start[i]][r];
            assert_near(b.system.b[i][r], force, 1e-15);
            for (int c = 0; c < 3; c++)
                assert_near(row[c], r == c ? h * drag * area[i] : 0, 1e-16);
            work += force * v[i][r];
        }
    assert_near(found, work, 1e-14);
    free(v);
    free(area);
    bench_end(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S01_forces_are_gradients),
        cmocka_unit_test(S02_derivatives_are_exact),
        cmocka_unit_test(test_right_side_looks_ahead),
        cmocka_unit_test(S03_diagonal_blocks_are_symmetric),
        cmocka_unit_test(S04_rigid_motion_makes_no_force),
        cmocka_unit_test(S05_no_net_force_nor_torque),
        cmocka_unit_test(S09_matrix_is_semidefinite_under_compression),
        cmocka_unit_test(S10_collapsed_cloth_is_finite),
        cmocka_unit_test(S14_angle_goes_on_past_the_fold),
        cmocka_unit_test(test_angles_of_the_energy_are_kept),
        cmocka_unit_test(S15_flat_hinge_has_no_noise),
        cmocka_unit_test(S16_collapsed_hinge_is_finite),
        cmocka_unit_test(S12_triangles_without_area_are_left_out),
        cmocka_unit_test(test_drag_is_force_per_area),
        cmocka_unit_test(test_drag_along_makes_it_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
