/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The simulation of one cloth, with its counts and times: the loop of figure 2 of the paper
 *  (docs/paper.md). */
#ifndef FABRIC_SIMULATION_H
#define FABRIC_SIMULATION_H

#include <signal.h>
#include <stddef.h>

#include "mesh/mesh.h"
#include "scene/scene.h"

typedef struct phase {
    double seconds; /* wall */
    long calls;
} phase;

typedef struct effect_account {
    const char *name; /* "stretch", "shear", "bend", ... */
    int active;       /* the effect acts at some time in the scene */
    int on;           /* the effect acts now */
    long elements;    /* number of triangles, hinges, ... that the effect processes per step */
    long visited;     /* number of elements processed in all steps */
    double seconds;   /* wall */
} effect_account;

typedef struct simulation simulation;

/** A step that was repeated at half the length. */
typedef struct rejection {
    const char *reason;  /* from monitor_verdict_name */
    double time, h;      /* s, the step's beginning and length */
    double value, limit; /* the value that exceeded a limit, and the limit */
} rejection;

/* The log stores the first rejections up to this number; all are counted. */
enum { MOST_REJECTIONS = 1000 };

/** Keeps references to mesh and scene, which must outlive the simulation. Returns NULL with a
 *  message in error[256] on failure. */
simulation *simulation_new(const mesh *m, const scene *s, char *error);
void simulation_free(simulation *sim);

/* The four phases of a step, in this order (figure 2). updateSystem accepts the step, or rejects
 * it: then positions and velocities are unchanged, and the next round takes half its length. */
void evaluateForces(simulation *sim);
void collisionDetection(simulation *sim);
void solveSystem(simulation *sim);
void updateSystem(simulation *sim);

/** Allocates the arrays that the first step's search for self-collisions needs, so that memory can
 *  be measured. The simulation must not be run afterwards. */
void simulation_make_room(simulation *sim);

/** Returns the memory that a direct solution would allocate, bytes, or 0 if the program does not
 *  support it. Sets *only if the scene requires direct solutions (otherwise they are a
 *  fall-back). */
double simulation_direct_bytes(const simulation *sim, int *only);

/** From now on each round of the four phases uses the fastest number of threads, at most OpenMP's
 *  (team.h), instead of OpenMP's. The bits are the same. */
void simulation_choose_threads(simulation *sim);
/** Returns the current number of threads, or 0 if all are used. */
int simulation_threads(const simulation *sim);

/** From now on a step that may take long checks *stop: with `contact: barrier` in each iteration,
 *  and otherwise after each of its parts if it has been halved. If *stop is not 0, simulation_step
 *  restores the state before the step and returns 1, unless memory was short. Keeps the pointer. */
void simulation_stop_when(simulation *sim, const volatile sig_atomic_t *stop);

/** Makes one step of the scene: the four phases, timed, repeated until the step's end is reached.
 *  Returns 0, or 1 if stopped, or -1 with a message in error[256] if no state within the scene's
 *  limits could be reached. */
int simulation_step(simulation *sim, char *error);

/* Returns the size in bytes of the state between two steps of the scene, in this machine's formats.
 * A simulation of the same mesh and scene continues from the state with the same bits. */
size_t simulation_saved_size(simulation *sim);
/** Writes the state to bytes [size]; size must be simulation_saved_size. Does not change the
 *  simulation. */
void simulation_save(simulation *sim, unsigned char *bytes, size_t size);
/** Restores the state in a new simulation. Returns 0, or -1 if the bytes are invalid for it; the
 *  simulation must then be freed. Does not change the bytes. */
int simulation_restore(simulation *sim, unsigned char *bytes, size_t size);

/* Read access for callers; valid until simulation_free. */
const double (*simulation_positions(const simulation *sim))[3];
const double (*simulation_velocities(const simulation *sim))[3];
double simulation_time(const simulation *sim);
enum { PHASE_FORCES, PHASE_COLLISIONS, PHASE_SOLVE, PHASE_UPDATE, PHASE_COUNT };
const phase *simulation_phases(const simulation *sim); /* [PHASE_COUNT] */
const effect_account *simulation_effects(const simulation *sim, int *count);
/** Sets *count to the number of logged rejections, at most MOST_REJECTIONS. */
const rejection *simulation_rejections(const simulation *sim, int *count);

/** Counts of a run so far. */
typedef struct run_counts {
    long iterations;        /* number of iterations of conjugate gradients in all steps */
    long newton_iterations; /* number of linear systems solved for Newton's method */
    long taken;             /* number of steps accepted, including the parts of halved ones */
    long rejected;          /* number of steps rejected */
    long slept;             /* number of the scene's steps through which the cloth slept */
    long matrix_blocks;     /* number of stored 3x3 blocks */
} run_counts;

run_counts simulation_counts(const simulation *sim);

/** Faults that a run tolerated. */
typedef struct run_faults {
    /* Steps that the monitor accepted because halving would not help: */
    long not_solved, strain, penetration, passing;
    double greatest_strain, strain_limit; /* largest strain of a triangle during the run; the
                                           * scene's limit */
    double deepest;                       /* m, greatest depth of a vertex in a collider */
    long start_inside;                    /* number of vertices that start in a collider */
    double start_depth;                   /* m, depth of the deepest of them */
    int watched;          /* the monitor is on; otherwise strain and depth are unknown */
    long solved_directly; /* number of systems solved by the fall-back (solver_fallback.h) */
} run_faults;

run_faults simulation_faults(const simulation *sim);

#endif
