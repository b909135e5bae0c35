/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Forces that depend only on the cloth's positions and velocities and on its surroundings: they
 * store no state. effects.def lists them.
 */
#ifndef FABRIC_OUTER_FORCE_H
#define FABRIC_OUTER_FORCE_H

#include "scene/scene.h"
#include "system/system.h"
#include "triangle.h"

/** The point about which forces are linearised; arrays are [vertices]. A step of h s ends at
 *  positions x + h (lag + dv) and velocities v + dv with the unknown change of velocity dv. */
typedef struct expansion {
    double h;               /* s */
    const double (*x)[3];   /* m, positions at which forces and their derivatives are evaluated */
    const double (*lag)[3]; /* m/s; equal to v if x is the step's start */
    const double (*v)[3];   /* m/s, velocities at the start of the step */
} expansion;

/** The cloth and its surroundings, neither of them owned. */
typedef struct force_target {
    const scene_surroundings *surroundings;
    const triangle_elements *triangles;
    const double *wind; /* [3] m/s, current wind */
} force_target;

typedef struct outer_force {
    /** Adds the force's terms to A and b (see forces_assemble). Called only if the effect is on. */
    void (*add)(const force_target *on, const expansion *at, linear_system *s);
    /** Returns the force's work in J in a step of h s that began at positions x and ended with
     *  velocities v, or 0 if the force is absent. May return 0 if the force only takes energy. */
    double (*work)(const force_target *on, double h, const double (*x)[3], const double (*v)[3]);
} outer_force;

#define OUTER_FORCE(NAME, name) extern const outer_force outer_force_##name;
#include "effects.def"

#endif
