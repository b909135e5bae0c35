/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Scenes with `contact: barrier`, and a check that nothing passes through anything. */
#ifndef FABRIC_TEST_BARRIER_SCENE_H
#define FABRIC_TEST_BARRIER_SCENE_H

#include "stage.h"

/** A floor at z = 0. */
extern const collider barrier_ground;

/** Returns an upright pole that is thinner than the sheets' edges are long. */
collider barrier_pole(double radius);

/** Returns a scene with steps of 20 ms and a gap of 4 mm everywhere. */
scene barrier_scene(int colliders, collider *list);

/** Returns copies of one sheet, each moved by `aside` along x and `apart` along z relative to the
 * previous copy. */
mesh barrier_layers(int count, int columns, double spacing, double low, double apart, double aside);

/** Returns the number of current intersections: of cloth with cloth and with each body, and
 * vertices below planes. */
int barrier_passing(const stage *on);

/** Runs to the end. Checks that nothing passes in any frame, that no step is rejected, and that the
 * monitor permits no passage. Returns the CPU seconds of the steps. */
double barrier_run_stage(const char *name, stage *on, int steps);
/** Like barrier_run_stage, with a stage of this scene and mesh; frees the mesh. */
void barrier_run(const char *name, mesh m, scene s, int steps);

/** Checks that the start is refused with a message that contains `expected`. */
void barrier_refused(const char *name, mesh m, scene s, const char *expected);

#endif
