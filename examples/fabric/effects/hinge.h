/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Bending, with its damping, at every hinge: two triangles that share an edge.
 *
 * The edge is x0 x1. The wings x2 and x3 are the triangles' third vertices. theta is the angle
 * between the triangles (rad, 0: flat). Condition C, energy E (J) and damping force f (N) are
 *     C = sqrt(weight) theta     E = k C^2 / 2     f = -kd dC (dC . v)
 * with stiffness k (N m), damping kd (N m s), the gradient dC of C with respect to the positions,
 * and the velocities v. The weight has no unit: weight = 3 |e|^2 / a with the edge's rest length
 * |e| and the rest area a of the two triangles together (discrete shells, Grinspun et al. 2003).
 * Cloth is flat at rest; if the mesh is bent at rest, theta is relative to the angle at the cloth's
 * start.
 */
#ifndef FABRIC_HINGE_H
#define FABRIC_HINGE_H

#include "base/arrays.h"
#include "mesh/mesh.h"
#include "system/system.h"

typedef struct hinge_elements {
    int count;
    int (*corner)[4]; /* [count] the edge's two vertices, then the two wings */
    int (*vertex)[4]; /* [count] the corners, ascending, so that their blocks lie in A's stored
                       * half */
    int (*role)[4];   /* [count] the index in `corner` of each of `vertex` */
    int (*block)[10]; /* [count] indices in A of (i,i) (i,j) (i,k) (i,l) (j,j) ... (l,l) */
    double *weight;   /* [count] */
    double *at_rest;  /* [count] rad, rest angles; NULL: all 0 */
    double *angle;    /* [count] rad, unwrapped: continuous from step to step; 0 at first */
    /* Cache of the angles that hinge_energy_at computed last, because a step begins at the
     * positions where the previous one ended. The arrays are NULL until
     * hinge_elements_cache_angles. */
    double *cached;        /* [count] rad, the angles */
    double (*cached_x)[3]; /* [vertices] m, the positions at which the angles were computed */
    int vertices;          /* the hinges' greatest vertex number, plus 1 */
    int has_cached;        /* the cache is filled, and `angle` has not changed since */
    arrays own;
} hinge_elements;

typedef struct hinge_material {
    double bend;         /* N m */
    double bend_damping; /* N m s */
} hinge_material;

/** Copies the mesh's hinges, except those with a triangle that has no rest shape. Returns 0, or -1
 *  if out of memory. */
int hinge_elements_init(hinge_elements *e, const mesh *m);
/** Makes hinge_energy_at cache the angles that it computes. Returns 0, or -1 if out of memory. */
int hinge_elements_cache_angles(hinge_elements *e);
/** Finds the indices of each hinge's blocks in A. Returns 0, or -1 if out of memory. */
int hinge_elements_place(hinge_elements *e, const block_matrix *A);
void hinge_elements_free(hinge_elements *e);

/** Sets e->angle to the angles at positions x. An angle is known only up to whole rotations; the
 *  value nearest to the stored angle is taken. Idempotent. */
void hinge_update_angles(hinge_elements *e, const double (*x)[3]);

/** Adds the hinges' terms to A and b at positions x (m) and velocities v (m/s), both [vertices],
 *  for a step of h seconds; e->angle must hold the angles at x. Each hinge's matrix is positive
 *  semidefinite. */
void hinge_forces(const hinge_elements *e, const hinge_material *material, double h,
                  const double (*restrict x)[3], const double (*restrict v)[3], linear_system *s);

/** Adds h f to b with the damping force f of bending (see triangle_damping_forces). */
void hinge_damping_forces(const hinge_elements *e, const hinge_material *material, double h,
                          const double (*restrict x)[3], const double (*restrict v)[3],
                          double (*restrict b)[3]);

/** Returns the energy at positions x, in J. Computes the angles nearest to the stored ones but does
 *  not store them. If they are cached, hinge_update_angles at the same x only copies them. */
double hinge_energy_at(hinge_elements *e, const hinge_material *material, const double (*x)[3]);

#endif
