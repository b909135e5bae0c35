/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Bending, with its damping, at every hinge: two triangles that share an edge.
 *
 * With the edge x0 x1, wings x2 and x3 and the angle theta between the triangles (0: flat)
 *     C = sqrt(weight) theta,   E = k C^2 / 2   k N m,   weight = 3 |e|^2 / a  (no unit)
 * where |e| is the edge's rest length and a the rest area of the two triangles together (discrete
 * shells, Grinspun et al. 2003). Cloth is flat at rest; if the mesh is bent at rest, theta is
 * relative to the angle at the cloth's start. Damping: f = -kd dC (dC . v), kd N m s.
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
    int (*block)[10]; /* [count] indices in A of (i,i) (i,j) (i,k) (i,l) (j,j) ... (l,l) */
    double *weight;   /* [count] */
    double *at_rest;  /* [count] rad, rest angles; NULL: all 0 */
    double *angle;    /* [count] rad, unwrapped: continuous from step to step; 0 at first */
    /* Cache of the angles that hinge_energy_at found last: the angles at a step's end are those at
     * the next step's beginning. NULL until hinge_elements_cache_angles. */
    double *cached;        /* [count] rad, the angles */
    double (*cached_x)[3]; /* [vertices] m, their positions */
    int vertices;          /* the hinges' greatest vertex number, plus 1 */
    int has_cached;        /* the cache is filled, and `angle` has not changed since */
    arrays own;
} hinge_elements;

typedef struct hinge_material {
    double bend;         /* N m */
    double bend_damping; /* N m s */
} hinge_material;

/** The mesh's hinges; those whose triangles have no rest area are left out. 0, or -1: out of
 *  memory. */
int hinge_elements_init(hinge_elements *e, const mesh *m);
/** Makes hinge_energy_at cache the angles that it finds. 0, or -1: out of memory. */
int hinge_elements_cache_angles(hinge_elements *e);
/** Finds the indices of each hinge's blocks in A. 0, or -1: out of memory. */
int hinge_elements_place(hinge_elements *e, const block_matrix *A);
void hinge_elements_free(hinge_elements *e);

/** Updates e->angle to positions x. Of the angles that equal atan2's minus the rest angle up to
 * whole rotations, it takes the one nearest to the stored angle. Idempotent. */
void hinge_update_angles(hinge_elements *e, const double (*x)[3]);

/** Adds the hinges' terms to A and b at positions x (m) and velocities v (m/s), both [vertices],
 * for a step of h seconds; e->angle must be that at x. Each hinge's matrix is positive
 * semidefinite. */
void hinge_forces(const hinge_elements *e, const hinge_material *material, double h,
                  const double (*restrict x)[3], const double (*restrict v)[3], linear_system *s);

/** b += h f, f the damping of bending: as triangle_damping_forces. */
void hinge_damping_forces(const hinge_elements *e, const hinge_material *material, double h,
                          const double (*restrict x)[3], const double (*restrict v)[3],
                          double (*restrict b)[3]);

/** Energy at positions x, in J, with the angles nearest to the stored ones, which do not change. If
 *  angles are cached, hinge_update_angles at the same positions then costs nothing. */
double hinge_energy_at(hinge_elements *e, const hinge_material *material, const double (*x)[3]);

#endif
