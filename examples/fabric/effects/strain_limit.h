/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A second, much stiffer stretch in the triangles whose strain exceeds a limit. For w = w_u and w =
 * w_v (triangle.h), if |w| > 1 + limit:
 *     C = sqrt(a) (|w| - 1 - limit)     E = k C^2 / 2     k = STRAIN_LIMIT_FACTOR x stretch
 * with rest area a (m^2), energy E (J) and the stretch stiffness (N/m). Strain exceeds the limit
 * only by the strain that the load causes at stiffness k. The limit is solved together with the
 * other forces: the triangles that would end a step beyond it are found, and the system is solved
 * again with them.
 */
#ifndef FABRIC_STRAIN_LIMIT_H
#define FABRIC_STRAIN_LIMIT_H

#include "triangle.h"

#define STRAIN_LIMIT_FACTOR 100.0

typedef struct strain_limit {
    double limit;        /* the largest strain without this force */
    double stiffness;    /* N/m */
    int count;           /* number of triangles in the list */
    int *triangle;       /* [triangles] the list: limited triangles whose terms are not yet in
                          * the system */
    unsigned char *over; /* [triangles] bit 0: w_u is limited; bit 1: w_v is */
    arrays own;
} strain_limit;

/** Returns 0, or -1 if out of memory. */
int strain_limit_init(strain_limit *l, const triangle_elements *e, double limit, double stretch);
void strain_limit_free(strain_limit *l);

/** Lists the triangles beyond the limit at positions x. */
void strain_limit_find(strain_limit *l, const triangle_elements *e, const double (*x)[3]);

/** Replaces the list by the triangles that were not listed before and would be beyond the limit
 *  after h s with velocities v + dv. Returns their number. (Triangles listed before are in the
 *  system already.) */
int strain_limit_find_missed(strain_limit *l, const triangle_elements *e, double h,
                             const double (*x)[3], const double (*v)[3], const double (*dv)[3]);

/** Adds the listed triangles' terms to A and b, as triangle_forces does. */
void strain_limit_forces(const strain_limit *l, const triangle_elements *e, double h,
                         const double (*restrict x)[3], const double (*restrict v)[3],
                         linear_system *s);

/** The energy at positions x, J. */
double strain_limit_energy(const strain_limit *l, const triangle_elements *e, const double (*x)[3]);

#endif
