/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What acts on the cloth, effect by effect, as the linear system of a step. */
#ifndef FABRIC_FORCES_H
#define FABRIC_FORCES_H

#include "effects/outer_force.h"
#include "simulation.h"

/**
 * Fills sim->system: A = M + h D + h^2 K and b = h (m g + f(x)) - (h^2 K + h D) lag, with
 * K = -df/dx and D = -df/dv taken at x. Drag, which has no K, goes by v instead of lag. Charges
 * each effect its seconds.
 */
void forces_assemble(simulation *sim, const expansion *at);

/** The same in two parts, for an incremental potential: all that goes by velocities or acts from
 *  outside, and is expanded about the step's start alone, */
void forces_assemble_lagged(simulation *sim, const expansion *at);
/** and, added to what is in sim->system, what has an energy: stretch, shear, bend and their limit.
 */
void forces_add_elastic(simulation *sim, const expansion *at);

/** Adds what the solution dv showed to be missing, effects that begin within the step; returns how
 *  many elements that is. The system is to be solved again then. */
int forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]);

#endif
