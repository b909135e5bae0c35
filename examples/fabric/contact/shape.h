/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shapes of colliders: their signed distance, the approach of a moving point, and their
 *  triangles. */
#ifndef FABRIC_SHAPE_H
#define FABRIC_SHAPE_H

#include "scene/scene.h"

/** Returns the signed distance (m, negative inside) of point p, relative to the collider's
 *  position. `normal` receives the unit direction in which the distance grows. */
double shape_distance(const collider *k, const double p[3], double normal[3]);

typedef struct approach {
    double normal[3];  /* unit normal, out of the collider */
    double room;       /* m, how far the point may still move against the normal; < 0: it must be
                        * pushed out */
    double beyond;     /* m, distance of the path's end beyond `room`; < 0: it ends before */
    double carried[3]; /* m/s, velocity of the collider's material there; filled in by motion.h */
} approach;

/**
 * Follows p (relative to the collider's position) along the straight path `u`, both in m in the
 * moving collider's frame. Returns 1, with the first place at which the distance falls to the
 * collider's gap in *found, or 0 if the distance stays above the gap. Each advance is as long as
 * the distance allows (sphere tracing, Hart 1996), so neither thin colliders nor long paths are
 * missed. A point on the outer side of the plane through that place is outside a convex shape. In
 * the hollow of a mesh it may meet another face; the next step finds that.
 */
int shape_approach(const collider *k, const double p[3], const double u[3], approach *found);

/** Creates the collider's surface, counter-clockwise from outside, relative to its position. A
 *  plane becomes a square of half side `reach` (m) around its point nearest to `middle`. The mesh
 *  has no edges or hinges; mesh_free frees it. Returns 0, or -1 if out of memory. */
int solid_mesh(const collider *c, const double middle[3], double reach, mesh *m);

#endif
