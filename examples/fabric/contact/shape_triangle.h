/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A moving triangle of the cloth against a collider that may penetrate it between its vertices. */
#ifndef FABRIC_SHAPE_TRIANGLE_H
#define FABRIC_SHAPE_TRIANGLE_H

#include "shape.h"

/** Returns the radius of the largest ball inside a collider, m. For a mesh it is unknown, and the
 *  gap is returned: thinner parts of a mesh may pass through the cloth. */
double shape_inner_radius(const collider *k);

/** Allowed depth of a triangle between its vertices, as a fraction of the inner radius. Vertices
 *  stay at the gap, so coarse triangles cut into round shapes and edges. This is allowed; passing
 *  through is not. */
#define TRIANGLE_DEPTH_PART 0.8

/**
 * Follows the triangle p (relative to the collider's position) while each corner moves by its `u`,
 * both in m in the moving collider's frame. Returns 1, with the weights of the first point of
 * contact and its data as in shape.h, or 0 if the triangle never reaches the allowed depth.
 * Distances change by no more than the displacement of the fastest corner (conservative
 * advancement, Mirtich 1996), so neither thin nor fast colliders are missed. The nearest point is
 * found by subdivision. Parts that cannot contain it are skipped by a lower bound on their
 * distance. For convex colliders the bound is the distance's tangent plane. For a mesh it follows
 * from the part's radius (with a tolerance of half the gap).
 */
int shape_meets_triangle(const collider *k, const double p[3][3], const double u[3][3],
                         double weight[3], approach *found);

#endif
