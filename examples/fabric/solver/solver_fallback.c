/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "solver_fallback.h"

#include <assert.h>
#include <stddef.h>

#include "solver_direct.h"

enum { solved_directly_at_once = 50 };

static solver_status solve_directly(solver_fallback *f, solver *s, const linear_system *system,
                                    const constraints *c, double (*dv)[3], long *iterations) {
    char error[256];
    if (!f->direct && !f->failed)
        f->direct = direct_solver_new(&system->A, error);
    f->failed = !f->direct;
    if (f->failed)
        return SOLVER_TOO_MANY_ITERATIONS;
    const solver_status status = direct_solver_solve(f->direct, s, system, c, dv, iterations);
    if (status != SOLVER_CONVERGED)
        return status == SOLVER_NOT_FINITE ? status : SOLVER_TOO_MANY_ITERATIONS;
    solver_impulses(s, system, (const double(*)[3])dv);
    f->solved++;
    return status;
}

/* Returns the number of multiplications in an iteration: for each stored block about two 3x3
 * products in the product with A, and two more in the preconditioner. */
static double work_of_iteration(const block_matrix *A) {
    return 2 * 9 * 2.0 * (double)A->block_count;
}

/* Decides whether a direct solution is much cheaper than this number of iterations. */
static void consider(solver_fallback *f, const linear_system *system, long iterations) {
    char error[256];
    if (iterations < SOLVER_MANY_ITERATIONS || f->costly || f->failed || !direct_solver_available())
        return;
    if (!f->direct)
        f->direct = direct_solver_new(&system->A, error);
    f->costly = !f->direct || !(4 * direct_solver_work(f->direct) <
                                (double)iterations * work_of_iteration(&system->A));
    if (!f->costly) {
        f->next = solved_directly_at_once;
        return;
    }
    direct_solver_free(f->direct);
    f->direct = NULL;
}

solver_status solver_fallback_solve(solver_fallback *f, solver *s, const linear_system *system,
                                    const constraints *c, const solver_limits *limits,
                                    double (*dv)[3], long *iterations) {
    assert(f->next >= 0 && !(f->direct && f->failed));
    if (f->next > 0) {
        f->next--;
        return solve_directly(f, s, system, c, dv, iterations);
    }
    const long before = *iterations;
    const solver_status status = solver_solve(s, system, c, limits, dv, iterations);
    if (status == SOLVER_CONVERGED && !s->direct)
        consider(f, system, *iterations - before);
    if (status != SOLVER_TOO_MANY_ITERATIONS || s->direct)
        return status;
    const solver_status directly = solve_directly(f, s, system, c, dv, iterations);
    if (directly == SOLVER_CONVERGED)
        f->next = solved_directly_at_once;
    return directly;
}

void solver_fallback_free(solver_fallback *f) {
    direct_solver_free(f->direct);
    *f = (solver_fallback){0};
}
