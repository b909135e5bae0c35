/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * After the system is solved: velocities are changed so that in the step the cloth goes neither
 * through itself nor through a body. Both together, since what one pushes the other may have to
 * push back: rounds of impulses over the cloth's own pairs, the vertices that came too near to a
 * body and the triangles that meet one between their vertices. What still passes after that moves
 * as one: impact zones (impact_zone.h).
 */
#ifndef FABRIC_IMPACT_H
#define FABRIC_IMPACT_H

#include "collision.h"
#include "impulse.h"
#include "self_collision.h"

typedef struct impact_step {
    double time, h;         /* s */
    const double (*x)[3];   /* [vertices] m, at its beginning */
    double (*v)[3];         /* [vertices] m/s, changed */
    movable of;             /* what may move */
    self_collision *itself; /* NULL: the cloth may go through itself */
    collisions *bodies;
} impact_step;

/** Resolves contacts of the step. *work: the work of bodies, J, less the energy that the cloth's
 *  own impulses take. Energy that these add is not counted as external work, so the monitor
 *  detects it. 0, or -1: out of memory, or the step ends in something not finite. */
int impact_resolve(impact_step *step, double *work);

#endif
