/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Air drag and wind. The force in N at each vertex of a triangle is
 *     f = -drag (a / 3) (n . (v - wind)) n      drag kg/(m^2 s)
 * with the triangle's current area a (m^2) and unit normal n, the vertex's velocity v and the
 * wind's velocity (m/s) (Provot 1995, but per area). A vertex's force depends on its own velocity
 * only, so df/dv lies in A's diagonal blocks. Tangential drag is
 *     f = -drag (a / 3) (I - n n') (v - wind)   n': n transposed
 * with another coefficient: without it, wind that blows along a flag does not move the flag.
 */
#ifndef FABRIC_DRAG_H
#define FABRIC_DRAG_H

#include "system/system.h"
#include "triangle.h"

typedef enum drag_kind { DRAG_ACROSS, DRAG_ALONG } drag_kind;

/** Adds the drag's terms to A and b at positions x (m) and velocities v (m/s), for a step of h s.
 */
void drag_forces(const triangle_elements *e, drag_kind kind, double drag, const double wind[3],
                 double h, const double (*restrict x)[3], const double (*restrict v)[3],
                 linear_system *s);

/** Returns the work in J of drag in a step of h s that began at positions x and ended with
 *  velocities v. It is positive if wind drives the cloth. Returns 0 without wind, when drag only
 *  takes energy. */
double drag_work(const triangle_elements *e, drag_kind kind, double drag, const double wind[3],
                 double h, const double (*x)[3], const double (*v)[3]);

#endif
