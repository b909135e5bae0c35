/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the methods of solution. */
#ifndef FABRIC_SOLVER_PARTS_H
#define FABRIC_SOLVER_PARTS_H

#include "solver.h"
#include "system/constraint.h"

/** Vertices of a partial sum: a part of the result's bits, so not to be tuned by machine. */
enum { SOLVER_CHUNK = 64 };

enum { UNCONSTRAINED, CONSTRAINED, DRIVEN /* and some z is not 0 */ };

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

/** Conjugate gradients with any preconditioner and precision, sequentially; see solver_factor.h. */
typedef struct packed_solver packed_solver;

/** NULL: out of memory. A by reference: for its layout. */
packed_solver *packed_solver_new(const block_matrix *A, const solver_options *options);
void packed_solver_free(packed_solver *p);

/** As solver_solve, which calls it; uses s->product and s->residual. */
solver_status packed_solver_solve(packed_solver *p, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations);

#endif
