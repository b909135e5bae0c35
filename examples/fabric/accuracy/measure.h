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
    double (*x)[3];     /* [vertices] m, at the end; measured_free frees it */
    double cpu_seconds; /* of the process, all threads, in the steps; minimum of the repetitions */
    long steps, rejected;
    double shortest; /* s, shortest step, from the logged rejections (at most MOST_REJECTIONS) */
    long cg_iterations, newton_iterations;
    double strain, energy; /* at the end: the largest strain of a triangle; J. NaN without a
                            * monitor, as is depth */
    double depth;          /* m, of the deepest vertex in a collider during the run */
} measured;

/** No limit on rejected steps. */
enum { ANY_REJECTIONS = -1 };

/** NULL after a message. */
simulation *study_simulation(const mesh *cloth, const scene *s);

/** Runs all steps of the scene `repeat` times. 0, or -1 after a message (out of memory, a scene
 * that cannot be set up); a run that does not finish is a result. */
int measure(const scene *s, const mesh *cloth, int repeat, long most_rejections, measured *result);
void measured_free(measured *m);

/** Root mean square and largest distance of corresponding vertices, in m; NaN if either run did
 *  not finish. */
double measured_distance(const measured *a, const measured *b, double *largest);

/** The same for two arrays of `count` positions; `largest` may be NULL. */
double distance_of(int count, const double (*x)[3], const double (*y)[3], double *largest);

/** The mesh with each coordinate moved by up to `most` m at random. The caller frees its
 *  positions; all other arrays are `from`'s. 0, or -1 after a message. */
int move_start(const mesh *from, double most, random_source *source, mesh *to);

/** The monitor's kinetic and elastic energy plus gravitational potential, J. */
double total_energy(const simulation *sim);

/** The scene with its duration divided into this number of steps. */
scene divided(const scene *s, int steps);

/** The scene with `factor` times as many vertices, for a generated mesh. */
scene refined(const scene *s, double factor);

/** `divided`, by this integrator, to this tolerance: of the linear system, or of Newton's method,
 *  whose linear systems are solved less accurately. */
scene divided_by(const scene *s, int integrator, int steps, double tolerance);

/** CPU seconds of this process, all threads. */
double cpu_seconds(void);

#endif
