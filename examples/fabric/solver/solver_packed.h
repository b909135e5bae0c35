/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Conjugate gradients with any preconditioner and precision, sequentially; see solver_factor.h. */
#ifndef FABRIC_SOLVER_PACKED_H
#define FABRIC_SOLVER_PACKED_H

#include "solver.h"

typedef struct packed_solver packed_solver;

/** NULL: out of memory. A by reference: for its layout. */
packed_solver *packed_solver_new(const block_matrix *A, const solver_options *options);
void packed_solver_free(packed_solver *p);

/** As solver_solve, which calls it; uses s->product and s->residual. */
solver_status packed_solver_solve(packed_solver *p, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations);

#endif
