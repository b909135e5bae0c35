/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A second, much stiffer stretch in the triangles that are longer than a limit allows. For w = w_u
 * and w = w_v (triangle.h), where |w| > 1 + limit:
 *     C = sqrt(a) (|w| - 1 - limit)     E = k C^2 / 2     k = STRAIN_LIMIT_FACTOR x stretch
 * so that strain stays below the limit plus what the load stretches that stiffness by. It is solved
 * with the other forces: those triangles that would end a step beyond the limit are found, and the
 * system is solved again with them.
 */
#ifndef FABRIC_STRAIN_LIMIT_H
#define FABRIC_STRAIN_LIMIT_H

#include "triangle.h"

#define STRAIN_LIMIT_FACTOR 100.0

typedef struct strain_limit {
    double limit;        /* strain */
    double stiffness;    /* N/m */
    int count;           /* of the list */
    int *triangle;       /* [triangles] those that are limited in this step */
    unsigned char *over; /* [triangles] bit 0: w_u is, bit 1: w_v is */
    arrays own;
} strain_limit;

/** 0, or -1: out of memory. */
int strain_limit_init(strain_limit *l, const triangle_elements *e, double limit, double stretch);
void strain_limit_free(strain_limit *l);

/** Lists the triangles beyond the limit at positions x. */
void strain_limit_find(strain_limit *l, const triangle_elements *e, const double (*x)[3]);

/** Lists those that are not listed yet and would be beyond the limit after h s with velocities v +
 *  dv, which replace the earlier list; returns how many. */
int strain_limit_find_missed(strain_limit *l, const triangle_elements *e, double h,
                             const double (*x)[3], const double (*v)[3], const double (*dv)[3]);

/** Adds the listed triangles' part of A and b, as triangle_forces does. */
void strain_limit_forces(const strain_limit *l, const triangle_elements *e, double h,
                         const double (*restrict x)[3], const double (*restrict v)[3],
                         linear_system *s);

/** J */
double strain_limit_energy(const strain_limit *l, const triangle_elements *e, const double (*x)[3]);

#endif
