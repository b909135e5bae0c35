/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Small cloths for the physics tests, made without the simulator's mesh code. */
#ifndef FABRIC_TEST_CLOTH_H
#define FABRIC_TEST_CLOTH_H

#include "contact/collision.h"
#include "effects/hinge.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

/** A reproducible number in [-1, 1). */
double random_number(unsigned *state);

/** A sheet of columns x rows vertices, `spacing` m apart, flat in z = 0 with a corner at the
 *  origin; inner vertices jittered by up to `jitter` spacings, diagonals either way, and vertices
 *  numbered at random. Material coordinates are the positions. */
mesh cloth_sheet(int columns, int rows, double spacing, double jitter, unsigned seed);

/** The given triangles of the given material points, which are also the positions (z = 0). Hinges
 *  are found by comparing all pairs of triangles. */
mesh cloth_of(int vertices, const double (*material)[2], int triangles, const int (*triangle)[3]);

void cloth_free(mesh *m);

/** A scene with soft cloth, gravity, no colliders nor pins, 10 ms steps, tolerance 1e-10. */
scene cloth_scene(void);

/** Copies of the positions, each coordinate moved by up to `size` m. The caller frees. */
double (*cloth_moved(const mesh *m, double size, unsigned seed))[3];

/** Energy of the angles remembered, in J. */
double hinge_energy(const hinge_elements *e, const hinge_material *material);

/** Contacts of the last accepted step; and of them, how many stick. Either may be NULL. */
void collisions_count(const collisions *c, long *contacts, long *sticking);

#endif
