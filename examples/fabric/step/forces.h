/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The linear system of a step, assembled effect by effect. */
#ifndef FABRIC_FORCES_H
#define FABRIC_FORCES_H

#include "effects/outer_force.h"
#include "simulation.h"

/**
 * Fills sim->system: A = M + h D + h^2 K and b = h (m g + f(x)) - (h^2 K + h D) lag, with K =
 * -df/dx and D = -df/dv at x (h, x, lag: struct expansion). Drag has no K and uses v instead of
 * lag. Adds the time spent to each effect's time.
 */
void forces_assemble(simulation *sim, const expansion *at);

/** The first of two parts of forces_assemble, for a step that minimises an energy: forces that
 *  depend on velocities, and external forces. They are linearised only once, about the beginning of
 *  the step. */
void forces_assemble_lagged(simulation *sim, const expansion *at);
/** The second part: adds to sim->system the forces that have an energy: stretch, shear, bend,
 * strain limit. */
void forces_add_elastic(simulation *sim, const expansion *at);

/** Adds to sim->system the terms of triangles that exceed the strain limit at the end of a step
 * with the solution dv, and are not in the system yet. Returns their number. If it is not 0, the
 * system must be solved again. */
int forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]);

#endif
