/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A moving triangle of the cloth against a collider: what goes through between its vertices. */
#ifndef FABRIC_SHAPE_TRIANGLE_H
#define FABRIC_SHAPE_TRIANGLE_H

#include "shape.h"

/** The radius of the largest ball within a collider, m; for a mesh, of which it is not known, its
 * gap: thinner parts of one may go through. */
double shape_inner_radius(const collider *k);

/** A triangle may lie this part of that radius deep in a collider between its vertices. Vertices
 * are kept at the gap, and a triangle between them cuts into what is round or has edges, the more
 * the coarser the cloth; what it must not do is to go through. */
#define TRIANGLE_DEPTH_PART 0.8

/**
 * Follows the triangle p (from the collider's position) while each corner goes along its `u`, both
 * m and relative to the moving collider. 1, with the weights of the point that touches first and
 * what is known of it as for a vertex (shape.h); 0: it stays above that depth. Neither the
 * collider's thinness nor its speed makes it miss: distances change by no more than the way of the
 * fastest corner (conservative advancement, Mirtich 1996). The nearest point is sought in parts of
 * the triangle, those left out that cannot hold it: by the distance's tangent plane, which bounds a
 * convex collider's distance from below, or for a mesh by the part's radius, in parts down to half
 * of the gap.
 */
int shape_meets_triangle(const collider *k, const double p[3][3], const double u[3][3],
                         double weight[3], approach *found);

#endif
