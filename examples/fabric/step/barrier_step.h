/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A step of a scene with `contact: barrier`: backward Euler as a minimum. The positions at its end
 * are those of the least
 *     E(dv) = dv' C dv / 2 - b' dv + W(x) + B(x) + F(x),   x = x_n + h (v_n + dv)
 * with W stretch, shear and bend, B the barrier and F friction (barrier.h); C and b hold masses,
 * gravity, damping, drag and wind, expanded about the step's start (forces_assemble_lagged). So the
 * gradient by dv is C dv - b - h f(x), the equation of motion.
 *
 * Newton's method with projected Hessians (Li et al. 2020, algorithm 1), whose directions are made
 * conjugate: each change of positions is cut by what continuous collision detection allows, then
 * halved until E does not grow, or taken as far as E falls. What
 * pins and bodies move goes first: with them the free vertices go where the linear system says,
 * cut alike, until the driven ones are where they end the step; from then on E alone counts.
 */
#ifndef FABRIC_BARRIER_STEP_H
#define FABRIC_BARRIER_STEP_H

#include <signal.h>

#include "contact/barrier.h"
#include "contact/barrier_system.h"
#include "simulation.h"

/** Where the last iteration went. */
typedef struct barrier_descent {
    double (*direction)[3]; /* [vertices] m/s, */
    double (*residual)[3];  /* [vertices] J s/m: -dE/d(dv) at that point */
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
    double begin_energy;  /* J, of the barrier where the step began */
    double work;          /* J, work of bodies in the step, less the energy that the barrier took */
    double (*trial)[3];   /* [surface's vertices] m */
    barrier_descent descent;
    double still_way;                  /* m, a way that is none */
    double longest_way;                /* m, of a vertex in an iteration */
    int blocked;                       /* driven vertices could not reach their goals */
    const volatile sig_atomic_t *stop; /* not 0: the step is to end at once; NULL: never */
    unsigned char *kept;               /* where there is `stop`: the simulation before the step */
    arrays own;                        /* of those above, all but the last */
} barrier_step;

/** Only with `contact: barrier`. After all else of the simulation is made. 0, or -1 with a message
 *  in error[200]: also where the cloth starts in itself or a body. */
int barrier_step_init(simulation *sim, char *error);
void barrier_step_free(simulation *sim);

/* The phases of a step, in the place of those of integrator.h and collision.h. */
void barrier_step_forces(simulation *sim);
void barrier_step_detect(simulation *sim);
void barrier_step_solve(simulation *sim);
/** Returns whether all is finite. */
int barrier_step_move(simulation *sim);

#endif
