/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A cloth, its scene and its simulation, for the tests of hard cases. */
#ifndef FABRIC_TEST_STAGE_H
#define FABRIC_TEST_STAGE_H

#include "check.h"
#include "cloth.h"
#include "step/simulation.h"
#include "step/simulation_state.h"

typedef struct stage {
    mesh m;
    scene s;
    simulation *sim;
} stage;

/** Returns a stage that owns the mesh. Until stage_begin, scene and mesh may be changed. */
stage stage_of(mesh m, scene s);

/** Returns a stage with a small sheet at z = 0 and one collider. */
stage stage_with(collider *k);

/** Returns a stage of slivers, on which the conjugate gradients fail, so the systems are solved
 * directly. */
stage stage_of_slivers(void);

/** Makes the simulation. From now on the stage must not be moved in memory. */
void stage_begin(stage *on);
/** Frees cloth and simulation. If FABRIC_STAGE_BITS is set, appends a line with a hash of the final
 * state to that file, which hard/bits.sh compares. */
void stage_end(stage *on);
/** True if a test shall only produce hashes of states (hard/bits.sh) and omit its other checks,
 * which another run makes. */
int stage_compares_bits(void);

/** Must be called after a test has changed the state: resets the values that the monitor compares
 * with. */
void stage_changed(stage *on);

/** Makes steps of the scene. The test fails if a step fails. */
void stage_run(stage *on, int steps);

/** Returns the kinetic and elastic energy, J. */
double stage_energy(const stage *on);

/** Returns the current area of the triangles, m^2. */
double stage_area(const stage *on);

/** Returns the largest distance, m, between vertex i here and vertex of[i] there; `of` may be NULL
 * for i itself. */
double stage_distance(const stage *on, const stage *other, const int *of);

void stage_assert_finite(const stage *on);

#endif
