/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Draws colliders with OpenGL's fixed-function pipeline into the current context. */
#ifndef FABRIC_VIEW_SOLIDS_H
#define FABRIC_VIEW_SOLIDS_H

#include "scene/scene.h"

/** Draws a box, sphere, cylinder or mesh, with normals, at its pose at `time` (s). Draws nothing
 *  for a plane. */
void solids_draw(const collider *c, double time);

/** Computes a point of a plane and its unit normal, both at `time`. */
void solids_plane(const collider *c, double time, double point[3], double normal[3]);

/** Draws a plane as tiles around its point nearest to `middle`. At the distance `reach` (m) the
 *  tiles have faded to the background's colour. */
void solids_draw_plane(const collider *c, double time, const double middle[3], double reach,
                       const float background[3]);

#endif
