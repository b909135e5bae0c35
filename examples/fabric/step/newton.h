/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Newton's method for the stage of an integrator (integrator.h). */
#ifndef FABRIC_NEWTON_H
#define FABRIC_NEWTON_H

#include "simulation.h"
#include "solver/solver.h"

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
