/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The linear system of a step, on the free directions of constrained vertices: conjugate gradients
 * with several preconditioners and precisions (solver_factor.h), or a direct solution
 * (solver_direct.h). Block-Jacobi and Gauss-Seidel within domains, in double, are parallel. The
 * bits of the result do not depend on the number of threads: sums are over blocks of vertices that
 * the count of vertices decides, and the blocks' sums in order.
 */
#ifndef FABRIC_SOLVER_H
#define FABRIC_SOLVER_H

#include "base/arrays.h"
#include "system/constraint.h"
#include "system/system.h"

typedef enum solver_status {
    SOLVER_CONVERGED,
    SOLVER_TOO_MANY_ITERATIONS, /* dv is the best so far: each iteration lowers the energy */
    SOLVER_BREAKDOWN,           /* a direction p with p'Ap <= 0: A is not positive definite */
    SOLVER_NOT_FINITE           /* an infinity or not-a-number came up: dv is unusable */
} solver_status;

typedef enum preconditioner_kind { /* the order of the scene's key solution.preconditioner */
                                   PRECONDITIONER_GAUSS_SEIDEL,
                                   PRECONDITIONER_BLOCK_JACOBI,
                                   PRECONDITIONER_NONE,
                                   PRECONDITIONER_JACOBI,
                                   PRECONDITIONER_INCOMPLETE_CHOLESKY
} preconditioner_kind;

typedef enum solver_precision { /* the order of the scene's key solution.precision */
                                PRECISION_DOUBLE,
                                PRECISION_FLOAT, /* iteration in float, which overestimates its
                                                    accuracy */
                                PRECISION_MIXED  /* the same, repeated on the residual in double
                                                    until that is small enough */
} solver_precision;

typedef enum solver_method { /* the order of the scene's key solution.method */
                             METHOD_CONJUGATE_GRADIENTS,
                             METHOD_DIRECT /* sparse Cholesky by CHOLMOD, if built with it; double
                                              only */
} solver_method;

typedef struct solver_options {
    preconditioner_kind preconditioner;
    solver_precision precision;
    solver_method method;
    int needs_defect; /* solver_defect is called, too */
} solver_options;

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
    solver_options options;
    /* Data of the chosen method, at most one not NULL; block-Jacobi in double needs none. */
    struct domain_solver *domains; /* Gauss-Seidel in double */
    struct packed_solver *packed;  /* other conjugate gradients */
    struct direct_solver *direct;  /* METHOD_DIRECT */
    arrays own;                    /* residual, product */
    arrays jacobi;                 /* the others: block-Jacobi's */
} solver;

typedef struct solver_limits {
    double tolerance; /* of |r| against |b - A z|, in the preconditioner's norm sqrt(r'Pr) */
    double floor;     /* sqrt(kg) m/s, |r| below which a solution is good whatever b is */
    int max_iterations;
} solver_limits;

/** For block-Jacobi conjugate gradients in double. 0, or -1: out of memory. */
int solver_init(solver *s, int count);
/** Other methods, after solver_init, for matrices of A's layout; what only block-Jacobi and
 *  solver_defect need is given back where neither is called for. A is kept by reference. 0, or -1
 *  with a message in error[256]. */
int solver_choose(solver *s, const block_matrix *A, const solver_options *options, char *error);
void solver_free(solver *s);

/**
 * The error of dv: |S (b - A dv)| in the preconditioner's norm, sqrt(kg) m/s, and in *reference |S
 * (b - A z)|, to which tolerances are relative. First projects dv onto the constraints. Leaves S (b
 * - A dv) in s->residual.
 */
double solver_defect(solver *s, const linear_system *system, const constraints *c, double (*dv)[3],
                     double *reference);

/** s->residual = b - A dv, including the forces of constraints. */
void solver_impulses(solver *s, const linear_system *system, const double (*dv)[3]);

/**
 * Solves A dv = b for dv = S y + z. dv [count] m/s comes in as a guess (its free part is used) and
 * goes out as the solution; *iterations is increased by the products with A in the iteration.
 */
solver_status solver_solve(solver *s, const linear_system *system, const constraints *c,
                           const solver_limits *limits, double (*dv)[3], long *iterations);

#endif
