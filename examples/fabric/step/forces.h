/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What acts on the cloth, effect by effect, as the linear system of a step. */
#ifndef FABRIC_FORCES_H
#define FABRIC_FORCES_H

#include "effects/outer_force.h"
#include "simulation.h"

/**
 * Fills sim->system: A = M + h D + h^2 K and b = h (m g + f(x)) - (h^2 K + h D) lag, with K =
 * -df/dx and D = -df/dv at x. Drag has no K and uses v instead of lag. Adds the time to each
 * effect.
 */
void forces_assemble(simulation *sim, const expansion *at);

/** The same in two parts, for an incremental potential: forces that depend on velocities or are
 *  external, expanded about the beginning of the step only, */
void forces_assemble_lagged(simulation *sim, const expansion *at);
/** and, added to sim->system, forces with an energy: stretch, shear, bend and their limit. */
void forces_add_elastic(simulation *sim, const expansion *at);

/** Adds elements of effects that begin within the step, as the solution dv shows; returns their
 *  number. The system must then be solved again. */
int forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]);

#endif
