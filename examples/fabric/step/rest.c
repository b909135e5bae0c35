/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "rest.h"

#include <string.h>

#include "base/vector.h"
#include "simulation_state.h"
#include "timing.h"

int rest_lasts(simulation *sim) {
    if (!(sim->scene->solution.sleep > 0))
        return 0;
    plan_follow(sim);
    return sim->step.slow_steps >= STEPS_UNTIL_SLEEP && !timing_event_within_frame(sim);
}

/* Does wind, a pin or a collider move the cloth now, or could it begin to do so without an event
 * (plan_events)? */
static int is_driven(const simulation *sim) {
    const scene *s = sim->scene;
    const double time = simulation_time(sim);
    if (sim->account.effects[EFFECT_WIND].on)
        return 1;
    for (int p = 0; p < s->pin_count; p++)
        if (vector_length(s->pins[p].velocity) > 0 &&
            !(s->pins[p].move_until > 0 && time >= s->pins[p].move_until))
            return 1;
    for (int n = 0; n < s->collider_count; n++)
        if (sim->collisions.there[n] && time < motion_end(&s->colliders[n]))
            return 1;
    return 0;
}

/* Returns the square of the fastest vertex's speed, or infinity if a speed is NaN. */
static double greatest_square(const simulation *sim) {
    double greatest = 0;
    const double(*v)[3] = (const double(*)[3])sim->state.v;
#pragma omp parallel for schedule(static) reduction(max : greatest)
    for (int i = 0; i < sim->mesh->vertex_count; i++) {
        const double square = vector_dot(v[i], v[i]);
        greatest = square <= greatest ? greatest : (isfinite(square) ? square : INFINITY);
    }
    return greatest;
}

void rest_watch(simulation *sim) {
    const double sleep = sim->scene->solution.sleep;
    if (!(sleep > 0))
        return;
    sim->step.slow_steps =
        greatest_square(sim) <= sleep * sleep && !is_driven(sim) ? sim->step.slow_steps + 1 : 0;
    if (sim->step.slow_steps == STEPS_UNTIL_SLEEP)
        memset(sim->state.v, 0, sizeof *sim->state.v * (size_t)sim->mesh->vertex_count);
}
