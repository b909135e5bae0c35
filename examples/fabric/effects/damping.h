/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The damping forces alone, without their derivatives. triangle_forces and hinge_forces linearise
 * damping together with stiffness; an iteration of Newton's method, with independent positions and
 * velocities, needs -h D(x) v separately.
 */
#ifndef FABRIC_DAMPING_H
#define FABRIC_DAMPING_H

#include "hinge.h"
#include "triangle.h"

/** b += h f, f the damping of stretch and shear at positions x (m) and velocities v (m/s). */
void triangle_damping_forces(const triangle_elements *e, const triangle_material *material,
                             double h, const double (*restrict x)[3], const double (*restrict v)[3],
                             double (*restrict b)[3]);

/** b += h f, f the damping of bending. */
void hinge_damping_forces(const hinge_elements *e, const hinge_material *material, double h,
                          const double (*restrict x)[3], const double (*restrict v)[3],
                          double (*restrict b)[3]);

#endif
