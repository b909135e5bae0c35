/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Conjugate gradients within constraints, against elimination; and what stops them. */
#include "check.h"

#include <stdlib.h>
#include <string.h>

#include "cloth.h"
#include "dense.h"
#include "solver.h"

typedef struct problem {
    mesh m;
    int n;
    linear_system system;
    constraints constraints;
    solver solver;
    solver_limits limits;
    double (*dv)[3];
    long iterations;
} problem;

/* A symmetric, diagonally dominant matrix with a sheet's layout, and a right side. */
static problem problem_new(unsigned seed) {
    problem p = {.m = cloth_sheet(6, 5, 0.1, 0.3, seed)};
    p.n = p.m.vertex_count;
    p.limits = (solver_limits){1e-12, 0, 1000};
    const element_list list = {p.m.hinge_count, 4, &p.m.hinge[0][0]};
    assert_int_equal(system_init(&p.system, p.n, 1, &list), 0);
    assert_int_equal(constraints_init(&p.constraints, p.n), 0);
    assert_int_equal(solver_init(&p.solver, p.n), 0);
    p.dv = calloc((size_t)p.n, sizeof *p.dv);
    block_matrix *A = &p.system.A;
    for (int i = 0; i < p.n; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) {
                    A->value[k][r][c] = random_number(&seed);
                    if (A->column[k] == i)
                        A->value[k][r][c] =
                            r == c ? 40 : (r < c ? A->value[k][r][c] : A->value[k][c][r]);
                }
    for (int i = 0; i < p.n; i++)
        for (int c = 0; c < 3; c++)
            p.system.b[i][c] = random_number(&seed);
    return p;
}

static void problem_end(problem *p) {
    solver_free(&p->solver);
    constraints_free(&p->constraints);
    system_free(&p->system);
    cloth_free(&p->m);
    free(p->dv);
}

static solver_status solve(problem *p) {
    p->iterations = 0;
    return solver_solve(&p->solver, &p->system, &p->constraints, &p->limits, p->dv, &p->iterations);
}

/* dv = y + z where (S A S + I - S) y = S (b - A z), by elimination (Tamstorf et al. 2015). */
static double *oracle(const problem *p) {
    const int n = 3 * p->n;
    double *a = dense_of(&p->system.A);
    double *inside = calloc((size_t)n * (size_t)n, sizeof *inside);
    double *S = calloc((size_t)n * (size_t)n, sizeof *S);
    double *right = calloc((size_t)n, sizeof *right);
    double *dv = calloc((size_t)n, sizeof *dv);
    const double *z = &p->constraints.z[0][0];
    for (int i = 0; i < p->n; i++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                S[(3 * i + r) * n + 3 * i + c] = p->constraints.S[i][r][c];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double sum = (i == j ? 1 : 0) - S[i * n + j];
            for (int k = i - i % 3; k < i - i % 3 + 3; k++)
                for (int l = j - j % 3; l < j - j % 3 + 3; l++)
                    sum += S[i * n + k] * a[k * n + l] * S[l * n + j];
            inside[i * n + j] = sum;
        }
    for (int i = 0; i < n; i++)
        for (int k = i - i % 3; k < i - i % 3 + 3; k++) {
            double rest = (&p->system.b[0][0])[k];
            for (int l = 0; l < n; l++)
                rest -= a[k * n + l] * z[l];
            right[i] += S[i * n + k] * rest;
        }
    dense_solve(inside, n, dv, right);
    for (int i = 0; i < n; i++)
        dv[i] += z[i];
    free(a);
    free(inside);
    free(S);
    free(right);
    return dv;
}

/* Gives 0 to 3 directions of each vertex of which i % every == 0. */
static void constrain(problem *p, int every, unsigned seed) {
    for (int i = 0; i < p->n; i += every) {
        double d[3][3], change[3];
        for (int k = 0; k < 3; k++) {
            change[k] = random_number(&seed);
            for (int c = 0; c < 3; c++)
                d[k][c] = random_number(&seed);
        }
        constraint_give(&p->constraints, i, i % 4, (const double(*)[3])d, change);
        assert_int_equal(p->constraints.given[i], i % 4);
    }
}

/* S21: none, some, all constrained. */
static void S21_agrees_with_elimination(void **state) {
    (void)state;
    for (int every = 0; every < 4; every++) {
        problem p = problem_new(3 + (unsigned)every);
        if (every > 0)
            constrain(&p, every, 17);
        assert_int_equal(solve(&p), SOLVER_CONVERGED);
        double *expected = oracle(&p);
        for (int i = 0; i < 3 * p.n; i++)
            assert_near((&p.dv[0][0])[i], expected[i], 1e-11);
        free(expected);
        problem_end(&p);
    }
}

/* Whatever is given holds to the last digits, and the residual along it is the impulse. */
static void S21_given_directions_are_exact(void **state) {
    (void)state;
    problem p = problem_new(8);
    constrain(&p, 1, 23);
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    double *a = dense_of(&p.system.A);
    for (int i = 0; i < p.n; i++)
        for (int r = 0; r < 3; r++) {
            double off = p.dv[i][r] - p.constraints.z[i][r], residual = p.system.b[i][r];
            for (int c = 0; c < 3; c++)
                off -= p.constraints.S[i][r][c] * p.dv[i][c];
            for (int k = 0; k < 3 * p.n; k++)
                residual -= a[(3 * i + r) * 3 * p.n + k] * (&p.dv[0][0])[k];
            assert_near(off, 0, 1e-13);
            assert_near(p.solver.residual[i][r], residual, 1e-10);
        }
    free(a);
    problem_end(&p);
}

static void S21_all_pinned_takes_no_iteration(void **state) {
    (void)state;
    problem p = problem_new(8);
    const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, change[3] = {1, 2, 3};
    for (int i = 0; i < p.n; i++)
        constraint_give(&p.constraints, i, 3, axes, change);
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    assert_int_equal(p.iterations, 0);
    for (int i = 0; i < p.n; i++)
        assert_memory_equal(p.dv[i], change, sizeof change);
    problem_end(&p);
}

/* S29: S is a projection, whatever directions are given; dependent ones do not count. */
static void S29_projection(void **state) {
    (void)state;
    constraints c;
    unsigned seed = 4;
    assert_int_equal(constraints_init(&c, 1), 0);
    for (int n = 0; n < 200; n++) {
        double d[5][3], change[5] = {1, 2, 3, 4, 5};
        for (int k = 0; k < 5; k++)
            for (int a = 0; a < 3; a++)
                d[k][a] = k == 1 ? d[0][a] * 2 : random_number(&seed);
        constraint_give(&c, 0, 1 + n % 4, (const double(*)[3])d, change);
        assert_int_equal(c.given[0], n % 4 == 0 ? 1 : n % 4);
        for (int r = 0; r < 3; r++)
            for (int k = 0; k < 3; k++) {
                double square = 0;
                for (int m = 0; m < 3; m++)
                    square += c.S[0][r][m] * c.S[0][m][k];
                assert_near(square, c.S[0][r][k], 1e-14);
                assert_true(c.S[0][r][k] == c.S[0][k][r]);
            }
        double along = 0;
        for (int a = 0; a < 3; a++)
            along += d[0][a] * c.z[0][a];
        assert_near(along, change[0], 1e-12);
    }
    constraints_free(&c);
}

static void test_good_guess_takes_no_iteration(void **state) {
    (void)state;
    problem p = problem_new(5);
    p.limits.tolerance = 1e-8;
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    assert_in_range(p.iterations, 1, 200);
    p.limits.tolerance = 1e-7;
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    assert_int_equal(p.iterations, 0);
    problem_end(&p);
}

/* S24: with nothing to do, relative tolerance alone would never end. */
static void S24_nothing_to_do(void **state) {
    (void)state;
    problem p = problem_new(5);
    memset(p.system.b, 0, sizeof *p.system.b * (size_t)p.n);
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    assert_int_equal(p.iterations, 0);
    p.dv[3][1] = 1e-3;
    p.limits.floor = 1;
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    assert_int_equal(p.iterations, 0);
    problem_end(&p);
}

/* S23 */
static void S23_statuses(void **state) {
    (void)state;
    problem p = problem_new(5);
    p.limits.max_iterations = 3;
    assert_int_equal(solve(&p), SOLVER_TOO_MANY_ITERATIONS);
    assert_int_equal(p.iterations, 3);
    p.limits.max_iterations = 1000;

    /* Positive diagonal blocks, indefinite as a whole. */
    const int off = p.system.A.row_start[0] + 1;
    p.system.A.value[off][0][0] = 1e4;
    assert_int_equal(solve(&p), SOLVER_BREAKDOWN);
    for (int i = 0; i < 3 * p.n; i++)
        assert_true(isfinite((&p.dv[0][0])[i]));

    p.system.A.value[off][0][0] = 0;
    p.system.b[2][1] = NAN;
    assert_int_equal(solve(&p), SOLVER_NOT_FINITE);
    p.system.b[2][1] = 0;
    memset(p.dv, 0, sizeof *p.dv * (size_t)p.n);
    p.system.A.value[off][0][0] = INFINITY;
    assert_int_equal(solve(&p), SOLVER_NOT_FINITE);
    problem_end(&p);
}

/* A vertex without mass and stiffness has a zero block: it must not spoil the others. */
static void test_singular_block(void **state) {
    (void)state;
    problem p = problem_new(5);
    block_matrix *A = &p.system.A;
    for (int i = 0; i < p.n; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            if (i == 4 || A->column[k] == 4)
                memset(A->value[k], 0, sizeof A->value[k]);
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    for (int c = 0; c < 3; c++)
        assert_true(p.dv[4][c] == 0);
    problem_end(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S21_agrees_with_elimination),
        cmocka_unit_test(S21_given_directions_are_exact),
        cmocka_unit_test(S21_all_pinned_takes_no_iteration),
        cmocka_unit_test(S29_projection),
        cmocka_unit_test(test_good_guess_takes_no_iteration),
        cmocka_unit_test(S24_nothing_to_do),
        cmocka_unit_test(S23_statuses),
        cmocka_unit_test(test_singular_block),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
