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
 * stage's residual is below the scene's newton_tolerance. sim->step.dv holds a guess before and the
 * change of velocity after; solver.residual what the constraints take, as after solver_solve.
 *
 * An iteration's matrix is positive definite, so the residual r falls along its step d at first:
 * d . r > 0. Where d . r at the full step is below -0.9 of that, the step has gone too far and is
 * cut to where the secant puts the zero (Dennis and Schnabel 1983, section 6.3, with the slope in
 * place of the value: no effect needs an energy).
 */
solver_status newton_solve(simulation *sim);

#endif
