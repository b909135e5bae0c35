/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The times at which steps begin and end. Steps lie on the scene's grid of times, or on halves,
 * quarters, ... of it. Where something begins or ends within a step (plan.h) it is cut in two, at
 * exactly that time: forces are smooth within each part, so that methods keep their order.
 */
#ifndef FABRIC_TIMING_H
#define FABRIC_TIMING_H

#include <stdbool.h>

#include "simulation_state.h"

/** Times that differ by less are the same, s: times in binary fractions of a step miss decimal ones
 *  by a rounding. */
static inline double timing_rounding(const simulation *sim) {
    return 1e-9 * sim->scene->time.step;
}

/** Chooses where the step that begins now ends, and sets its length step.h. */
void timing_begin(simulation *sim);

/** That time, s. */
double timing_end(const simulation *sim);

/** The step that timing_begin chose is done. */
void timing_accept(simulation *sim);

/** Does something begin or end before the scene's step that begins now ends? */
bool timing_event_within_frame(const simulation *sim);

#endif
