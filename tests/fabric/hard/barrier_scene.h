/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scenes with `contact: barrier`, and whether anything passes in them. */
#ifndef FABRIC_TEST_BARRIER_SCENE_H
#define FABRIC_TEST_BARRIER_SCENE_H

#include "stage.h"

/** A floor at z = 0. */
extern const collider barrier_ground;

/** An upright pole, thinner than an edge of the sheets. */
collider barrier_pole(double radius);

/** Steps of 20 ms, a gap of 4 mm everywhere. */
scene barrier_scene(int colliders, collider *list);

/** Copies of one sheet, each moved by `aside` along x and `apart` along z against the one before.
 */
mesh barrier_layers(int count, int columns, double spacing, double low, double apart, double aside);

/** What passes now: cloth through cloth, through each body, and vertices below planes. */
int barrier_passing(const stage *on);

/** Runs to the end: nothing passes in any frame, no step is rejected, nothing is let pass. Returns
 * CPU seconds of the steps. */
double barrier_run_stage(const char *name, stage *on, int steps);
/** The same of a scene of its own; the mesh goes with it. */
void barrier_run(const char *name, mesh m, scene s, int steps);

/** The start is refused, with this in the message. */
void barrier_refused(const char *name, mesh m, scene s, const char *expected);

#endif
