/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Bending, with its damping, at every hinge: two triangles that share an edge.
 *
 * With the edge x0 x1, wings x2 and x3 and the angle theta between the triangles (0: flat)
 *     C = sqrt(weight) theta,   E = k C^2 / 2   k N m,   weight = 3 |e|^2 / a  (no unit)
 * where |e| is the edge's rest length and a the rest area of the two triangles together (discrete
 * shells, Grinspun et al. 2003). Cloth is flat at rest; where the mesh is bent at rest, theta is
 * counted from the angle it has where the cloth starts. Damping: f = -kd dC (dC . v), kd N m s.
 */
#ifndef FABRIC_HINGE_H
#define FABRIC_HINGE_H

#include "base/arrays.h"
#include "mesh/mesh.h"
#include "system/system.h"

typedef struct hinge_elements {
    int count;
    int (*corner)[4]; /* [count] the edge's two vertices, then the wings' */
    int (*vertex)[4]; /* [count] the same ascending, for A's stored half */
    int (*role)[4];   /* [count] which corner each of `vertex` is */
    int (*block)[10]; /* [count] where A keeps (i,i) (i,j) (i,k) (i,l) (j,j) ... (l,l) */
    double *weight;   /* [count] */
    double *at_rest;  /* [count] rad, what angles are counted from; NULL: from 0 */
    double *angle;    /* [count] rad, unwrapped: continuous from step to step; 0 at first */
    /* Angles that hinge_energy_at found last: the angles at a step's end are those at the next
     * one's beginning. NULL until hinge_elements_look_ahead. */
    double *ahead;        /* [count] rad */
    double (*ahead_x)[3]; /* [vertices] m, at these positions */
    int vertices;         /* one above the hinges' greatest number */
    int has_ahead;        /* and `angle` has not changed since */
    arrays own;
} hinge_elements;

typedef struct hinge_material {
    double bend;         /* N m */
    double bend_damping; /* N m s */
} hinge_material;

/** The mesh's hinges; those whose triangles have no rest area are left out. 0, or -1: out of
 *  memory. */
int hinge_elements_init(hinge_elements *e, const mesh *m);
/** Lets hinge_energy_at remember the angles it finds. 0, or -1: out of memory. */
int hinge_elements_look_ahead(hinge_elements *e);
/** Notes where A keeps each hinge's blocks. 0, or -1: out of memory. */
int hinge_elements_place(hinge_elements *e, const block_matrix *A);
void hinge_elements_free(hinge_elements *e);

/** Brings e->angle to positions x: the angle nearest to the one remembered that differs from
 *  atan2's, less the one at rest, by whole turns. Doing it twice changes nothing. */
void hinge_update_angles(hinge_elements *e, const double (*x)[3]);

/** Adds the hinges' part of A and b at positions x (m) and velocities v (m/s), both [vertices], for
 *  a step of h seconds; e->angle belongs to x. Every hinge's part of A is positive semidefinite. */
void hinge_forces(const hinge_elements *e, const hinge_material *material, double h,
                  const double (*restrict x)[3], const double (*restrict v)[3], linear_system *s);

/** b += h f, f the damping of bending: as triangle_damping_forces. */
void hinge_damping_forces(const hinge_elements *e, const hinge_material *material, double h,
                          const double (*restrict x)[3], const double (*restrict v)[3],
                          double (*restrict b)[3]);

/** Energy at positions x, in J. Chooses the angles nearest to the stored ones, which it keeps. A
 *  hinge_update_angles at the same positions then costs nothing, if angles are precomputed. */
double hinge_energy_at(hinge_elements *e, const hinge_material *material, const double (*x)[3]);

#endif
