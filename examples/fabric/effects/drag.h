/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Air drag and wind. At each vertex of a triangle with unit normal n and (current) area a
 *     f = -drag (a / 3) (n . (v - wind)) n      drag kg/(m^2 s)
 * so that df/dv couples no two vertices: A's diagonal blocks hold all of it. Tangential drag is
 *     f = -drag (a / 3) (I - n n') (v - wind)
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

/** The work in J that drag did in a step of h s that began at positions x and ended with velocities
 *  v, by the same formula: positive where wind drives the cloth. */
double drag_work(const triangle_elements *e, drag_kind kind, double drag, const double wind[3],
                 double h, const double (*x)[3], const double (*v)[3]);

#endif
