/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Colliders as distances, and whether a moving point would come too near to one. */
#ifndef FABRIC_SHAPE_H
#define FABRIC_SHAPE_H

#include "scene/scene.h"

/** Signed distance (m, negative inside) of point p, given from the collider's position, and the
 *  unit direction in which it grows. */
double shape_distance(const collider *k, const double p[3], double normal[3]);

typedef struct approach {
    double normal[3]; /* unit, out of the collider */
    double room;      /* m the point may still go against the normal; < 0: it is to be pushed out */
    double beyond;    /* m its path ends past that; < 0: short of it */
    double carried[3]; /* m/s, the collider's matter there: for motion.h to fill in */
} approach;

/**
 * Follows p (from the collider's position) along the straight path `u`, both m and relative to the
 * moving collider. 1, and what is known at the first place where the distance falls to the
 * collider's gap; 0: there is none, and the path ends further away than the gap. No thinness of the
 * collider nor length of the path makes it miss: it goes as far as the distance allows each time
 * (sphere tracing, Hart 1996). A point kept to the outer side of the plane through that place
 * is kept out of a convex shape; in the hollow of a mesh it may meet another side of it, which is
 * then found in the next step.
 */
int shape_approach(const collider *k, const double p[3], const double u[3], approach *found);

#endif
