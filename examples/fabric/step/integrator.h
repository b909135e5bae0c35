/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * From the state at a step's start to the one at its end. evaluateForces and solveSystem
 * (simulation.h) are the integrator's as well.
 *
 * Every method here solves one implicit stage: with a base (X, V) from the past and a length tau,
 *     x = X + tau v,    M (v - V) = tau f(x, v)
 * for the velocity v, and ends the step with
 *     backward Euler     X = x_n, V = v_n, tau = h;                    x_n+1 = x, v_n+1 = v
 *     implicit midpoint  X = x_n, V = v_n, tau = h / 2;     x_n+1 = x_n + h v, v_n+1 = 2 v - v_n
 *     BDF2               X, V: of the two states before, tau = 2 h / 3; x_n+1 = x, v_n+1 = v
 * (BDF2 for steps of changing length: Hairer, Norsett and Wanner, Solving ODEs I, III.5). The first
 * method solves the equation linearised at X = x_n once, as Baraff and Witkin 1998 do; the others
 * iterate by Newton's method.
 */
#ifndef FABRIC_INTEGRATOR_H
#define FABRIC_INTEGRATOR_H

#include "simulation.h"
#include "solver/solver.h"

typedef enum integrator_kind { /* the order of the scene's key time.integrator */
                               INTEGRATOR_LINEAR_EULER,
                               INTEGRATOR_EULER,
                               INTEGRATOR_BDF2,
                               INTEGRATOR_MIDPOINT
} integrator_kind;

/** State of an integrator; arrays that it does not need are NULL. */
typedef struct integrator_memory {
    integrator_kind kind;
    int two_states;           /* BDF2: the stage under way rests on two states, not one */
    double (*x_before)[3];    /* BDF2: [vertices] m, the state before the last accepted one */
    double (*v_before)[3];    /* BDF2: [vertices] m/s */
    double h_before;          /* BDF2: s, the step from there to the last; 0: there is none */
    double (*base_x)[3];      /* [vertices] m, X */
    double (*base_v)[3];      /* [vertices] m/s, V */
    double (*at_x)[3];        /* [vertices] m, positions at which forces are evaluated: X + tau v */
    double (*at_v)[3];        /* [vertices] m/s, v */
    double (*lag)[3];         /* [vertices] m/s */
    double (*last)[3];        /* [vertices] m/s, dv of the iteration before */
    double (*last_defect)[3]; /* [vertices] kg m/s, its residual */
    long iterations;          /* of Newton's method, all */
    arrays own;
} integrator_memory;

/** 0, or -1: out of memory. */
int integrator_init(integrator_memory *memory, integrator_kind kind, int vertex_count);
void integrator_free(integrator_memory *memory);

/** Computes x_next and v_next from the solution of solveSystem, respecting pins and colliders;
 *  returns whether all are finite. */
int integrator_move(simulation *sim);

/** The step ends at x_next and v_next: stores the state at its beginning, if needed. Must be
 *  called before x, v and the step's contacts change. */
void integrator_accept(simulation *sim);

/* Newton's method for the stage of an integrator: newton.c. */

/** Expands the forces about x = X, v = 0: the first iteration starts there. */
void newton_assemble_at_base(simulation *sim);

/**
 * With the system assembled at the base, and contacts and friction found: iterates until the
 * stage's residual is below the scene's newton_tolerance. sim->step.dv is the initial guess, then
 * the change of velocity; solver.residual holds the forces of constraints, as after solver_solve.
 *
 * An iteration's matrix is positive definite, so the residual r first decreases along its step d: d
 * . r > 0. If d . r at the full step is below -0.9 of that, the step is too long and is cut to the
 * zero of the secant (Dennis and Schnabel 1983, section 6.3, with the slope in place of the value:
 * no effect needs an energy).
 */
solver_status newton_solve(simulation *sim);

#endif
