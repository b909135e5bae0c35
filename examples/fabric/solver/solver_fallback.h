/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Falls back to a direct solution (solver_direct.h) if conjugate gradients do not converge, or
 * take many times the work of a direct solution. Slivers, for instance, give systems that need
 * thousands or millions of iterations. */
#ifndef FABRIC_SOLVER_FALLBACK_H
#define FABRIC_SOLVER_FALLBACK_H

#include "solver.h"

/** The caller zeroes it; `direct` is allocated when first needed. */
typedef struct solver_fallback {
    struct direct_solver *direct;
    int failed;  /* a direct solution is impossible: CHOLMOD is missing, or out of memory */
    int costly;  /* a direct solution's estimated work exceeds a quarter of the iteration's */
    int next;    /* number of systems to solve directly before the iteration is tried again */
    long solved; /* total number of systems solved directly */
} solver_fallback;

/** After this number of iterations the cost of a direct solution is estimated. */
enum { SOLVER_MANY_ITERATIONS = 1000 };

/** Solves like solver_solve. A system that does not converge within the limits is solved directly,
 * and so are the next 50, because they are similar. Systems are also solved directly after a system
 * that took at least 1000 iterations and over four times the work of its direct solution. Work is
 * computed from the sparsity pattern, not timed, so the choice is the same on every machine. */
solver_status solver_fallback_solve(solver_fallback *f, solver *s, const linear_system *system,
                                    const constraints *c, const solver_limits *limits,
                                    double (*dv)[3], long *iterations);
void solver_fallback_free(solver_fallback *f);

#endif
