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

/** The stage owns the mesh. Not begun yet: scene and mesh may be changed. */
stage stage_of(mesh m, scene s);

/** A small sheet at z = 0, with one collider. */
stage stage_with(collider *k);

/** Slivers on which the conjugate gradients give up: the systems are solved directly. */
stage stage_of_slivers(void);

/** Makes the simulation; the stage must stay where it is from now on. */
void stage_begin(stage *on);
/** Frees cloth and simulation. Where the environment has FABRIC_STAGE_BITS, a line in that file
 * tells the bits in which the run ended: hard/bits.sh compares them. */
void stage_end(stage *on);
/** Whether bits are compared: all else is checked by the runs where they are not. */
int stage_compares_bits(void);

/** After a test changed the state: what the monitor compares with. */
void stage_changed(stage *on);

/** Steps of the scene; fails the test if one fails. */
void stage_run(stage *on, int steps);

/** Kinetic and elastic energy, J. */
double stage_energy(const stage *on);

/** Area of the triangles as they are, m^2. */
double stage_area(const stage *on);

/** The largest distance of two positions, m: of vertex i here and vertex of[i] (NULL: i) there. */
double stage_distance(const stage *on, const stage *other, const int *of);

void stage_assert_finite(const stage *on);

#endif
