/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The nearest points of two features, in any position, including degenerate ones. */
#ifndef FABRIC_NEAREST_H
#define FABRIC_NEAREST_H

/** The vector from the second feature's nearest point to the first's is sum weight[k] x[k]. */
typedef struct nearest {
    double weight[4];
    double normal[3]; /* unit vector along that vector; 0 if the features touch */
    double distance;  /* m */
} nearest;

static inline void nearest_combine(const double x[4][3], const double weight[4], double sum[3]) {
    for (int a = 0; a < 3; a++)
        sum[a] =
            weight[0] * x[0][a] + weight[1] * x[1][a] + weight[2] * x[2][a] + weight[3] * x[3][a];
}

/** Finds the nearest points of vertex x[0] and triangle x[1] x[2] x[3]. */
void nearest_vertex_triangle(const double x[4][3], nearest *found);

/** Finds the nearest points of the edges x[0] x[1] and x[2] x[3]. */
void nearest_edges(const double x[4][3], nearest *found);

#endif
