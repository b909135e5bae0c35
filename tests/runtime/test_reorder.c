/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Orders of rows, points and iterations (redcc/reorder.h). */
#include "redcc/reorder.h"

#include "base/memory.h"
#include "problem.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 40, NODES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1) };

static void expect_permutation(const int *new_of_old, int count) {
    char *taken = calloc((size_t)count + 1, 1);
    for (int i = 0; i < count; i++) {
        assert_in_range(new_of_old[i], 0, count - 1);
        assert_false(taken[new_of_old[i]]);
        taken[new_of_old[i]] = 1;
    }
    free(taken);
}

/* Makes a sheet of triangles whose nodes are numbered at random. */
static void make_sheet(int triangle[TRIANGLES][3]) {
    static int number[NODES];
    unsigned long random = 88172645463325252u;
    for (int i = 0; i < NODES; i++)
        number[i] = i;
    for (int i = NODES - 1; i > 0; i--) {
        const int j = (int)(next_random(&random) % (unsigned long)(i + 1)), other = number[i];
        number[i] = number[j];
        number[j] = other;
    }
    for (int t = 0; t < TRIANGLES; t++) {
        const int square = t / 2, here = square / (SIDE - 1) * SIDE + square % (SIDE - 1);
        triangle[t][0] = number[here];
        triangle[t][1] = number[t % 2 ? here + SIDE + 1 : here + 1];
        triangle[t][2] = number[t % 2 ? here + SIDE : here + SIDE + 1];
    }
}

static int widest(int triangle[TRIANGLES][3], const int *new_of_old) {
    int most = 0;
    for (int t = 0; t < TRIANGLES; t++)
        for (int k = 0; k < 3; k++) {
            const int apart =
                abs(new_of_old[triangle[t][k]] - new_of_old[triangle[t][(k + 1) % 3]]);
            most = apart > most ? apart : most;
        }
    return most;
}

static void rows_of_an_iteration_come_close(void **unused) {
    (void)unused;
    static int triangle[TRIANGLES][3], new_of_old[NODES + 3];
    make_sheet(triangle);
    assert_int_equal(redcc_reorder_rows(TRIANGLES, 3, triangle[0], NODES, new_of_old), 0);
    expect_permutation(new_of_old, NODES);
    assert_true(widest(triangle, new_of_old) <= 2 * SIDE);
    /* rows that nothing updates get a place as well */
    assert_int_equal(redcc_reorder_rows(TRIANGLES, 3, triangle[0], NODES + 3, new_of_old), 0);
    expect_permutation(new_of_old, NODES + 3);
    assert_int_equal(redcc_reorder_rows(0, 3, triangle[0], NODES, new_of_old), 0);
    expect_permutation(new_of_old, NODES);
    assert_int_equal(redcc_reorder_rows(TRIANGLES, 3, triangle[0], NODES - 1, new_of_old), -1);
    assert_int_equal(redcc_reorder_rows(-1, 3, triangle[0], NODES, new_of_old), -1);
    assert_int_equal(redcc_memory_live(), 0);
}

/* All cells of a square or cubic grid with 2^n cells per side: each must be a neighbour of the cell
 * before it in the order. */
static void expect_neighbours(int side, int dimensions) {
    const int count = dimensions == 2 ? side * side : side * side * side;
    double *point = malloc((size_t)count * (size_t)dimensions * sizeof *point);
    int *new_of_old = malloc((size_t)count * sizeof(int)),
        *old_of_new = malloc((size_t)count * sizeof(int));
    for (int p = 0; p < count; p++)
        for (int i = 0, rest = p; i < dimensions; i++, rest /= side)
            point[p * dimensions + i] = 3.5 * (rest % side) - 20;
    assert_int_equal(redcc_reorder_points(count, dimensions, point, new_of_old), 0);
    expect_permutation(new_of_old, count);
    for (int p = 0; p < count; p++)
        old_of_new[new_of_old[p]] = p;
    for (int n = 1; n < count; n++) {
        double apart = 0;
        for (int i = 0; i < dimensions; i++)
            apart += fabs(point[old_of_new[n] * dimensions + i] -
                          point[old_of_new[n - 1] * dimensions + i]);
        assert_true(fabs(apart - 3.5) < 1e-9);
    }
    free(point);
    free(new_of_old);
    free(old_of_new);
}

static void a_curve_goes_from_neighbour_to_neighbour(void **unused) {
    (void)unused;
    expect_neighbours(32, 2);
    expect_neighbours(16, 3);
    assert_int_equal(redcc_memory_live(), 0);
}

static void points_of_all_kinds(void **unused) {
    (void)unused;
    const double point[][2] = {{NAN, 1},   {INFINITY, -INFINITY}, {1e308, -1e308},
                               {0, 0},     {-1e308, NAN},         {0, 0},
                               {5e-324, 3}};
    int new_of_old[7];
    assert_int_equal(redcc_reorder_points(7, 2, point[0], new_of_old), 0);
    expect_permutation(new_of_old, 7);
    assert_true(new_of_old[3] < new_of_old[5]); /* equal iterations keep their order */
    assert_int_equal(redcc_reorder_points(1, 2, point[0], new_of_old), 0);
    assert_int_equal(redcc_reorder_points(0, 3, NULL, new_of_old), 0);
    assert_int_equal(redcc_reorder_points(7, 1, point[0], new_of_old), -1);
    assert_int_equal(redcc_reorder_points(7, 4, point[0], new_of_old), -1);
}

static void iterations_follow_their_rows(void **unused) {
    (void)unused;
    static const int row[][2] = {{5, 3}, {1, 2}, {3, 4}, {2, 1}, {3, 4}, {0, 9}};
    static const int expected[] = {5, 1, 3, 2, 4, 0};
    int new_of_old[6];
    assert_int_equal(redcc_reorder_iterations(6, 2, row[0], new_of_old), 0);
    assert_memory_equal(new_of_old, expected, sizeof expected);
    assert_int_equal(redcc_reorder_iterations(-1, 2, row[0], new_of_old), -1);
}

static void records_go_there_and_back(void **unused) {
    (void)unused;
    static int triangle[TRIANGLES][3], moved[TRIANGLES][3], new_of_old[TRIANGLES];
    make_sheet(triangle);
    memcpy(moved, triangle, sizeof moved);
    assert_int_equal(redcc_reorder_iterations(TRIANGLES, 3, triangle[0], new_of_old), 0);
    assert_int_equal(redcc_reorder_records(moved, TRIANGLES, sizeof *moved, new_of_old, 0), 0);
    for (int t = 0; t < TRIANGLES; t++)
        assert_memory_equal(moved[new_of_old[t]], triangle[t], sizeof *triangle);
    assert_int_equal(redcc_reorder_records(moved, TRIANGLES, sizeof *moved, new_of_old, 1), 0);
    assert_memory_equal(moved, triangle, sizeof moved);
    new_of_old[7] = new_of_old[8];
    assert_int_equal(redcc_reorder_records(moved, TRIANGLES, sizeof *moved, new_of_old, 0), -1);
    assert_memory_equal(moved, triangle, sizeof moved);
    assert_int_equal(redcc_reorder_records(moved, 0, sizeof *moved, new_of_old, 0), 0);
}

static void failing_memory_writes_nothing(void **unused) {
    (void)unused;
    static int triangle[TRIANGLES][3], new_of_old[TRIANGLES], before[TRIANGLES];
    static double point[NODES][3];
    make_sheet(triangle);
    for (int i = 0; i < TRIANGLES; i++)
        new_of_old[i] = before[i] = i;
    for (long failing = 0; failing < 5; failing++)
        for (int call = 0; call < 4; call++) {
            redcc_memory_fail_after(failing);
            const int status =
                call == 0   ? redcc_reorder_rows(TRIANGLES, 3, triangle[0], NODES, new_of_old)
                : call == 1 ? redcc_reorder_points(NODES, 3, point[0], new_of_old)
                : call == 2 ? redcc_reorder_iterations(TRIANGLES, 3, triangle[0], new_of_old)
                            : redcc_reorder_records(triangle, TRIANGLES, 12, before, 0);
            const bool failed = redcc_memory_is_exhausted();
            redcc_memory_fail_after(-1);
            assert_true(status == 0 || failed);
            if (status != 0)
                assert_memory_equal(new_of_old, before, sizeof before);
            memcpy(new_of_old, before, sizeof before);
            assert_int_equal(redcc_memory_live(), 0);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_an_iteration_come_close),
        cmocka_unit_test(a_curve_goes_from_neighbour_to_neighbour),
        cmocka_unit_test(points_of_all_kinds),
        cmocka_unit_test(iterations_follow_their_rows),
        cmocka_unit_test(records_go_there_and_back),
        cmocka_unit_test(failing_memory_writes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
