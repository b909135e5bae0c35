/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What a scene calls for, and when. An effect that the scene calls for at some time is active; it
 * is on at those times. What is not active is neither computed nor stored.
 */
#ifndef FABRIC_PLAN_H
#define FABRIC_PLAN_H

#include "simulation.h"

enum {
    EFFECT_STRETCH,
    EFFECT_SHEAR,
    EFFECT_BEND,
    EFFECT_STRETCH_DAMPING, /* the dampings' seconds are within those of the three above */
    EFFECT_SHEAR_DAMPING,
    EFFECT_BEND_DAMPING,
    EFFECT_STRAIN_LIMIT,
    EFFECT_GRAVITY,
    EFFECT_DRAG,
    EFFECT_TANGENTIAL_DRAG,
    EFFECT_WIND, /* its seconds are within drag's */
    EFFECT_PINS,
    EFFECT_CONTACT,
    EFFECT_FRICTION, /* its seconds are within contact's */
    EFFECT_SELF_COLLISION,
    EFFECT_MONITOR, /* not of the cloth's, but computed like one */
    EFFECT_COUNT
};

/* Bits of the effects that a build is to leave out, for measuring what their presence costs. */
#ifndef FABRIC_WITHOUT
#define FABRIC_WITHOUT 0
#endif

#define BUILT_WITH(effect) (((unsigned)FABRIC_WITHOUT >> (effect)&1u) == 0)

/** Fills sim->effects, from the scene and the mesh, at time 0. */
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
