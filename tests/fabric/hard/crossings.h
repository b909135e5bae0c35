/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Does cloth intersect itself? Decided by comparing all features with all. */
#ifndef FABRIC_TEST_CROSSINGS_H
#define FABRIC_TEST_CROSSINGS_H

#include "stage.h"

/** Does the segment p q meet the triangle a b c? Decided by signs of volumes, unlike in the
 * simulator. */
int segment_crosses(const double p[3], const double q[3], const double a[3], const double b[3],
                    const double c[3]);

/** Returns the number of the cloth's edges that cross one of its triangles, which must always be
 * 0. */
int crossings(const stage *on);

/** Returns the number of the cloth's edges that cross a triangle of the body, and of the body's
 * edges that cross a triangle of the cloth. The body is the mesh, moved by `at` (m). */
int crossings_with(const stage *on, const mesh *body, const double at[3]);

#endif
