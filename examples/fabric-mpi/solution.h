/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Conjugate gradients over all parts, in double, with the operations of fabric's solver in their
 *  order, or with --bits=any by PETSc. Functions are collective and return the same on all ranks;
 *  system, constraints, dv and residual are the leader's, on other ranks NULL. */
#ifndef FABRIC_MPI_SOLUTION_H
#define FABRIC_MPI_SOLUTION_H

#include "part.h"

/** The leader's side of a system. */
typedef struct whole_system {
    const linear_system *system;
    const constraints *given;
    double (*dv)[3];       /* guess, then solution */
    double (*residual)[3]; /* as in struct solver */
} whole_system;

/** As solver_solve; limits: the leader's, on other ranks NULL. */
solver_status solution_solve(part *p, const whole_system *whole, const solver_limits *limits,
                             long *iterations);

/** As solver_defect. */
double solution_defect(part *p, const whole_system *whole, double *reference);

/** As solver_impulses. */
void solution_impulses(part *p, const whole_system *whole);

#endif
