/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the methods of solution. */
#ifndef FABRIC_SOLVER_PARTS_H
#define FABRIC_SOLVER_PARTS_H

#include "solver.h"
#include "system/constraint.h"

/** Vertices of a partial sum: a part of the result's bits, so not to be tuned by machine. */
enum { SOLVER_CHUNK = 64 };

enum { UNCONSTRAINED, CONSTRAINED, DRIVEN /* constrained, and some z is not 0 */ };

/** dv = S dv + z; returns which of the above holds. */
int solver_apply(const constraints *c, double (*dv)[3]);

/** r = S r, every vertex. */
void solver_filter(const constraints *c, double (*r)[3]);

/** s->residual = S (b - A z), the reference of a relative tolerance; `which` is solver_apply's. */
void solver_reference_residual(solver *s, const linear_system *system, const constraints *c,
                               int which);

/** s->residual = S (b - A dv) */
void solver_residual(solver *s, const linear_system *system, const constraints *c,
                     const double (*dv)[3]);

/** The square of the residual that is small enough, for S (b - A z) of norm sqrt(reference). */
double solver_goal(const solver_limits *limits, double reference);

/** The terms' sum, first to last. */
double solver_sum(const double *term, int count);

/**
 * Conjugate gradients in double, preconditioned by symmetric Gauss-Seidel in an order of the
 * vertices that lets many of them be swept at the same time: the vertices are cut into domains,
 * runs of near numbers, and every second domain comes first. How many there are depends on the
 * count of vertices alone, so the bits do not depend on the number of threads. Against the
 * vertices' own order 8 domains of the paper's mesh cost some 10 % more iterations.
 */
typedef struct domain_solver domain_solver;

/** NULL: out of memory. A by reference: for its layout. */
domain_solver *domain_solver_new(const block_matrix *A);
void domain_solver_free(domain_solver *d);

/** As solver_solve, which calls it; uses s->product and s->residual. */
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
