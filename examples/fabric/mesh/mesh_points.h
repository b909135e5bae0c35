/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where a generated mesh's vertices lie. */
#ifndef FABRIC_MESH_POINTS_H
#define FABRIC_MESH_POINTS_H

/**
 * Puts `count` points into the square [-1/2, 1/2]^2: the first `boundary` (>= 4, corners included)
 * around its border, the others inside, spread evenly but irregularly and well away from the
 * border. Only +, -, *, / and square roots are used, so the seed alone decides every bit. points:
 * [count]. Returns 0, or -1 when memory is out.
 */
int mesh_points(double (*points)[2], int count, int boundary, unsigned seed);

#endif
