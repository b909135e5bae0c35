/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The times at which steps begin and end. Steps lie on the scene's grid of times, or on halves,
 * quarters, ... of it. A step with an event (plan_events) is cut in two at exactly the event's
 * time. So forces are smooth within each part, and integrators keep their order of accuracy.
 */
#ifndef FABRIC_TIMING_H
#define FABRIC_TIMING_H

#include <stdbool.h>

#include "simulation_state.h"

/** Times that differ by less than this, in s, are equal: binary fractions of a step differ from
 *  decimal times by rounding. */
static inline double timing_rounding(const simulation *sim) {
    return 1e-9 * sim->scene->time.step;
}

/** Chooses the end of the step that begins now, and sets its length, sim->step.h. */
void timing_begin(simulation *sim);

/** The time at which the current step ends, s. */
double timing_end(const simulation *sim);

/** Advances the time by the current step. */
void timing_accept(simulation *sim);

/** Is there an event (plan_events) before the end of the scene's step that begins now? */
bool timing_event_within_frame(const simulation *sim);

#endif
