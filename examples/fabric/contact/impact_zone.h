/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Impact zones (Provot 1997; Bridson, Fedkiw and Anderson 2002; Harmon et al. 2008): vertices of
 *  pairs that impulses could not keep from passing move together in the step, so that nothing
 *  passes between them. */
#ifndef FABRIC_IMPACT_ZONE_H
#define FABRIC_IMPACT_ZONE_H

#include "impulse.h"
#include "self_collision.h"

/** Joins the vertices of passing pairs to zones, each of which gets the velocities of a rigid
 *  body with its momenta; a zone with vertices that a pin or contact holds moves like these.
 *  Zones grow by pairs that pass at their boundary, until none does or the number of rounds is
 *  exhausted. Adds the required energy to *work, J. s->left counts the pairs that still pass. 0,
 *  or -1: out of memory. */
int impact_zones_make(self_collision *s, const movable *of, double h, const double (*x)[3],
                      double (*v)[3], double *work);

#endif
