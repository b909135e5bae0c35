/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Solves the linear system of a step on the free directions of constrained vertices: conjugate
 * gradients with several preconditioners and precisions (solver_factor.h), or a direct solution
 * (solver_direct.h). Block-Jacobi, and Gauss-Seidel in domains, are parallel in double. The bits of
 * the result do not depend on the number of threads: sums are computed over chunks of vertices (or
 * domains), and then over the chunks in order. The chunks depend only on the number of vertices.
 */
#ifndef FABRIC_SOLVER_H
#define FABRIC_SOLVER_H

#include "base/arrays.h"
#include "system/constraint.h"
#include "system/system.h"

typedef enum solver_status {
    SOLVER_CONVERGED,
    SOLVER_TOO_MANY_ITERATIONS, /* dv is the last iterate, the best: each one lowers the energy */
    SOLVER_BREAKDOWN,           /* a direction p with p'Ap <= 0: A is not positive definite */
    SOLVER_NOT_FINITE           /* an infinity or NaN occurred: dv is unusable */
} solver_status;

typedef enum preconditioner_kind { /* in the order of the values of the scene's key
                                    * solution.preconditioner */
                                   PRECONDITIONER_GAUSS_SEIDEL,
                                   PRECONDITIONER_BLOCK_JACOBI,
                                   PRECONDITIONER_NONE,
                                   PRECONDITIONER_JACOBI,
                                   PRECONDITIONER_INCOMPLETE_CHOLESKY
} preconditioner_kind;

typedef enum solver_precision { /* in the order of the values of the scene's key
                                 * solution.precision */
                                PRECISION_DOUBLE,
                                PRECISION_FLOAT, /* iterates in float; the residual that it computes
                                                  * is smaller than the true one */
                                PRECISION_MIXED  /* iterates in float, repeatedly, until the
                                                    residual in double is small enough */
} solver_precision;

typedef enum solver_method { /* in the order of the values of the scene's key solution.method */
                             METHOD_CONJUGATE_GRADIENTS,
                             METHOD_DIRECT /* sparse Cholesky by CHOLMOD, if built with it; double
                                              only */
} solver_method;

typedef struct solver_options {
    preconditioner_kind preconditioner;
    solver_precision precision;
    solver_method method;
    int needs_defect; /* solver_defect will be called */
} solver_options;

typedef struct solver {
    int count;  /* number of vertices */
    int chunks; /* number of chunks of vertices, for sums */
    /* b - A dv. Along given directions it is minus the impulse in kg m/s with which the constraint
     * holds the vertex. (During the iteration: S (b - A dv).) */
    double (*residual)[3];
    double (*preconditioned)[3];           /* P times the residual */
    double (*direction)[3], (*product)[3]; /* p, A p; product is 0 between iterations */
    double (*inverse)[6];                  /* P's blocks: xx xy xz yy yz zz */
    double *sum_direction, *sum_residual;  /* [chunks] partial sums of p'Ap and r'Pr */
    solver_options options;
    /* Data of the chosen method; at most one pointer is not NULL. Block-Jacobi in double needs
     * none. */
    struct domain_solver *domains; /* Gauss-Seidel in double */
    struct packed_solver *packed;  /* other conjugate gradients */
    struct direct_solver *direct;  /* METHOD_DIRECT */
    arrays own;                    /* residual, product */
    arrays jacobi;                 /* all other arrays, which block-Jacobi uses */
} solver;

typedef struct solver_limits {
    double tolerance; /* limit of |r| / |S (b - A z)| in the norm sqrt(r'Pr) of the preconditioner
                       * P */
    double floor;     /* sqrt(kg) m/s, norm of r that is small enough whatever b is */
    int max_iterations;
} solver_limits;

/** Allocates a solver with block-Jacobi conjugate gradients in double. Returns 0, or -1 if out of
 *  memory. */
int solver_init(solver *s, int count);
/** Selects another method, after solver_init, for matrices of A's layout. Frees the arrays that
 *  only block-Jacobi and solver_defect use, unless the method or options->needs_defect requires
 *  them. Keeps a reference to A. Returns 0, or -1 with a message in error[256]. */
int solver_choose(solver *s, const block_matrix *A, const solver_options *options, char *error);
void solver_free(solver *s);

/**
 * First projects dv onto the constraints. Returns |S (b - A dv)| in the preconditioner's norm,
 * sqrt(kg) m/s; *reference receives |S (b - A z)|, to which tolerances are relative. Leaves S (b -
 * A dv) in s->residual.
 */
double solver_defect(solver *s, const linear_system *system, const constraints *c, double (*dv)[3],
                     double *reference);

/** Sets s->residual = b - A dv, which includes the impulses of constraints. */
void solver_impulses(solver *s, const linear_system *system, const double (*dv)[3]);

/**
 * Solves A dv = b for dv = S y + z. dv [count] m/s is the initial guess (only its free part is
 * used), then the solution. Adds the number of iterations to *iterations.
 */
solver_status solver_solve(solver *s, const linear_system *system, const constraints *c,
                           const solver_limits *limits, double (*dv)[3], long *iterations);

#endif
