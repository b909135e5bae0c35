/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A moving triangle of the cloth against a collider: what goes through between its vertices. */
#ifndef FABRIC_SHAPE_TRIANGLE_H
#define FABRIC_SHAPE_TRIANGLE_H

#include "shape.h"

/** The radius of the largest ball inside a collider, m. For a mesh it is unknown, and its gap is
 *  returned: thinner parts may pass. */
double shape_inner_radius(const collider *k);

/** Allowed depth of a triangle between its vertices, as a fraction of that radius. Vertices stay
 *  at the gap, and coarse triangles cut into round shapes and edges; they must not pass through. */
#define TRIANGLE_DEPTH_PART 0.8

/**
 * Follows the triangle p (from the collider's position) while each corner moves by its `u`, both m
 * and relative to the moving collider. 1 with the weights of the first point of contact and the
 * data of shape.h; 0: the triangle stays above that depth. Distances change by no more than the
 * displacement of the fastest corner (conservative advancement, Mirtich 1996), so neither thin nor
 * fast colliders are missed. The nearest point is found by subdivision. Parts that cannot contain
 * it are skipped: by the tangent plane of the distance, a lower bound for convex colliders, or for
 * a mesh by the part's radius, down to half the gap.
 */
int shape_meets_triangle(const collider *k, const double p[3][3], const double u[3][3],
                         double weight[3], approach *found);

#endif
