/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Impact zones (Provot 1997; Bridson, Fedkiw and Anderson 2002; Harmon et al. 2008): vertices of
 *  pairs that impulses could not keep from passing move together in the step, so that nothing
 *  passes between them. */
#ifndef FABRIC_IMPACT_ZONE_H
#define FABRIC_IMPACT_ZONE_H

#include "impulse.h"
#include "self_collision.h"

/** Joins the vertices of the pairs that pass to zones and gives each the velocities of a rigid body
 *  with the zone's momenta; one with a vertex that a pin or a contact holds moves as those held do.
 *  Pairs that pass between zones or at a zone's boundary make them grow: until none does, or it has
 * been tried often. Adds the energy that takes to *work, J. s->left tells what still passes; 0, or
 * -1: out of memory. */
int impact_zones_make(self_collision *s, const movable *of, double h, const double (*x)[3],
                      double (*v)[3], double *work);

#endif
