/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan.h"

#include <assert.h>

#include "base/vector.h"
#include "simulation_state.h"
#include "timing.h"

/* Returns the time of the next event after `after`, or infinity if there is none. At an event wind,
 * a pin, a pin's motion or a collider begins or ends, or a keyframe is reached. */
static double next_event(const scene *s, double after) {
    double next = INFINITY;
#define CONSIDER(time)                                                                             \
    if ((time) > after && (time) < next)                                                           \
        next = (time);
    CONSIDER(s->surroundings.wind_from)
    CONSIDER(s->surroundings.wind_until)
    for (int p = 0; p < s->pin_count; p++) {
        CONSIDER(s->pins[p].until)
        CONSIDER(s->pins[p].move_from)
        CONSIDER(s->pins[p].move_until)
    }
    for (int n = 0; n < s->collider_count; n++) {
        CONSIDER(s->colliders[n].from)
        CONSIDER(s->colliders[n].until)
        for (int k = 0; k < s->colliders[n].keyframe_count; k++)
            CONSIDER(s->colliders[n].keyframes[k].time)
    }
#undef CONSIDER
    return next;
}

int plan_events(const scene *s, double *time, int most) {
    int count = 0;
    for (double at = next_event(s, 0); isfinite(at); at = next_event(s, at)) {
        if (count < most)
            time[count] = at;
        count++;
    }
    return count;
}

static void set_effect(simulation *sim, int effect, const char *name, int active, long elements) {
    assert(effect >= 0 && effect < EFFECT_COUNT);
    sim->account.effects[effect] = (effect_account){
        .name = name, .active = active, .on = active, .elements = active ? elements : 0};
}

static int has_friction(const scene *s) {
    for (int n = 0; n < s->collider_count; n++)
        if (s->colliders[n].friction > 0)
            return 1;
    return 0;
}

/* Switches effects on or off for a step that begins at `time`. */
static void switch_effects(simulation *sim, double time) {
    const scene *s = sim->scene;
    const int blows = time >= s->surroundings.wind_from &&
                      (s->surroundings.wind_until <= 0 || time < s->surroundings.wind_until);
    sim->account.effects[EFFECT_WIND].on = sim->account.effects[EFFECT_WIND].active && blows;
    for (int a = 0; a < 3; a++)
        sim->in_force.wind[a] = sim->account.effects[EFFECT_WIND].on ? s->surroundings.wind[a] : 0;
    sim->account.effects[EFFECT_PINS].on = sim->collisions.pinned.count > 0;
    sim->account.effects[EFFECT_CONTACT].on = sim->collisions.any_there > 0;
    sim->account.effects[EFFECT_FRICTION].on =
        sim->account.effects[EFFECT_FRICTION].active && sim->account.effects[EFFECT_CONTACT].on;
}

void plan_make(simulation *sim) {
    const scene *s = sim->scene;
    const int triangles = sim->cloth.triangles.count, vertices = sim->mesh->vertex_count;
    const int hinges = sim->cloth.hinges.count, pinned = sim->collisions.pinned.count;
#define EFFECT(NAME, text, active, elements) set_effect(sim, EFFECT_##NAME, text, active, elements);
#include "effects/effects.def"
    plan_return_to(sim, 0);
}

void plan_return_to(simulation *sim, double time) {
    collisions_follow(&sim->collisions, time);
    switch_effects(sim, time);
    sim->in_force.next_event = next_event(sim->scene, time);
    sim->in_force.plan_time = time;
}

void plan_follow(simulation *sim) {
    const double time = simulation_time(sim) + timing_rounding(sim);
    if (time < sim->in_force.next_event)
        return;
    plan_return_to(sim, time);
    sim->account.plans_changed++;
    sim->step.slow_steps = 0;
}
