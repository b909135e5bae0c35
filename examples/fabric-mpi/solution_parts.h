/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the solutions over parts share. Collective. The part has the system, the constraints and a
 *  guess, dv, that meets these; `which` is solver_apply's, of the whole cloth. */
#ifndef FABRIC_MPI_SOLUTION_PARTS_H
#define FABRIC_MPI_SOLUTION_PARTS_H

#include "part.h"

/** y = A x in the rows that the rank owns, with the ghosts of x brought up to date. */
void solution_product(part *p, double (*x)[3], double (*y)[3]);

/** The solver's residual = b - A x, with what the constraints take. x may be the residual. */
void solution_residual(part *p, double (*x)[3]);

/** The solver's residual = b - A z, before it is filtered: what a tolerance is relative to. */
void solution_reference(part *p, int which);

/** As solver_solve with block-Jacobi, from the guess dv. */
solver_status jacobi_solve(part *p, const solver_limits *limits, int which, long *iterations);

/** As solver_defect. */
double jacobi_defect(part *p, int which, double *reference);

/** As solver_solve with Gauss-Seidel, from the guess dv. */
solver_status domains_solve(part *p, const solver_limits *limits, int which, long *iterations);

#endif
