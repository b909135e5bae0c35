/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** From the state at a step's start to the one at its end. evaluateForces and solveSystem
 *  (simulation.h) are the integrator's as well. */
#ifndef FABRIC_INTEGRATOR_H
#define FABRIC_INTEGRATOR_H

#include "simulation.h"

/** x_next and v_next from what solveSystem found, pins and colliders kept to; returns whether all
 *  of them are finite. */
int integrator_move(simulation *sim);

#endif
