/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which step, integrator, tolerance and solver reach an error: by runs of the scene itself, each in
 * twice as many steps as the one before, until their differences say that it is reached. That takes
 * two or three times as long as the run that is advised, longer where the monitor cuts steps.
 */
#ifndef FABRIC_ACCURACY_ADVISE_H
#define FABRIC_ACCURACY_ADVISE_H

#include "mesh/mesh.h"
#include "scene/scene.h"

typedef struct advice {
    scene settings;     /* the scene in the advised settings; its lists are the scene's own */
    double order;       /* of the error in the step, as seen */
    double error;       /* m rms at the end, expected */
    double cpu_seconds; /* of one core, expected */
    double iterations;  /* of the conjugate gradients, all steps together, expected */
    double spread;      /* m rms at the end, of runs that start a thousandth of the error apart */
} advice;

/**
 * For an rms error (m) at the scene's end, with no more than `most_steps` steps. 0; 1: refused,
 * with the reason in reason[256]: what refinement or the tiniest change of the start changes at the
 * end is more than that. -1 after a message.
 */
int advise(const scene *s, const mesh *cloth, double error, int most_steps, advice *result,
           char *reason);

#endif
