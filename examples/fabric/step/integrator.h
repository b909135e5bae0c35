/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Time integration: from the state at a step's start to the state at its end. integrator.c also has
 * evaluateForces and solveSystem of simulation.h.
 *
 * Every method here solves one implicit stage. With a base (X, V) from earlier states and a length
 * tau (s), masses M and forces f, the stage is
 *     x = X + tau v,    M (v - V) = tau f(x, v)
 * for the velocity v. A step of h s from state n ends with
 *     backward Euler     X = x_n, V = v_n, tau = h;                    x_n+1 = x, v_n+1 = v
 *     implicit midpoint  X = x_n, V = v_n, tau = h / 2;     x_n+1 = x_n + h v, v_n+1 = 2 v - v_n
 *     BDF2               X = (4 x_n - x_n-1) / 3, V likewise, tau = 2 h / 3; x_n+1 = x, v_n+1 = v
 * (BDF2 with variable steps: Hairer, Norsett and Wanner, Solving ODEs I, III.5).
 * INTEGRATOR_LINEAR_EULER solves the equation once, linearised at X = x_n, as Baraff and Witkin
 * 1998 do; the others use Newton's method.
 */
#ifndef FABRIC_INTEGRATOR_H
#define FABRIC_INTEGRATOR_H

#include "simulation.h"
#include "solver/solver.h"

typedef enum integrator_kind { /* in the order of the values of the scene's key time.integrator */
                               INTEGRATOR_LINEAR_EULER,
                               INTEGRATOR_EULER,
                               INTEGRATOR_BDF2,
                               INTEGRATOR_MIDPOINT
} integrator_kind;

/** State of an integrator; arrays that it does not need are NULL. */
typedef struct integrator_memory {
    integrator_kind kind;
    int two_states;           /* BDF2: the current stage uses two earlier states, not one */
    double (*x_before)[3];    /* BDF2: [vertices] m, the state before the last accepted one */
    double (*v_before)[3];    /* BDF2: [vertices] m/s */
    double h_before;          /* BDF2: s, length of the step from the state in x_before; 0: no
                               * earlier state */
    double (*base_x)[3];      /* [vertices] m, X */
    double (*base_v)[3];      /* [vertices] m/s, V */
    double (*at_x)[3];        /* [vertices] m, positions at which forces are evaluated: X + tau v */
    double (*at_v)[3];        /* [vertices] m/s, v */
    double (*lag)[3];         /* [vertices] m/s, as in struct expansion (outer_force.h) */
    double (*last)[3];        /* [vertices] m/s, dv of the previous iteration */
    double (*last_defect)[3]; /* [vertices] kg m/s, residual of the previous iteration */
    long iterations;          /* number of iterations of Newton's method in all steps */
    arrays own;
} integrator_memory;

/** Returns 0, or -1 if out of memory. */
int integrator_init(integrator_memory *memory, integrator_kind kind, int vertex_count);
void integrator_free(integrator_memory *memory);

/** Computes x_next and v_next from the solution of solveSystem, and corrects them so that pins and
 *  contacts hold. Returns whether all numbers are finite and memory sufficed. */
int integrator_move(simulation *sim);

/** Accepts the step that ends at x_next and v_next: for BDF2, stores the state at its beginning.
 *  Must be called before x, v and the step's contacts change. */
void integrator_accept(simulation *sim);

/* Newton's method for the stage of an integrator: newton.c. */

/** Assembles the system of Newton's first iteration. Elastic forces are expanded about x = X.
 *  Damping enters as -D(X) (v_n + dv) with the damping matrix D and the velocity v_n at the step's
 *  start. */
void newton_assemble_at_base(simulation *sim);

/**
 * Iterates until the stage's residual is below the scene's newton_tolerance, starting from the
 * system assembled at the base, after contacts and friction are found. sim->step.dv is the initial
 * guess, then the change of velocity. solver.residual gets the impulses of constraints
 * (solver_impulses).
 *
 * An iteration's matrix is positive definite, so the residual r first decreases along its step d: d
 * . r > 0. If d . r at the full step is below -0.9 times its first value, the step is too long. It
 * is cut to the zero of the secant (Dennis and Schnabel 1983, section 6.3, but with the slope
 * instead of the value, so that effects need no energy).
 */
solver_status newton_solve(simulation *sim);

#endif
