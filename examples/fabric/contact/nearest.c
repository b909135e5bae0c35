/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Both public functions first compute the nearest points of the plane and the point, or of the two
 * lines. If these lie strictly inside the features, they are the result; for nearly parallel edges
 * only if no border point is nearer. Otherwise the nearest border point wins. At a border both give
 * the same points, so it does not matter which case rounding selects. */
#include "nearest.h"

#include <string.h>

#include "base/vector.h"

/* Computes normal and distance from the weights. */
static void measure(const double x[4][3], nearest *found) {
    double separation[3];
    nearest_combine(x, found->weight, separation);
    found->distance = vector_unit(separation, found->normal);
}

/* Copies the weights to *best if their squared distance is less than *square, the least so far. */
static void keep_nearer(const double x[4][3], const double weight[4], nearest *best,
                        double *square) {
    double separation[3];
    nearest_combine(x, weight, separation);
    const double other = vector_dot(separation, separation);
    if (other < *square) {
        *square = other;
        memcpy(best->weight, weight, sizeof best->weight);
    }
}

/* Returns the position, from 0 at a to 1 at b, of the segment's point nearest to p. */
static double foot_on_segment(const double p[3], const double a[3], const double b[3]) {
    double along[3], from[3];
    vector_subtract(b, a, along);
    vector_subtract(p, a, from);
    const double square = vector_dot(along, along);
    const double t = square > 0 ? vector_dot(from, along) / square : 0;
    return t < 0 ? 0 : (t > 1 ? 1 : t);
}

/* Tries vertex p against the segment of vertices a and b; `sign` is p's weight. */
static void try_segment(const double x[4][3], int p, int a, int b, double sign, nearest *best,
                        double *square) {
    const double t = foot_on_segment(x[p], x[a], x[b]);
    double weight[4] = {0};
    weight[p] = sign;
    weight[a] = -sign * (1 - t);
    weight[b] = -sign * t;
    keep_nearer(x, weight, best, square);
}

void nearest_vertex_triangle(const double x[4][3], nearest *found) {
    double one[3], other[3], from[3];
    vector_subtract(x[2], x[1], one);
    vector_subtract(x[3], x[1], other);
    vector_subtract(x[0], x[1], from);
    const double aa = vector_dot(one, one), ab = vector_dot(one, other);
    const double bb = vector_dot(other, other), fa = vector_dot(from, one);
    const double fb = vector_dot(from, other), determinant = aa * bb - ab * ab;
    double square = INFINITY;
    if (determinant > 1e-14 * aa * bb) {
        const double u = (bb * fa - ab * fb) / determinant;
        const double v = (aa * fb - ab * fa) / determinant;
        const double weight[4] = {1, u + v - 1, -u, -v};
        if (u > 0 && v > 0 && u + v < 1) { /* the projection lies inside the triangle */
            memcpy(found->weight, weight, sizeof found->weight);
            measure(x, found);
            return;
        }
    }
    try_segment(x, 0, 1, 2, 1, found, &square);
    try_segment(x, 0, 2, 3, 1, found, &square);
    try_segment(x, 0, 3, 1, 1, found, &square);
    measure(x, found);
}

void nearest_edges(const double x[4][3], nearest *found) {
    double d1[3], d2[3], r[3];
    vector_subtract(x[1], x[0], d1);
    vector_subtract(x[3], x[2], d2);
    vector_subtract(x[0], x[2], r);
    const double a = vector_dot(d1, d1), e = vector_dot(d2, d2), f = vector_dot(d2, r);
    const double c = vector_dot(d1, r), b = vector_dot(d1, d2), determinant = a * e - b * b;
    double square = INFINITY;
    if (determinant > 1e-14 * a * e) {
        const double s = (b * f - c * e) / determinant, t = (a * f - b * c) / determinant;
        const double weight[4] = {1 - s, s, t - 1, -t};
        if (s > 0 && s < 1 && t > 0 && t < 1) {
            keep_nearer(x, weight, found, &square);
            if (determinant > 1e-6 * a * e) {
                measure(x, found);
                return;
            }
        }
    }
    try_segment(x, 0, 2, 3, 1, found, &square);
    try_segment(x, 1, 2, 3, 1, found, &square);
    try_segment(x, 2, 0, 1, -1, found, &square);
    try_segment(x, 3, 0, 1, -1, found, &square);
    measure(x, found);
}
