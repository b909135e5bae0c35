/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The solution by PETSc's matrix, conjugate gradients and preconditioners, for --bits=any. The
 * bits depend on the number of ranks. Collective. */
#ifndef FABRIC_MPI_SOLUTION_PETSC_H
#define FABRIC_MPI_SOLUTION_PETSC_H

#include "part.h"

/**
 * Creates a solver for systems of the part's layout, configured by PETSC_OPTIONS. The default is
 * `cg`, with the residual in the preconditioner's norm, as in fabric. The default preconditioner is
 * PETSc's nearest to the scene's: pbjacobi (block-jacobi), sor within each rank (gauss-seidel),
 * jacobi, none, or bjacobi with icc within each rank (incomplete-cholesky). -ksp_rtol, -ksp_atol
 * and -ksp_max_it override the scene's limits. petsc_solver_free frees it.
 */
struct petsc_solver *petsc_solver_new(const part *p);
void petsc_solver_free(struct petsc_solver *s);

/** Solves like solver_solve, starting from the guess dv. `which` is the result of solver_apply for
 *  the whole cloth. */
solver_status petsc_solve(part *p, const solver_limits *limits, int which, long *iterations);

#endif
