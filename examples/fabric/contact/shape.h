/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Colliders as distances, whether a moving point would come too near to one, and their triangles.
 */
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
 * moving collider. 1 and the first place at which the distance falls to the collider's gap; 0: the
 * path ends farther away than the gap. Each advance is as long as the distance allows (sphere
 * tracing, Hart 1996), so neither thin colliders nor long paths are missed. A point on the outer
 * side of the plane through that place is outside a convex shape; in the hollow of a mesh it may
 * meet another side, which the next step finds.
 */
int shape_approach(const collider *k, const double p[3], const double u[3], approach *found);

/** The collider's surface, counter-clockwise from outside, around its position as the origin; a
 *  plane as a square around the point of it nearest to `middle`, out to `reach` (m). No edges, no
 *  hinges; mesh_free frees it. 0, or -1: out of memory. */
int solid_mesh(const collider *c, const double middle[3], double reach, mesh *m);

#endif
