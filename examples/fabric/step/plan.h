/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The effects of a scene, and their times. An effect is active if it ever acts, and on while it
 * acts. An inactive effect is neither computed nor stored.
 */
#ifndef FABRIC_PLAN_H
#define FABRIC_PLAN_H

#include "effects/effect.h"
#include "simulation.h"

/** Fills sim->account.effects from the scene and the mesh, for time 0. */
void plan_make(simulation *sim);

/** Updates the effects to the beginning of the next step. */
void plan_follow(simulation *sim);

/** Sets the effects to those of a step that begins at `time`. A restored simulation passes its
 *  in_force.plan_time, the time for which plan_make or plan_follow found them last. */
void plan_return_to(simulation *sim, double time);

/** Stores in `time` [most], ascending, the first times of events after time 0. An event is the
 * beginning or the end of wind, of a pin's motion or of a collider, the end of a pin, or a
 * keyframe. Returns the total number of events' times. */
int plan_events(const scene *s, double *time, int most);

#endif
