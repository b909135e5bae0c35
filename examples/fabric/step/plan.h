/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What a scene calls for, and when. An effect that the scene calls for at some time is active; it
 * is on at those times. What is not active is neither computed nor stored.
 */
#ifndef FABRIC_PLAN_H
#define FABRIC_PLAN_H

#include "effects/effect.h"
#include "simulation.h"

/** Fills the account's effects, from the scene and the mesh, at time 0. */
void plan_make(simulation *sim);

/** Brings what is on to the time at which the next step begins. */
void plan_follow(simulation *sim);

/** Makes on what was on in a step that began at `time`, at which plan_make or plan_follow last
 * found something to change. */
void plan_return_to(simulation *sim, double time);

/** The times, ascending, at which something begins or ends; `time` has room for `most`. Returns how
 *  many there are. */
int plan_events(const scene *s, double *time, int most);

#endif
