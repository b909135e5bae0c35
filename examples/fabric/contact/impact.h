/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * After the system is solved, velocities are changed so that in the step the cloth passes neither
 * through itself nor through a body. Both are handled together, since an impulse of one may have to
 * be undone by the other. Each round gives impulses to the cloth's own pairs, to the vertices that
 * came too near to a body, and to the triangles that a body penetrates between their vertices.
 * Features that still pass after the rounds move as one rigid body: impact zones.
 */
#ifndef FABRIC_IMPACT_H
#define FABRIC_IMPACT_H

#include "collision.h"
#include "impulse.h"
#include "self_collision.h"

typedef struct impact_step {
    double time, h;         /* s */
    const double (*x)[3];   /* [vertices] m, positions at the step's beginning */
    double (*v)[3];         /* [vertices] m/s, velocities, which are changed */
    movable of;             /* the vertices that may move */
    self_collision *itself; /* NULL: the cloth may go through itself */
    collisions *bodies;
} impact_step;

/** Resolves contacts of the step. *work: the work of bodies, J, less the energy that the cloth's
 *  own impulses take. Energy that these add is not counted as external work, so the monitor detects
 *  it. Returns 0, or -1 if out of memory or if a number at the step's end is not finite. */
int impact_resolve(impact_step *step, double *work);

/**
 * Impact zones (Provot 1997; Bridson, Fedkiw and Anderson 2002; Harmon et al. 2008): vertices of
 * pairs that impulses could not keep from passing move together in the step, so that nothing passes
 * between them.
 *
 * Joins the vertices of passing pairs to zones. Each zone gets the velocities of a rigid body with
 * the zone's linear and angular momentum. But a zone with vertices that a pin or contact holds
 * moves with their mean velocity. Zones grow by pairs that pass at their boundary, until none does
 * or the number of rounds is exhausted. Adds the required energy to *work, J. s->left counts the
 * pairs that still pass. Returns 0, or -1 if out of memory or if a number is not finite.
 */
int impact_zones_make(self_collision *s, const movable *of, double h, const double (*x)[3],
                      double (*v)[3], double *work);

#endif
