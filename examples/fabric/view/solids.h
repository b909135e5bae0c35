/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Draws colliders with OpenGL's fixed functions, into the current context. */
#ifndef FABRIC_VIEW_SOLIDS_H
#define FABRIC_VIEW_SOLIDS_H

#include "scene/scene.h"

/** A box, sphere or cylinder where it is at `time` (s), with normals; draws nothing for a plane. */
void solids_draw(const collider *c, double time);

/** A point of a plane at `time`, and its unit normal then. */
void solids_plane(const collider *c, double time, double point[3], double normal[3]);

/** A plane as tiles around the point of it nearest to `middle`, that fade into the background's
 *  colour at the distance `reach` (m). */
void solids_draw_plane(const collider *c, double time, const double middle[3], double reach,
                       const float background[3]);

#endif
