/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Conjugate gradients with constraints are compared with elimination. Also tests the conditions
 * that stop them. Numbers such as S21 refer to docs/fabric-hard-cases.md. */
#include "check.h"

#include <stdlib.h>
#include <string.h>

#include "cloth.h"
#include "dense.h"
#include "solver/solver.h"
#include "solver/solver_direct.h"
#include "solver/solver_factor.h"

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

/* Returns a symmetric, diagonally dominant matrix with a sheet's layout, and a right side. Vertex v
 * of the sheet gets the number v * stride modulo the count. */
static problem problem_of(mesh sheet, int stride, unsigned seed) {
    problem p = {.m = sheet, .n = sheet.vertex_count};
    for (int h = 0; h < p.m.hinge_count; h++)
        for (int a = 0; a < 4; a++)
            p.m.hinge[h][a] = p.m.hinge[h][a] * stride % p.n;
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

static problem problem_new(unsigned seed) {
    return problem_of(cloth_sheet(6, 5, 0.1, 0.3, seed), 1, seed);
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

/* Returns dv = y + z, where (S A S + I - S) y = S (b - A z) is solved by elimination (Tamstorf et
 * al. 2015). S projects onto the free directions, and z is the prescribed part. */
static double *oracle(const problem *p) {
    const int n = 3 * p->n;
    double *a = dense_of(&p->system.A);
    double *inside = calloc((size_t)n * (size_t)n, sizeof *inside);
    double *S = calloc((size_t)n * (size_t)n, sizeof *S);
    double *right = calloc((size_t)n, sizeof *right);
    double *dv = calloc((size_t)n, sizeof *dv);
    double *z = calloc((size_t)n, sizeof *z);
    for (int i = 0; i < p->n; i++)
        for (int r = 0; r < 3; r++) {
            z[3 * i + r] = constraint_change(&p->constraints, i)[r];
            for (int c = 0; c < 3; c++)
                S[(3 * i + r) * n + 3 * i + c] = constraint_projection(&p->constraints, i)[r][c];
        }
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
    free(z);
    return dv;
}

/* Prescribes 0 to 3 directions of each vertex with i % every == 0. */
static void constrain(problem *p, int every, unsigned seed) {
    for (int i = 0; i < p->n; i += every) {
        double d[3][3], change[3];
        for (int k = 0; k < 3; k++) {
            change[k] = random_number(&seed);
            for (int c = 0; c < 3; c++)
                d[k][c] = random_number(&seed);
        }
        assert_int_equal(constraint_place(&p->constraints, i), 0);
        constraint_give(&p->constraints, i, i % 4, (const double(*)[3])d, change);
        assert_int_equal(p->constraints.given[i], i % 4);
    }
}

/* S21: no vertex, some or all are constrained. */
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

/* The residual is below the tolerance, in the norm to which the tolerance refers. */
static void test_reaches_the_tolerance(void **state) {
    (void)state;
    for (int n = 1; n <= 8; n++) {
        const double tolerance = pow(10, -n);
        double reference;
        problem p = problem_new(3);
        p.limits.tolerance = tolerance;
        assert_int_equal(solve(&p), SOLVER_CONVERGED);
        const double defect =
            solver_defect(&p.solver, &p.system, &p.constraints, p.dv, &reference) / reference;
        assert_below(defect, 1.001 * tolerance);
        problem_end(&p);
    }
}

static void choose(problem *p, preconditioner_kind kind, solver_precision precision,
                   solver_method method) {
    char error[256] = "";
    const solver_options options = {kind, precision, method, 1};
    if (solver_choose(&p->solver, &p->system.A, &options, error) != 0)
        fail_msg("%s", error);
}

/* Returns |b - A z| on the free directions, to which a relative tolerance refers. */
static double reference_of(problem *p) {
    double reference;
    double(*copy)[3] = malloc(sizeof *copy * (size_t)p->n);
    memcpy(copy, p->dv, sizeof *copy * (size_t)p->n);
    solver_defect(&p->solver, &p->system, &p->constraints, copy, &reference);
    free(copy);
    return reference;
}

/* Returns the largest deviation of dv from the prescribed values, |(I - S) dv - z|. */
static double off_given(const problem *p) {
    double worst = 0;
    for (int i = 0; i < p->n; i++)
        for (int r = 0; r < 3; r++) {
            double off = p->dv[i][r] - constraint_change(&p->constraints, i)[r];
            for (int c = 0; c < 3; c++)
                off -= constraint_projection(&p->constraints, i)[r][c] * p->dv[i][c];
            worst = fmax(worst, fabs(off));
        }
    return worst;
}

/* Every preconditioner in every precision finds the same solution, constrained or not, within the
 * stopping rule r' M^-1 r <= (tolerance reference)^2. Here M is near 40 and A's eigenvalues are
 * above 10. Prescribed values are exact. */
static void test_preconditioners_agree_with_elimination(void **state) {
    (void)state;
    for (int kind = PRECONDITIONER_GAUSS_SEIDEL; kind <= PRECONDITIONER_INCOMPLETE_CHOLESKY; kind++)
        for (int precision = PRECISION_DOUBLE; precision <= PRECISION_MIXED; precision++)
            for (int every = 0; every < 3; every++) {
                problem p = problem_new(3 + (unsigned)every);
                if (every > 0)
                    constrain(&p, every, 17);
                choose(&p, (preconditioner_kind)kind, (solver_precision)precision,
                       METHOD_CONJUGATE_GRADIENTS);
                p.limits.tolerance = precision == PRECISION_FLOAT ? 1e-6 : 1e-12;
                assert_int_equal(solve(&p), SOLVER_CONVERGED);
                const double reference = reference_of(&p);
                double *less = dense_of(&p.system.A);
                for (int i = 0; i < 3 * p.n; i++)
                    less[i * 3 * p.n + i] -= 10;
                assert_int_equal(dense_cholesky(less, 3 * p.n), 0);
                free(less);
                double *expected = oracle(&p);
                double worst = 0;
                for (int i = 0; i < 3 * p.n; i++)
                    worst = fmax(worst, fabs((&p.dv[0][0])[i] - expected[i]));
                if (!(worst <= p.limits.tolerance * reference))
                    fail_msg("preconditioner %d, precision %d, every %d: off by %g of %g", kind,
                             precision, every, worst, p.limits.tolerance * reference);
                assert_below(off_given(&p), 1e-13);
                free(expected);
                problem_end(&p);
            }
}

/* Gauss-Seidel on a mesh of several domains, whose neighbours have near numbers or distant ones.
 * With distant ones there are blocks between domains that are swept at the same time. */
static void test_gauss_seidel_in_domains(void **state) {
    (void)state;
    long iterations[2];
    for (int shuffled = 0; shuffled < 2; shuffled++)
        for (int every = 2; every >= 0; every -= 2) {
            problem p = problem_of(cloth_sheet(15, 14, 0.1, 0.3, 2), shuffled ? 37 : 1, 6);
            if (every > 0)
                constrain(&p, every, 17);
            choose(&p, PRECONDITIONER_GAUSS_SEIDEL, PRECISION_DOUBLE, METHOD_CONJUGATE_GRADIENTS);
            assert_int_equal(solve(&p), SOLVER_CONVERGED);
            double *expected = oracle(&p);
            for (int i = 0; i < 3 * p.n; i++)
                assert_near((&p.dv[0][0])[i], expected[i], 1e-12);
            assert_below(off_given(&p), 1e-13);
            iterations[shuffled] = p.iterations;
            free(expected);
            problem_end(&p);
        }
    assert_in_range(iterations[0], 5, 40);
    assert_true(iterations[1] >= iterations[0]); /* blocks between domains are not preconditioned */
}

/* A better preconditioner takes fewer iterations. The incomplete factor of a matrix with all blocks
 * is the complete one, which takes one iteration. */
static void test_preconditioners_are_of_use(void **state) {
    (void)state;
    long iterations[PRECONDITIONER_INCOMPLETE_CHOLESKY + 1];
    for (int kind = PRECONDITIONER_GAUSS_SEIDEL; kind <= PRECONDITIONER_INCOMPLETE_CHOLESKY;
         kind++) {
        problem p = problem_new(3);
        for (int i = 0; i < p.n; i++) /* scales rows very differently */
            for (int k = p.system.A.row_start[i]; k < p.system.A.row_start[i + 1]; k++)
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++)
                        p.system.A.value[k][r][c] *=
                            pow(10, (i * 7 % 4 + p.system.A.column[k] * 7 % 4) / 2.0);
        choose(&p, (preconditioner_kind)kind, PRECISION_DOUBLE, METHOD_CONJUGATE_GRADIENTS);
        assert_int_equal(solve(&p), SOLVER_CONVERGED);
        iterations[kind] = p.iterations;
        problem_end(&p);
    }
    assert_true(iterations[PRECONDITIONER_NONE] > 2 * iterations[PRECONDITIONER_JACOBI]);
    assert_true(iterations[PRECONDITIONER_JACOBI] >= iterations[PRECONDITIONER_BLOCK_JACOBI]);
    assert_true(iterations[PRECONDITIONER_BLOCK_JACOBI] > iterations[PRECONDITIONER_GAUSS_SEIDEL]);
    assert_true(iterations[PRECONDITIONER_BLOCK_JACOBI] >
                iterations[PRECONDITIONER_INCOMPLETE_CHOLESKY]);
}

/* On a layout where elimination makes no new block, incomplete Cholesky is complete except for its
 * shift: R'R is the matrix with its diagonal blocks multiplied by 1 + shift. */
static void test_incomplete_cholesky_of_a_chain(void **state) {
    (void)state;
    enum { N = 12 };
    int pair[N - 1][2];
    unsigned seed = 9;
    for (int i = 0; i + 1 < N; i++) {
        pair[i][0] = i;
        pair[i][1] = i + 1;
    }
    const element_list list = {N - 1, 2, &pair[0][0]};
    linear_system chain;
    constraints free_all;
    factored f;
    assert_int_equal(system_init(&chain, N, 1, &list), 0);
    assert_int_equal(constraints_init(&free_all, N), 0);
    block_matrix *A = &chain.A;
    for (int i = 0; i < N; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    A->value[k][r][c] =
                        A->column[k] != i ? random_number(&seed) : (r == c ? 6 : 0.5);
    assert_int_equal(factored_init(&f, A, PRECONDITIONER_INCOMPLETE_CHOLESKY), 0);
    factored_build(&f, A, &free_all, PRECONDITIONER_INCOMPLETE_CHOLESKY);
    /* (I + F)' (I + F) in terms of the scaled matrix, whose off-diagonal blocks are U. */
    for (int i = 0; i + 1 < N; i++) {
        const int k = A->row_start[i] + 1;
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                assert_near(f.factor[k][r][c], f.upper[k][r][c], 1e-14);
        for (int r = 0; r < 3; r++)
            for (int c = r; c < 3; c++) {
                const int m = r == 0 ? c : (r == 1 ? 2 + c : 5);
                double sum = r == c ? 1 : 0;
                for (int a = 0; a < 3; a++)
                    sum += f.factor[k][a][r] * f.factor[k][a][c];
                assert_near(sum, (1 + f.shift) * f.diagonal[i + 1][m], 1e-13);
            }
    }
    factored_free(&f);
    constraints_free(&free_all);
    system_free(&chain);
}

static void test_direct_agrees_with_elimination(void **state) {
    (void)state;
    if (!direct_solver_available())
        skip();
    for (int every = 0; every < 3; every++) {
        problem p = problem_new(3 + (unsigned)every);
        if (every > 0)
            constrain(&p, every, 17);
        choose(&p, PRECONDITIONER_BLOCK_JACOBI, PRECISION_DOUBLE, METHOD_DIRECT);
        assert_int_equal(solve(&p), SOLVER_CONVERGED);
        assert_int_equal(p.iterations, 1);
        double *expected = oracle(&p);
        for (int i = 0; i < 3 * p.n; i++)
            assert_near((&p.dv[0][0])[i], expected[i], 1e-12);
        free(expected);
        p.system.A.value[p.system.A.row_start[0] + 1][0][0] = 1e4;
        assert_int_equal(solve(&p), SOLVER_BREAKDOWN);
        p.system.b[1][1] = NAN;
        assert_int_equal(solve(&p), SOLVER_NOT_FINITE);
        problem_end(&p);
    }
}

/* S25: in float the estimated error is too small; in mixed precision the tolerance is reached. */
static void test_float_and_mixed(void **state) {
    (void)state;
    double error[3];
    for (int precision = PRECISION_DOUBLE; precision <= PRECISION_MIXED; precision++) {
        problem p = problem_new(3);
        double *expected = oracle(&p);
        choose(&p, PRECONDITIONER_GAUSS_SEIDEL, (solver_precision)precision,
               METHOD_CONJUGATE_GRADIENTS);
        p.limits.tolerance = 1e-11;
        solve(&p);
        error[precision] = 0;
        for (int i = 0; i < 3 * p.n; i++)
            error[precision] = fmax(error[precision], fabs((&p.dv[0][0])[i] - expected[i]));
        free(expected);
        problem_end(&p);
    }
    assert_below(error[PRECISION_DOUBLE], 1e-11);
    assert_below(error[PRECISION_MIXED], 1e-11);
    assert_below(error[PRECISION_FLOAT], 1e-6);
    assert_true(error[PRECISION_FLOAT] > 1e-10);
}

/* Prescribed values are exact up to the last digits, and the residual along them is the impulse. */
static void S21_given_directions_are_exact(void **state) {
    (void)state;
    problem p = problem_new(8);
    constrain(&p, 1, 23);
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    double *a = dense_of(&p.system.A);
    for (int i = 0; i < p.n; i++)
        for (int r = 0; r < 3; r++) {
            double off = p.dv[i][r] - constraint_change(&p.constraints, i)[r],
                   residual = p.system.b[i][r];
            for (int c = 0; c < 3; c++)
                off -= constraint_projection(&p.constraints, i)[r][c] * p.dv[i][c];
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
    for (int i = 0; i < p.n; i++) {
        assert_int_equal(constraint_place(&p.constraints, i), 0);
        constraint_give(&p.constraints, i, 3, axes, change);
    }
    assert_int_equal(solve(&p), SOLVER_CONVERGED);
    assert_int_equal(p.iterations, 0);
    for (int i = 0; i < p.n; i++)
        assert_memory_equal(p.dv[i], change, sizeof change);
    problem_end(&p);
}

/* S29: S is a projection, whatever directions are prescribed; dependent directions do not count. */
static void S29_projection(void **state) {
    (void)state;
    constraints c;
    unsigned seed = 4;
    assert_int_equal(constraints_init(&c, 1), 0);
    assert_int_equal(constraint_place(&c, 0), 0);
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
                    square +=
                        constraint_projection(&c, 0)[r][m] * constraint_projection(&c, 0)[m][k];
                assert_near(square, constraint_projection(&c, 0)[r][k], 1e-14);
                assert_true(constraint_projection(&c, 0)[r][k] ==
                            constraint_projection(&c, 0)[k][r]);
            }
        double along = 0;
        for (int a = 0; a < 3; a++)
            along += d[0][a] * constraint_change(&c, 0)[a];
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

/* S24: with a right side of 0 a relative tolerance alone would never be reached. */
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

/* S23: each status of the solver is reached. */
static void statuses_with(preconditioner_kind kind) {
    problem p = problem_new(5);
    choose(&p, kind, PRECISION_DOUBLE, METHOD_CONJUGATE_GRADIENTS);
    p.limits.max_iterations = 3;
    assert_int_equal(solve(&p), SOLVER_TOO_MANY_ITERATIONS);
    assert_int_equal(p.iterations, 3);
    p.limits.max_iterations = 1000;

    /* positive diagonal blocks, but the whole matrix is indefinite */
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

static void S23_statuses(void **state) {
    (void)state;
    statuses_with(PRECONDITIONER_BLOCK_JACOBI);
    statuses_with(PRECONDITIONER_GAUSS_SEIDEL);
}

/* A vertex without mass and stiffness has a zero block, which must not affect the others. */
static void test_singular_block(void **state) {
    (void)state;
    for (int kind = PRECONDITIONER_GAUSS_SEIDEL; kind <= PRECONDITIONER_INCOMPLETE_CHOLESKY;
         kind++) {
        problem p = problem_new(5);
        block_matrix *A = &p.system.A;
        for (int i = 0; i < p.n; i++)
            for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
                if (i == 4 || A->column[k] == 4)
                    memset(A->value[k], 0, sizeof A->value[k]);
        if (kind == PRECONDITIONER_NONE)
            memset(p.system.b[4], 0, sizeof p.system.b[4]);
        choose(&p, (preconditioner_kind)kind, PRECISION_DOUBLE, METHOD_CONJUGATE_GRADIENTS);
        assert_int_equal(solve(&p), SOLVER_CONVERGED);
        for (int c = 0; c < 3; c++)
            assert_true(p.dv[4][c] == 0);
        problem_end(&p);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S21_agrees_with_elimination),
        cmocka_unit_test(test_reaches_the_tolerance),
        cmocka_unit_test(test_preconditioners_agree_with_elimination),
        cmocka_unit_test(test_gauss_seidel_in_domains),
        cmocka_unit_test(test_preconditioners_are_of_use),
        cmocka_unit_test(test_incomplete_cholesky_of_a_chain),
        cmocka_unit_test(test_direct_agrees_with_elimination),
        cmocka_unit_test(test_float_and_mixed),
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
