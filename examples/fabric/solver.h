/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Conjugate gradients with a block-Jacobi preconditioner, on the free directions of constrained
 * vertices. The bits of the result do not depend on the number of threads: sums are taken over
 * blocks of vertices of a fixed size, and the blocks' sums in order.
 */
#ifndef FABRIC_SOLVER_H
#define FABRIC_SOLVER_H

#include "constraint.h"
#include "system.h"

typedef enum solver_status {
    SOLVER_CONVERGED,
    SOLVER_TOO_MANY_ITERATIONS, /* dv is the best so far: each iteration lowers the energy */
    SOLVER_BREAKDOWN,           /* a direction p with p'Ap <= 0: A is not positive definite */
    SOLVER_NOT_FINITE           /* an infinity or not-a-number came up: dv is unusable */
} solver_status;

typedef struct solver {
    int count;  /* vertices */
    int chunks; /* of vertices, for sums */
    /* b - A dv: along given directions, minus the impulse in kg m/s by which the constraint holds
       the vertex. (While iterating, S times that.) */
    double (*residual)[3];
    double (*preconditioned)[3];           /* P residual */
    double (*direction)[3], (*product)[3]; /* p, A p; product is 0 between iterations */
    double (*inverse)[6];                  /* P's blocks: xx xy xz yy yz zz */
    double *sum_direction, *sum_residual;  /* [chunks] partial sums of p'Ap and r'Pr */
} solver;

typedef struct solver_limits {
    double tolerance; /* of |r| against |b - A z|, in the preconditioner's norm sqrt(r'Pr) */
    double floor;     /* sqrt(kg) m/s, |r| below which a solution is good whatever b is */
    int max_iterations;
} solver_limits;

/** 0, or -1: out of memory. */
int solver_init(solver *s, int count);
void solver_free(solver *s);

/**
 * How far dv is from the solution: |S (b - A dv)| in the preconditioner's norm, sqrt(kg) m/s, and
 * in *reference |S (b - A z)|, what a relative tolerance goes by. dv is first made to meet the
 * constraints. s->residual holds S (b - A dv) afterwards.
 */
double solver_defect(solver *s, const linear_system *system, const constraints *c, double (*dv)[3],
                     double *reference);

/** s->residual = b - A dv, with what the constraints take. */
void solver_impulses(solver *s, const linear_system *system, const double (*dv)[3]);

/**
 * Solves A dv = b for dv = S y + z. dv [count] m/s comes in as a guess (its free part is used) and
 * goes out as the solution; *iterations is increased by the products with A in the iteration.
 */
solver_status solver_solve(solver *s, const linear_system *system, const constraints *c,
                           const solver_limits *limits, double (*dv)[3], long *iterations);

#endif
