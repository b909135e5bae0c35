/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One cloth in time: the loop of figure 2 of the paper, and its accounts. */
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
    int active;       /* the scene calls for it at some time */
    int on;           /* it acts at present */
    long elements;    /* triangles, hinges, ... it works on each step */
    long visited;     /* elements it worked on, all steps together */
    double seconds;   /* wall */
} effect_account;

typedef struct simulation simulation;

/** A step that was taken again at half the length. */
typedef struct rejection {
    const char *reason;  /* "energy", "strain", "penetration", "not solved", "not finite" */
    double time, h;      /* s, its beginning and its length */
    double value, limit; /* the value and its limit */
} rejection;

/* The log keeps the first ones; all are counted. */
enum { MOST_REJECTIONS = 1000 };

/** Takes mesh and scene by reference: they must outlive it. NULL and a message in error[256]. */
simulation *simulation_new(const mesh *m, const scene *s, char *error);
void simulation_free(simulation *sim);

/* The four phases of a step, in this order (figure 2). updateSystem accepts the step, or rejects
 * it: then positions and velocities stay, and the next round takes half of its length. */
void evaluateForces(simulation *sim);
void collisionDetection(simulation *sim);
void solveSystem(simulation *sim);
void updateSystem(simulation *sim);

/** Allocates the arrays of the first step, to measure them; not for a simulation that is to run. */
void simulation_make_room(simulation *sim);

/** The memory of a direct solution, bytes, beyond the present allocations; 0: not supported by
 *  this program. *only: the scene requires it (otherwise it is a fall-back). */
double simulation_direct_bytes(const simulation *sim, int *only);

/** From now on each step uses the fastest number of threads, up to OpenMP's (team.h), instead of
 *  all of these. The bits are the same. */
void simulation_choose_threads(simulation *sim);
/** The number of threads at present; 0: all. */
int simulation_threads(const simulation *sim);

/** From now on a step with `contact: barrier`, which may take long, checks *stop in each of its
 *  iterations. If it is not 0, simulation_step returns 1 and restores the state before the step.
 *  Keeps the reference. 0, or -1: out of memory. */
int simulation_stop_when(simulation *sim, const volatile sig_atomic_t *stop);

/** One step of the scene: the four phases, timed, as often as it takes. 0; 1: stopped; or -1 with a
 *  message in error[256]: no state within the scene's limits could be reached. */
int simulation_step(simulation *sim, char *error);

/* The state between two steps of the scene, as bytes that this machine can read. A simulation of
 * the same mesh and scene continues from it with the same bits. */
size_t simulation_saved_size(simulation *sim);
/** bytes: [size], of simulation_saved_size. Changes nothing of the simulation. */
void simulation_save(simulation *sim, unsigned char *bytes, size_t size);
/** Restores the state of a simulation that has just been made. 0, or -1: the bytes are not of such
 *  a simulation, which must then be freed. Leaves the bytes unchanged. */
int simulation_restore(simulation *sim, unsigned char *bytes, size_t size);

/* Read access for callers; valid until simulation_free. */
const double (*simulation_positions(const simulation *sim))[3];
const double (*simulation_velocities(const simulation *sim))[3];
double simulation_time(const simulation *sim);
enum { PHASE_FORCES, PHASE_COLLISIONS, PHASE_SOLVE, PHASE_UPDATE, PHASE_COUNT };
const phase *simulation_phases(const simulation *sim); /* [PHASE_COUNT] */
const effect_account *simulation_effects(const simulation *sim, int *count);
/** *count: of those logged, at most MOST_REJECTIONS. */
const rejection *simulation_rejections(const simulation *sim, int *count);

/** What a run has counted so far. */
typedef struct run_counts {
    long iterations;        /* of conjugate gradients, all */
    long newton_iterations; /* systems solved by Newton's method */
    long taken;             /* steps accepted, parts of halved ones included */
    long rejected;          /* steps */
    long slept;             /* steps of the scene, through which it slept */
    long matrix_blocks;     /* stored 3x3 blocks */
} run_counts;

run_counts simulation_counts(const simulation *sim);

/** Faults of a run that ended. */
typedef struct run_faults {
    /* steps that the monitor let pass since they could not be halved any more */
    long not_solved, strain, penetration, passing;
    double greatest_strain, strain_limit; /* of a triangle in all of the run; the scene's limit */
    double deepest;                       /* m, of a vertex in a collider */
    long start_inside;                    /* vertices that start in a collider */
    double start_depth;                   /* m, depth of the deepest of them */
    int watched;          /* the monitor is on: else strain and depth are not known */
    long solved_directly; /* systems, because the conjugate gradients did not converge */
} run_faults;

run_faults simulation_faults(const simulation *sim);

#endif
