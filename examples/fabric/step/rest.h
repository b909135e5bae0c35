/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Sleeping cloth: one of which no vertex was faster than the scene's `sleep` (m/s) at the end of
 * STEPS_UNTIL_SLEEP steps in a row stays where it is, and its steps cost nothing, until something
 * begins or ends (plan.h). While a collider or pin moves, or wind blows, it is awake.
 */
#ifndef FABRIC_REST_H
#define FABRIC_REST_H

#include "simulation.h"

enum { STEPS_UNTIL_SLEEP = 10 };

/** Does the cloth sleep through the step of the scene that begins now? Wakes it if something
 *  begins or ends. */
int rest_lasts(simulation *sim);

/** A step of the scene has ended: is the cloth at rest? What falls asleep has no velocity. */
void rest_watch(simulation *sim);

#endif
