/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds step, integrator, tolerance and solver for a requested error by running the scene. First,
 * two integrators run it, each time with twice as many steps, until their final states agree: one
 * of these states is the reference. The error of any other run is its distance from the reference.
 * The advised settings have been run themselves. All of this takes three to six times as long as
 * the advised run, longer if the monitor halves steps.
 */
#ifndef FABRIC_ACCURACY_ADVISE_H
#define FABRIC_ACCURACY_ADVISE_H

#include "mesh/mesh.h"
#include "scene/scene.h"

typedef struct advice {
    scene settings;     /* the scene with the advised settings; shares the scene's lists */
    double error;       /* m rms at the end, an upper bound: the distance from the most exact run,
                         * plus that run's distance from the final state by the second integrator */
    double cpu_seconds; /* CPU time of the advised run, all threads */
    double iterations;  /* iterations of conjugate gradients in all steps */
    double spread;      /* m rms distance at the end between runs whose starts differ by a
                         * thousandth of the error */
} advice;

/**
 * Advises settings for an rms error (m) at the scene's end, with no more than `most_steps` steps.
 * Returns 0, -1 after a message, or 1 with a reason in reason[256]. Reasons are: two integrators do
 * not agree, no run has an error this small, or a tiny change of the start changes the end too
 * much.
 */
int advise(const scene *s, const mesh *cloth, double error, int most_steps, advice *result,
           char *reason);

#endif
