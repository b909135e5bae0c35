/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Does cloth go through itself? Seen by comparing everything with everything. */
#ifndef FABRIC_TEST_CROSSINGS_H
#define FABRIC_TEST_CROSSINGS_H

#include "stage.h"

/** Does the segment p q meet the triangle a b c? By signs of volumes, not as the simulator does it.
 */
int segment_crosses(const double p[3], const double q[3], const double a[3], const double b[3],
                    const double c[3]);

/** Edges of the cloth that cross one of its triangles: none may, ever. */
int crossings(const stage *on);

/** Edges of the cloth that cross a body's triangle, and the body's that cross one of the cloth's.
 *  The body is its mesh, moved by `at` (m). */
int crossings_with(const stage *on, const mesh *body, const double at[3]);

#endif
