/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Small cloths for the physics tests, made without the simulator's mesh code. */
#ifndef FABRIC_TEST_CLOTH_H
#define FABRIC_TEST_CLOTH_H

#include "contact/collision.h"
#include "effects/hinge.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

/** Returns a reproducible random number in [-1, 1). */
double random_number(unsigned *state);

/** Returns a sheet of columns x rows vertices, `spacing` m apart, flat in z = 0 with a corner at
 * the origin. Inner vertices are moved by up to `jitter` spacings, diagonals have either direction,
 * and vertices are numbered at random. Material coordinates are the positions. */
mesh cloth_sheet(int columns, int rows, double spacing, double jitter, unsigned seed);

/** Returns the given triangles of the given material points, which are also the positions (z = 0).
 * Hinges are found by comparing all pairs of triangles. */
mesh cloth_of(int vertices, const double (*material)[2], int triangles, const int (*triangle)[3]);

void cloth_free(mesh *m);

/** Returns a scene with soft cloth, gravity, no colliders or pins, steps of 10 ms and a tolerance
 * of 1e-10. */
scene cloth_scene(void);

/** Returns copies of the positions, each coordinate moved by up to `size` m. The caller frees
 * them. */
double (*cloth_moved(const mesh *m, double size, unsigned seed))[3];

/** Returns the energy of the remembered angles, J. */
double hinge_energy(const hinge_elements *e, const hinge_material *material);

/** Counts the contacts of the last accepted step, and those that stick. Either pointer may be
 * NULL. */
void collisions_count(const collisions *c, long *contacts, long *sticking);

#endif
