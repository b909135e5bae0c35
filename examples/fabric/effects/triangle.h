/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Stretch and shear, with their damping, in every triangle.
 *
 * The map from material coordinates (u, v) to space has the derivatives
 *     w_u = sum cu_p x_p,   w_v = sum cv_p x_p   over the triangle's vertices p at positions x_p
 * where sum cu_p = sum cv_p = 0. With the rest area a the conditions C and energies E (J) are
 *     stretch  C = sqrt(a) (|w_u| - 1), and the same in v    E = k C^2 / 2    k N/m
 *     shear    C = sqrt(a) w_u . w_v                         E = k C^2 / 2    k N/m
 * (Baraff and Witkin 1998, section 4, but with sqrt(a) instead of a: so the energy is proportional
 * to the area, and the stiffness does not depend on the mesh). The damping force in N is f = -kd dC
 * (dC . v) with kd in N s/m, the gradient dC of C with respect to the positions, and the velocities
 * v.
 */
#ifndef FABRIC_TRIANGLE_H
#define FABRIC_TRIANGLE_H

#include "base/arrays.h"
#include "mesh/mesh.h"
#include "system/system.h"

typedef struct triangle_rest {
    double cu[3], cv[3]; /* 1/m */
    double area;         /* m^2 */
} triangle_rest;

typedef struct triangle_elements {
    int count;
    int (*vertex)[3];    /* [count] ascending, so that the blocks below lie in A's stored half */
    int (*block)[6];     /* [count] indices in A of (i,i) (i,j) (i,k) (j,j) (j,k) (k,k); NULL until
                          * triangle_elements_place */
    triangle_rest *rest; /* [count] */
    arrays own;
} triangle_elements;

typedef struct triangle_material {
    double stretch, shear;                 /* N/m */
    double stretch_damping, shear_damping; /* N s/m */
} triangle_material;

/** Copies the mesh's triangles, except those without a rest shape (mesh_rest.h), which exert no
 *  force. Returns 0, or -1 if out of memory. */
int triangle_elements_init(triangle_elements *e, const mesh *m);
/** Fills `block`. Returns 0, or -1 if out of memory. */
int triangle_elements_place(triangle_elements *e, const block_matrix *A);
void triangle_elements_free(triangle_elements *e);

/** Adds the triangles' terms to A and b at positions x (m) and velocities v (m/s), both [vertices],
 *  for a step of h seconds. Each triangle's matrix is positive semidefinite. */
void triangle_forces(const triangle_elements *e, const triangle_material *material, double h,
                     const double (*restrict x)[3], const double (*restrict v)[3],
                     linear_system *s);

/** Adds h f to b with the damping force f of stretch and shear at positions x (m) and velocities v
 *  (m/s). A is unchanged. triangle_forces linearises damping together with stiffness; an iteration
 *  of Newton's method, with independent positions and velocities, needs -h D(x) v separately (D:
 *  the damping matrix). */
void triangle_damping_forces(const triangle_elements *e, const triangle_material *material,
                             double h, const double (*restrict x)[3], const double (*restrict v)[3],
                             double (*restrict b)[3]);

/** Computes the energies at positions x, in J. Either pointer may be NULL. */
void triangle_energies(const triangle_elements *e, const triangle_material *material,
                       const double (*x)[3], double *stretch, double *shear);

/** Returns the largest strain |w_u| - 1 or |w_v| - 1 of all triangles: -1 if there are none, or NaN
 *  if a position is not finite. */
double triangle_greatest_strain(const triangle_elements *e, const double (*x)[3]);

/** w_u and w_v of the triangle with vertices i, j, k, computed from differences of positions so
 * that a cloth far from the origin loses no digits. */
static inline void triangle_derivatives(const triangle_rest *rest, const double (*x)[3], int i,
                                        int j, int k, double wu[3], double wv[3]) {
    int c;
    for (c = 0; c < 3; c++) {
        const double first = x[j][c] - x[i][c];
        const double second = x[k][c] - x[i][c];
        wu[c] = rest->cu[1] * first + rest->cu[2] * second;
        wv[c] = rest->cv[1] * first + rest->cv[2] * second;
    }
}

#endif
