/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A step of a scene with `contact: barrier`: backward Euler as a minimisation. A step of h s from
 * positions x_n and velocities v_n changes the velocities by the dv that minimises
 *     E(dv) = dv' C dv / 2 - b' dv + W(x) + B(x) + F(x),   x = x_n + h (v_n + dv)
 * W is the energy of stretch, shear and bend, B the barrier's and F friction's (barrier.h). C and b
 * contain masses, gravity, damping, drag and wind, linearised about the step's start
 * (forces_assemble_lagged). So the gradient with respect to dv is C dv - b - h f(x), with f = -d(W
 * + B + F)/dx: minus the residual of the equation of motion.
 *
 * The method is Newton's with projected Hessians (Li et al. 2020, algorithm 1) and conjugate
 * directions. Each displacement is cut to the fraction that continuous collision detection allows,
 * then a line search decreases E. First, driven vertices (of pins and bodies) move to their
 * positions at the step's end, and the free vertices follow as the linear system requires, with the
 * same cuts but without a line search. From then on E is minimised over the free vertices.
 */
#ifndef FABRIC_BARRIER_STEP_H
#define FABRIC_BARRIER_STEP_H

#include "contact/barrier.h"
#include "contact/barrier_system.h"
#include "simulation.h"

/** Results of the last iteration of Newton's method. */
typedef struct barrier_descent {
    double (*direction)[3]; /* [vertices] m/s, the search direction */
    double (*residual)[3];  /* [vertices] J s/m, -dE/d(dv) at the iteration's beginning */
    double along;           /* J, product of residual and Newton's direction; 0: no iteration yet */
    double slope;           /* J, slope of E along the direction */
} barrier_descent;

typedef struct barrier_step {
    barrier contact;
    barrier_system system;
    double (*base)[3][3]; /* [blocks of the cloth's matrix] C */
    double (*base_b)[3];  /* [vertices] b */
    double (*dv)[3];      /* [vertices] m/s, change of velocity for the current trial positions */
    double (*product)[3]; /* [vertices] C dv */
    double (*still)[3];   /* [vertices] 0 m/s */
    double (*change)[3];  /* [vertices] m/s, solution of the linear system */
    double begin_energy;  /* J, energy of the barrier at the step's beginning */
    double work;        /* J, work of bodies in the step, less the energy that the barrier gained */
    double (*trial)[3]; /* [surface's vertices] m */
    barrier_descent descent;
    double still_distance;       /* m, largest displacement that ends the iteration */
    double longest_displacement; /* m, limit of a vertex's displacement in an iteration */
    int blocked;                 /* driven vertices could not reach their goals */
    arrays own;                  /* all arrays above */
} barrier_step;

/** Initialises the barrier's part of the simulation, after all other parts. Returns 0, or -1 with a
 *  message in error[200], for instance if the cloth starts in itself or a body. */
int barrier_step_init(simulation *sim, char *error);
void barrier_step_free(simulation *sim);

/* The phases of a step, in place of those of integrator.h and collision.h. */
void barrier_step_forces(simulation *sim);
void barrier_step_detect(simulation *sim);
void barrier_step_solve(simulation *sim);
/** Returns whether all numbers are finite. */
int barrier_step_move(simulation *sim);

#endif
