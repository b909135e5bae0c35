/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One run of a scene in memory: its final state and its cost. */
#ifndef FABRIC_ACCURACY_MEASURE_H
#define FABRIC_ACCURACY_MEASURE_H

#include "base/random.h"
#include "mesh/mesh.h"
#include "scene/scene.h"
#include "step/simulation.h"

typedef struct measured {
    int finished; /* 0: the simulator failed, or was stopped because of rejected steps */
    int vertices;
    double (*x)[3];     /* [vertices] m, final positions; measured_free frees them */
    double cpu_seconds; /* CPU time of the steps, all threads; minimum of the repetitions */
    long steps, rejected;
    double shortest; /* s, shortest step, from the logged rejections (at most MOST_REJECTIONS) */
    long cg_iterations, newton_iterations;
    double strain, energy; /* at the end: largest strain of a triangle; energy, J; NaN without a
                            * monitor */
    double depth;          /* m, depth of the deepest vertex in a collider during the run */
} measured;

/** No limit on rejected steps. */
enum { ANY_REJECTIONS = -1 };

/** Creates a simulation of the scene. Returns NULL after a message. */
simulation *study_simulation(const mesh *cloth, const scene *s);

/** Runs all steps of the scene `repeat` times. Returns 0, or -1 after a message if out of memory or
 *  if the scene cannot be set up. A run that fails, or in which the monitor rejects more than
 *  most_rejections steps (ANY_REJECTIONS: no limit), is a result that is not `finished`, and no
 *  error. */
int measure(const scene *s, const mesh *cloth, int repeat, long most_rejections, measured *result);
void measured_free(measured *m);

/** Returns the root mean square distance of corresponding vertices, in m; *largest receives the
 *  largest distance. NaN if either run did not finish. */
double measured_distance(const measured *a, const measured *b, double *largest);

/** Like measured_distance, but for two arrays of `count` positions; `largest` may be NULL. */
double distance_of(int count, const double (*x)[3], const double (*y)[3], double *largest);

/** Sets *to to the mesh with each coordinate moved at random by up to `most` m. The caller frees
 *  its positions; all other arrays are those of `from`. Returns 0, or -1 after a message. */
int move_start(const mesh *from, double most, random_source *source, mesh *to);

/** Returns the monitor's kinetic and elastic energy plus the gravitational potential, J. */
double total_energy(const simulation *sim);

/** Returns the scene with its duration divided into this number of steps. */
scene divided(const scene *s, int steps);

/** Returns the scene whose generated mesh has the number of vertices multiplied by `factor`. */
scene refined(const scene *s, double factor);

/** Like `divided`, but with this integrator and tolerance. INTEGRATOR_LINEAR_EULER uses `tolerance`
 *  for its linear system. Other integrators use it for Newton's method, and a tolerance of 0.1 for
 *  their linear systems. */
scene divided_by(const scene *s, int integrator, int steps, double tolerance);

/** CPU seconds of this process, all threads. */
double cpu_seconds(void);

#endif
