/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the solvers. */
#ifndef FABRIC_SOLVER_PARTS_H
#define FABRIC_SOLVER_PARTS_H

#include "solver.h"
#include "system/constraint.h"

/** Number of vertices per partial sum. Determines the result's bits, so it must not be tuned by
 *  machine. */
enum { SOLVER_CHUNK = 64 };

enum { UNCONSTRAINED, CONSTRAINED, DRIVEN /* constrained, with a z that is not 0 */ };

/** Replaces dv by S dv + z. Returns UNCONSTRAINED, CONSTRAINED or DRIVEN. */
int solver_apply(const constraints *c, double (*dv)[3]);

/** Replaces r by S r at every vertex. */
void solver_filter(const constraints *c, double (*r)[3]);

/** Sets s->residual = S (b - A z), to which tolerances are relative. `which` is the result of
 *  solver_apply. */
void solver_reference_residual(solver *s, const linear_system *system, const constraints *c,
                               int which);

/** s->residual = S (b - A dv) */
void solver_residual(solver *s, const linear_system *system, const constraints *c,
                     const double (*dv)[3]);

/** Returns the squared norm at which the residual is small enough. `reference` is the squared norm
 *  of S (b - A z). */
double solver_goal(const solver_limits *limits, double reference);

/** The sum of the terms, added from first to last. */
double solver_sum(const double *term, int count);

/**
 * Conjugate gradients in double, preconditioned by symmetric Gauss-Seidel in an order of the
 * vertices that allows parallel sweeps. The vertices are divided into domains of consecutive
 * numbers, and every second domain comes first. The number of domains depends only on the number of
 * vertices, so the bits do not depend on the number of threads. On a mesh of 2602 vertices, its 8
 * domains cost about 10 % more iterations than the vertices' own order.
 */
typedef struct domain_solver domain_solver;

/** Creates a solver for matrices with A's sparsity pattern; keeps a reference to A. Returns NULL if
 *  out of memory. */
domain_solver *domain_solver_new(const block_matrix *A);
void domain_solver_free(domain_solver *d);

/** Solves like solver_solve. Uses s->product and s->residual. */
solver_status domain_solver_solve(domain_solver *d, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations);

/** Conjugate gradients with any preconditioner and precision, sequentially; see solver_factor.h. */
typedef struct packed_solver packed_solver;

packed_solver *packed_solver_new(const block_matrix *A, const solver_options *options);
void packed_solver_free(packed_solver *p);

solver_status packed_solver_solve(packed_solver *p, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations);

#endif
