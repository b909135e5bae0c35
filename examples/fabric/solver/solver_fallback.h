/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Falls back to a direct solution (solver_direct.h) if the conjugate gradients do not converge, or
 *  take many times its work. Slivers, for instance, give systems that need thousands or millions of
 *  iterations. */
#ifndef FABRIC_SOLVER_FALLBACK_H
#define FABRIC_SOLVER_FALLBACK_H

#include "solver.h"

/** Empty at first; allocated at the first solution that does not converge. */
typedef struct solver_fallback {
    struct direct_solver *direct;
    int failed;  /* a direct solution is impossible: not built in, or no memory */
    int costly;  /* its estimated cost exceeds that of the iteration */
    int next;    /* this many systems are solved directly before the iteration is tried again */
    long solved; /* systems solved directly, in all */
} solver_fallback;

/** After this number of iterations the cost of a direct solution is estimated. */
enum { SOLVER_MANY_ITERATIONS = 1000 };

/** As solver_solve. A system that does not converge within the limits is solved directly, and so
 *  are the next ones, because they are similar. The same holds after a system that took 1000
 *  iterations or more, and over four times the work of its direct solution. Work is counted from
 *  the layout, never timed: the choice is the same on every machine. */
solver_status solver_fallback_solve(solver_fallback *f, solver *s, const linear_system *system,
                                    const constraints *c, const solver_limits *limits,
                                    double (*dv)[3], long *iterations);
void solver_fallback_free(solver_fallback *f);

#endif
