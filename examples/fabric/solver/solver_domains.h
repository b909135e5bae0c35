/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Conjugate gradients in double, preconditioned by symmetric Gauss-Seidel in an order of the
 * vertices that lets many of them be swept at the same time: the vertices are cut into domains,
 * runs of near numbers, and every second domain comes first. How many there are depends on the
 * count of vertices alone, so the bits do not depend on the number of threads. Against the
 * vertices' own order 8 domains of the paper's mesh cost some 10 % more iterations.
 */
#ifndef FABRIC_SOLVER_DOMAINS_H
#define FABRIC_SOLVER_DOMAINS_H

#include "solver.h"

typedef struct domain_solver domain_solver;

/** NULL: out of memory. A by reference: for its layout. */
domain_solver *domain_solver_new(const block_matrix *A);
void domain_solver_free(domain_solver *d);

/** As solver_solve, which calls it; uses s->product and s->residual. */
solver_status domain_solver_solve(domain_solver *d, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations);

#endif
