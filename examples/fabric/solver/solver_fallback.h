/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What to do where the conjugate gradients do not converge, or take many times the work of a
 * direct solution: solve directly (solver_direct.h), for slivers and the like make a system that
 * takes them thousands or millions of iterations. */
#ifndef FABRIC_SOLVER_FALLBACK_H
#define FABRIC_SOLVER_FALLBACK_H

#include "solver.h"

/** Empty at first; allocated at the first solution that does not converge. */
typedef struct solver_fallback {
    struct direct_solver *direct;
    int failed;  /* there is no direct solution to be had: not built in, or no memory */
    int costly;  /* it was estimated, and costs more than the iteration */
    int next;    /* this many systems are solved directly before the iteration is tried again */
    long solved; /* systems solved directly, in all */
} solver_fallback;

/** After this number of iterations the cost of a direct solution is estimated. */
enum { SOLVER_MANY_ITERATIONS = 1000 };

/** As solver_solve; what does not converge within the limits is solved directly, and so are the
 * next systems, which are much like it. So are the next ones after a system that took 1000
 * iterations or more and over four times the work of its direct solution, both counted from the
 * layout, never timed: the choice is the same on every machine. */
solver_status solver_fallback_solve(solver_fallback *f, solver *s, const linear_system *system,
                                    const constraints *c, const solver_limits *limits,
                                    double (*dv)[3], long *iterations);
void solver_fallback_free(solver_fallback *f);

#endif
