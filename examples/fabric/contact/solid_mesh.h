/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Colliders as triangles: for files, and for barriers (barrier.h). */
#ifndef FABRIC_SOLID_MESH_H
#define FABRIC_SOLID_MESH_H

#include "scene/scene.h"

/** The collider's surface, counter-clockwise from outside, around its position as the origin; a
 *  plane as a square around the point of it nearest to `middle`, out to `reach` (m). No edges, no
 *  hinges; mesh_free frees it. 0, or -1: out of memory. */
int solid_mesh(const collider *c, const double middle[3], double reach, mesh *m);

#endif
