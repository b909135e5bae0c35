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
    double (*x)[3];     /* [vertices] m, at the end; measured_free's */
    double cpu_seconds; /* of the process, all threads, in the steps; least of the repetitions */
    long steps, rejected;
    double shortest; /* s, shortest step; only logged rejections are known */
    long cg_iterations, newton_iterations;
    double strain, energy; /* at the end: of the most stretched triangle; J. Both, and depth, are
                            * NaN without a monitor */
    double depth;          /* m, of the deepest vertex in a collider, in all of the run */
} measured;

/** No limit on rejected steps. */
enum { ANY_REJECTIONS = -1 };

/** NULL after a message. */
simulation *study_simulation(const mesh *cloth, const scene *s);

/** Runs all steps of the scene `repeat` times. 0, or -1 after a message (out of memory, a scene
 * that cannot be set up); a run that does not finish is a result. */
int measure(const scene *s, const mesh *cloth, int repeat, long most_rejections, measured *result);
void measured_free(measured *m);

/** Root mean square and largest distance of the vertices, in m; not a number where either run did
 *  not finish. */
double measured_distance(const measured *a, const measured *b, double *largest);

/** The same of `count` vertices; `largest` may be NULL. */
double distance_of(int count, const double (*x)[3], const double (*y)[3], double *largest);

/** The mesh with each coordinate moved by up to `most` m at random; its other arrays are `from`'s,
 *  its positions to be freed. 0, or -1 after a message. */
int move_start(const mesh *from, double most, random_source *source, mesh *to);

/** Kinetic, elastic and potential energy, J, as the monitor computes it. */
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
