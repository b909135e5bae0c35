/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds step, integrator, tolerance and solver for a requested error by running the scene. First,
 * two integrators, with the number of steps doubled each time, must agree on the final state: the
 * reference. The error of any other run is its distance from the reference. The advised settings
 * have been run themselves. All of this takes three to six times as long as the advised run, longer
 * if the monitor halves steps.
 */
#ifndef FABRIC_ACCURACY_ADVISE_H
#define FABRIC_ACCURACY_ADVISE_H

#include "mesh/mesh.h"
#include "scene/scene.h"

typedef struct advice {
    scene settings;     /* the scene with the advised settings; shares the scene's lists */
    double error;       /* m rms at the end, an upper bound: the distance from the most exact run,
                         * plus that run's distance from the final state by a second method */
    double cpu_seconds; /* CPU time of the run, all threads */
    double iterations;  /* of conjugate gradients, all steps together */
    double spread;      /* m rms at the end, between runs whose starts differ by a thousandth of the
                         * error */
} advice;

/**
 * Advises settings for an rms error (m) at the scene's end, with no more than `most_steps` steps.
 * 0; 1: refused, with the reason in reason[256]: two integrators do not agree, no run is exact
 * enough, or a tiny change of the start changes the end too much. -1 after a message.
 */
int advise(const scene *s, const mesh *cloth, double error, int most_steps, advice *result,
           char *reason);

#endif
