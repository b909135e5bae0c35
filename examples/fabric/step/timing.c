/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "timing.h"

#include <assert.h>
#include <math.h>

/* Returns the next multiple of the step's length in ticks, even if a cut step ended between
 * multiples. */
static int next_on_grid(const simulation *sim) {
    return (sim->state.ticks_done / sim->step.ticks + 1) * sim->step.ticks;
}

void timing_begin(simulation *sim) {
    const double begin = simulation_time(sim), event = sim->in_force.next_event;
    struct step *to = &sim->step;
    to->end_ticks = next_on_grid(sim);
    to->end_part = 0;
    if (event > begin && event < time_at_tick(sim, to->end_ticks) - timing_rounding(sim)) {
        const double in_frame = event - time_at_tick(sim, 0);
        to->end_ticks = (int)floor(in_frame / ticks_to_seconds(sim, 1));
        to->end_part = event - time_at_tick(sim, to->end_ticks);
    }
    const bool is_whole = sim->state.part == 0 && to->end_part == 0;
    assert(to->end_ticks >= sim->state.ticks_done);
    to->h = is_whole ? ticks_to_seconds(sim, to->end_ticks - sim->state.ticks_done)
                     : timing_end(sim) - begin;
    assert(to->h > 0);
}

double timing_end(const simulation *sim) {
    return time_at_tick(sim, sim->step.end_ticks) + sim->step.end_part;
}

void timing_accept(simulation *sim) {
    assert(sim->step.end_ticks <= TICKS_PER_STEP);
    sim->state.ticks_done = sim->step.end_ticks;
    sim->state.part = sim->step.end_part;
    if (sim->state.ticks_done < TICKS_PER_STEP)
        return;
    sim->state.ticks_done = 0;
    sim->state.frame++;
}

bool timing_event_within_frame(const simulation *sim) {
    return sim->in_force.next_event < time_at_tick(sim, TICKS_PER_STEP) - timing_rounding(sim);
}
