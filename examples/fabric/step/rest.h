/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Sleeping cloth. Cloth falls asleep if no vertex was faster than the scene's `sleep` (m/s) at the
 * end of STEPS_UNTIL_SLEEP steps in a row. It then stays unchanged, at no cost, until the next
 * event (plan_events). It is awake while a collider or pin moves or wind blows.
 */
#ifndef FABRIC_REST_H
#define FABRIC_REST_H

#include "simulation.h"

enum { STEPS_UNTIL_SLEEP = 10 };

/** Does the cloth sleep through the scene's next step? Wakes it if there is an event. */
int rest_lasts(simulation *sim);

/** Called after a step of the scene: counts consecutive slow steps. Sets all velocities to 0 when
 *  the cloth falls asleep. */
void rest_watch(simulation *sim);

#endif
