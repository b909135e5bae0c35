/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Direct solution: sparse Cholesky factorisation by CHOLMOD (SuiteSparse), if built with it. */
#ifndef FABRIC_SOLVER_DIRECT_H
#define FABRIC_SOLVER_DIRECT_H

#include "solver.h"

typedef struct direct_solver direct_solver;

/** Was the program built with CHOLMOD? */
int direct_solver_available(void);

/** Analyses A's sparsity pattern: finds a fill-reducing order and the factor's pattern. Returns
 *  NULL with a message in error[256] on failure. */
direct_solver *direct_solver_new(const block_matrix *A, char *error);
void direct_solver_free(direct_solver *d);

/** Returns the number of multiplications of one solution: the factorisation and two triangular
 *  systems. It depends on the sparsity pattern only. */
double direct_solver_work(const direct_solver *d);

/** Computes memory in bytes from the sparsity pattern. *held: allocated for d so far; *more:
 *  allocated by its first solution (factor and workspace). */
void direct_solver_memory(const direct_solver *d, double *held, double *more);

/** Gives the solution of solver_solve up to rounding errors, without limits. Counts a factorisation
 *  as one iteration. Returns SOLVER_BREAKDOWN if A is not positive definite, or SOLVER_NOT_FINITE
 *  if a number is not finite or memory runs out. */
solver_status direct_solver_solve(direct_solver *d, solver *s, const linear_system *system,
                                  const constraints *c, double (*dv)[3], long *iterations);

#endif
