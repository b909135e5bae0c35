/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The matrix's layout and its products. */
#include "check.h"

#include <stdlib.h>

#include "cloth.h"
#include "dense.h"
#include "system/system.h"

/* Do vertices i and j share an element of the list? */
static int share(const element_list *list, int i, int j) {
    for (int e = 0; e < list->count; e++) {
        int with_i = 0, with_j = 0;
        for (int p = 0; p < list->size; p++) {
            with_i |= list->vertex[e * list->size + p] == i;
            with_j |= list->vertex[e * list->size + p] == j;
        }
        if (with_i && with_j)
            return 1;
    }
    return 0;
}

static linear_system system_of(const mesh *m, int with_hinges, element_list lists[2]) {
    linear_system s;
    lists[0] = (element_list){m->triangle_count, 3, &m->triangle[0][0]};
    lists[1] = (element_list){m->hinge_count, 4, &m->hinge[0][0]};
    assert_int_equal(system_init(&s, m->vertex_count, with_hinges ? 2 : 1, lists), 0);
    return s;
}

static void fill(block_matrix *A, unsigned seed) {
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    A->value[k][r][c] =
                        A->column[k] == i && c < r ? A->value[k][c][r] : random_number(&seed);
}

/* The layout has exactly the pairs that share an element, each once, the diagonal first, in
 * ascending order, and finds each of them. */
static void test_layout_is_the_elements_pairs(void **state) {
    (void)state;
    mesh m = cloth_sheet(6, 5, 0.1, 0.3, 2);
    for (int with_hinges = 0; with_hinges < 2; with_hinges++) {
        element_list lists[2];
        linear_system s = system_of(&m, with_hinges, lists);
        int blocks = 0;
        for (int i = 0; i < m.vertex_count; i++) {
            assert_int_equal(s.A.column[s.A.row_start[i]], i);
            for (int j = i; j < m.vertex_count; j++) {
                if (i != j && !share(&lists[0], i, j) && !(with_hinges && share(&lists[1], i, j)))
                    continue;
                blocks++;
                const int pair[2] = {i, j};
                const element_list both = {1, 2, pair};
                int found[3];
                block_matrix_locate(&s.A, &both, found);
                const int block = found[1];
                assert_int_equal(found[0], s.A.row_start[i]);
                assert_int_equal(found[2], s.A.row_start[j]);
                assert_in_range(block, s.A.row_start[i], s.A.row_start[i + 1] - 1);
                assert_int_equal(s.A.column[block], j);
            }
        }
        assert_int_equal(s.A.block_count, blocks);
        system_free(&s);
    }
    cloth_free(&m);
}

static void test_reset_is_mass_and_gravity(void **state) {
    (void)state;
    mesh m = cloth_sheet(3, 3, 0.1, 0, 2);
    const double mass[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9}, gravity[3] = {1, -2, 3};
    element_list lists[2];
    linear_system s = system_of(&m, 1, lists);
    fill(&s.A, 1);
    system_reset(&s, mass, gravity, 0.5);
    for (int i = 0; i < 9; i++)
        for (int k = s.A.row_start[i]; k < s.A.row_start[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    assert_true(s.A.value[k][r][c] == (s.A.column[k] == i && r == c ? mass[i] : 0));
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            assert_true(s.b[i][c] == 0.5 * mass[i] * gravity[c]);
    system_free(&s);
    cloth_free(&m);
}

static void test_product_agrees_with_dense(void **state) {
    (void)state;
    mesh m = cloth_sheet(7, 6, 0.1, 0.3, 4);
    const int n = 3 * m.vertex_count;
    element_list lists[2];
    linear_system s = system_of(&m, 1, lists);
    fill(&s.A, 5);
    double *a = dense_of(&s.A);
    double(*x)[3] = cloth_moved(&m, 1, 6);
    double(*half)[3] = calloc((size_t)m.vertex_count, sizeof *half);
    half_product(&s.A, (const double(*)[3])x, half);
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int k = 0; k < n; k++)
            sum += a[i * n + k] * (&x[0][0])[k];
        assert_near((&half[0][0])[i], sum, 1e-13);
    }
    free(a);
    free(x);
    free(half);
    system_free(&s);
    cloth_free(&m);
}

static void test_no_elements_leave_a_diagonal(void **state) {
    (void)state;
    linear_system s;
    assert_int_equal(system_init(&s, 4, 0, NULL), 0);
    assert_int_equal(s.A.block_count, 4);
    system_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layout_is_the_elements_pairs),
        cmocka_unit_test(test_reset_is_mass_and_gravity),
        cmocka_unit_test(test_product_agrees_with_dense),
        cmocka_unit_test(test_no_elements_leave_a_diagonal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
