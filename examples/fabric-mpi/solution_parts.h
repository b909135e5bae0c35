/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the solvers over parts. Functions are collective. The part has the system, the
 *  constraints and a guess dv that satisfies them; `which` is the result of solver_apply for the
 *  whole cloth. */
#ifndef FABRIC_MPI_SOLUTION_PARTS_H
#define FABRIC_MPI_SOLUTION_PARTS_H

#include "part.h"

/** Updates the ghosts of x, and computes y = A x in the rows that the rank owns. */
void solution_product(part *p, double (*x)[3], double (*y)[3]);

/** Sets the solver's residual to b - A x, which includes the impulses of constraints. x may be the
 *  residual. */
void solution_residual(part *p, double (*x)[3]);

/** Sets the solver's residual to b - A z, without filtering. Tolerances are relative to it. */
void solution_reference(part *p, int which);

/** Solves like solver_solve with block-Jacobi, starting from the guess dv. */
solver_status jacobi_solve(part *p, const solver_limits *limits, int which, long *iterations);

/** Like solver_defect. */
double jacobi_defect(part *p, int which, double *reference);

/** Solves like solver_solve with Gauss-Seidel, starting from the guess dv. */
solver_status domains_solve(part *p, const solver_limits *limits, int which, long *iterations);

#endif
