/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Forces that depend on where the cloth is, how it moves and what surrounds it, and that keep
 * nothing of their own. effects.def names them.
 */
#ifndef FABRIC_OUTER_FORCE_H
#define FABRIC_OUTER_FORCE_H

#include "scene/scene.h"
#include "system/system.h"
#include "triangle.h"

/** What forces are expanded about, all [vertices]. With the unknown dv, the change of velocity, a
 *  step of h ends at positions x + h (lag + dv) and velocities v + dv. */
typedef struct expansion {
    double h;               /* s */
    const double (*x)[3];   /* m, positions of forces and derivatives */
    const double (*lag)[3]; /* m/s; v where x is where the step starts */
    const double (*v)[3];   /* m/s, at the start of the step */
} expansion;

/** The cloth and what surrounds it, by reference. */
typedef struct force_target {
    const scene_surroundings *surroundings;
    const triangle_elements *triangles;
    const double *wind; /* [3] m/s, at present */
} force_target;

typedef struct outer_force {
    /** Adds its part of A and b, as forces_assemble says. Called only where the effect is on. */
    void (*add)(const force_target *on, const expansion *at, linear_system *s);
    /** The work in J that it did in a step of h s that began at positions x and ended with
     * velocities v, by the same formula; 0 where it is absent, and may be 0 where it only takes
     * energy. */
    double (*work)(const force_target *on, double h, const double (*x)[3], const double (*v)[3]);
} outer_force;

#define OUTER_FORCE(NAME, name) extern const outer_force outer_force_##name;
#include "effects.def"

#endif
