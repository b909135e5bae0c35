/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Conjugate gradients over all parts in double, with the operations of fabric's solver in their
 *  order, or by PETSc with --bits=any. Functions are collective and return the same on all ranks.
 *  The pointers in whole_system are the leader's; other ranks pass NULL. */
#ifndef FABRIC_MPI_SOLUTION_H
#define FABRIC_MPI_SOLUTION_H

#include "part.h"

/** The linear system of the whole cloth, with its constraints, solution and residual. Only the
 *  leader has it. */
typedef struct whole_system {
    const linear_system *system;
    const constraints *given;
    double (*dv)[3];       /* guess, then solution */
    double (*residual)[3]; /* as in struct solver */
} whole_system;

/** Like solver_solve; `limits` are the leader's, or NULL on other ranks. */
solver_status solution_solve(part *p, const whole_system *whole, const solver_limits *limits,
                             long *iterations);

/** Like solver_defect. */
double solution_defect(part *p, const whole_system *whole, double *reference);

/** Like solver_impulses. */
void solution_impulses(part *p, const whole_system *whole);

#endif
