/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The derivative of a hinge's angle with respect to its corners. */
#ifndef FABRIC_HINGE_GRADIENT_H
#define FABRIC_HINGE_GRADIENT_H

#include "base/vector.h"

/**
 * The gradients g0 to g3 (1/m) of theta with respect to the four corners. With e = x1 - x0, the
 * normals n1 = e x (x2 - x0) and n2 = (x3 - x0) x e (x: cross product), and the wings' projections
 * t2 and t3 onto e (0 at x0, 1 at x1):
 *     g2 = -|e| n1 / |n1|^2                  g3 = -|e| n2 / |n2|^2
 *     g0 = -(1 - t2) g2 - (1 - t3) g3        g1 = -t2 g2 - t3 g3
 * (Bridson, Marino and Fedkiw 2003; the sum is 0: no net force).
 */
static inline void hinge_gradient(const double x0[3], const double x1[3], const double x2[3],
                                  const double x3[3], double g[4][3]) {
    const double lowest_wing = 1e-3;    /* least ratio of height to edge, because gradients grow as
                                         * 1/height */
    const double shortest_edge = 1e-12; /* m; a shorter edge has gradient 0 */
    double e[3], a[3], b[3], n1[3], n2[3];
    double ee, length, least, usable, s1, s2, t2, t3;
    int c;
    vector_subtract(x1, x0, e);
    vector_subtract(x2, x0, a);
    vector_subtract(x3, x0, b);
    vector_cross(e, a, n1);
    vector_cross(b, e, n2);
    ee = vector_dot(e, e);
    length = sqrt(ee);
    usable = length > shortest_edge ? 1 : 0;
    ee = usable > 0 ? ee : 1;
    least = lowest_wing * ee * lowest_wing * ee;
    s1 = vector_dot(n1, n1);
    s2 = vector_dot(n2, n2);
    s1 = -usable * length / (s1 > least ? s1 : least);
    s2 = -usable * length / (s2 > least ? s2 : least);
    t2 = vector_dot(a, e) / ee;
    t3 = vector_dot(b, e) / ee;
    for (c = 0; c < 3; c++) {
        g[2][c] = s1 * n1[c];
        g[3][c] = s2 * n2[c];
        g[0][c] = -(1 - t2) * g[2][c] - (1 - t3) * g[3][c];
        g[1][c] = -t2 * g[2][c] - t3 * g[3][c];
    }
}

#endif
