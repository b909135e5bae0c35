/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Distance of a pair (a vertex and a triangle, or two edges), and the time at which its features
 * meet. */
#include <assert.h>

#include "base/vector.h"
#include "nearest.h"
#include "self_collision.h"

void self_pair_gather(const self_pair *pair, double h, const double (*x)[3], const double (*v)[3],
                      double start[4][3], double end[4][3]) {
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++) {
            start[k][a] = x[pair->vertex[k]][a];
            end[k][a] = start[k][a] + (h * v[pair->vertex[k]][a]);
        }
}

int self_pair_keeps_distance(const int vertex[4], int is_edges, double separation, double h,
                             const double (*x)[3], const double (*v)[3]) {
    const int firsts = is_edges ? 2 : 1;
    for (int a = 0; a < 3; a++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int k = 0; k < 4; k++) {
            const int side = k >= firsts;
            const double start = x[vertex[k]][a], end = start + h * v[vertex[k]][a];
            const double least = start < end ? start : end, most = start < end ? end : start;
            low[side] = least < low[side] ? least : low[side];
            high[side] = most > high[side] ? most : high[side];
        }
        if (low[0] > high[1] + separation || low[1] > high[0] + separation)
            return 1;
    }
    return 0;
}

static double clamp(double value) {
    return value < 0 ? 0 : (value > 1 ? 1 : value);
}

/* Computes the weights of the nearest points of the edges x0 x1 and x2 x3 (Ericson 2005, 5.1.9). */
static void nearest_on_edges(const double x[4][3], double weight[4]) {
    double d1[3], d2[3], r[3];
    vector_subtract(x[1], x[0], d1);
    vector_subtract(x[3], x[2], d2);
    vector_subtract(x[0], x[2], r);
    const double a = vector_dot(d1, d1), e = vector_dot(d2, d2), f = vector_dot(d2, r);
    const double c = vector_dot(d1, r), b = vector_dot(d1, d2), denominator = a * e - b * b;
    double s = denominator > 1e-12 * a * e ? clamp((b * f - c * e) / denominator) : 0.5;
    double t = e > 0 ? (b * s + f) / e : 0;
    if (t < 0 || t > 1) {
        t = clamp(t);
        s = a > 0 ? clamp((b * t - c) / a) : 0;
    }
    weight[0] = 1 - s;
    weight[1] = s;
    weight[2] = t - 1;
    weight[3] = -t;
}

/* Projects the vertex onto the triangle's plane and computes the weights of vertex and projection.
 * Returns the projection's least barycentric coordinate, which is below 0 if the projection is
 * outside of the triangle. Returns -1 for a triangle without area. */
static double foot_in_plane(const double x[4][3], double weight[4]) {
    double one[3], other[3], from[3];
    vector_subtract(x[2], x[1], one);
    vector_subtract(x[3], x[1], other);
    vector_subtract(x[0], x[1], from);
    const double aa = vector_dot(one, one), ab = vector_dot(one, other);
    const double bb = vector_dot(other, other), fa = vector_dot(from, one);
    const double fb = vector_dot(from, other), determinant = aa * bb - ab * ab;
    if (!(determinant > 1e-12 * aa * bb))
        return -1;
    const double u = (bb * fa - ab * fb) / determinant, w = (aa * fb - ab * fa) / determinant;
    const double v = 1 - u - w;
    weight[0] = 1;
    weight[1] = -v;
    weight[2] = -u;
    weight[3] = -w;
    return v < u ? (v < w ? v : w) : (u < w ? u : w);
}

/* Computes the weights of the features' nearest points. Returns their distance. It is infinite if a
 * barycentric coordinate of the vertex's projection is below -outside, or if the triangle has no
 * area. */
static double distance_between(int is_edges, const double x[4][3], double outside,
                               double weight[4]) {
    double separation[3];
    if (is_edges)
        nearest_on_edges(x, weight);
    else if (foot_in_plane(x, weight) < -outside)
        return INFINITY;
    nearest_combine(x, weight, separation);
    return vector_length(separation);
}

/* Sets the normal, from the second feature to the first, and the distance at positions x. Returns 0
 * if the distance is 0. */
static int set_normal(const double x[4][3], self_contact *found) {
    double separation[3];
    nearest_combine(x, found->weight, separation);
    found->distance = vector_unit(separation, found->normal);
    return found->distance > 0;
}

int self_pair_is_near(int is_edges, const double x[4][3], double gap, self_contact *found) {
    const double distance = distance_between(is_edges, x, 0, found->weight);
    return distance < gap && distance > 1e-6 * gap && set_normal(x, found);
}

/* The distance along `axis`, in units of its length, from the second feature to the first; below 0
 * if they overlap along it. */
static double distance_along(int is_edges, const double x[4][3], const double axis[3]) {
    const int firsts = is_edges ? 2 : 1;
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < 4; k++) {
        const double at = vector_dot(axis, x[k]);
        if (k < firsts)
            low = at < low ? at : low;
        else
            high = at > high ? at : high;
    }
    return low - high;
}

/* Positions are linear in time, so between x and y the distance along the axis is never less than
 * the smaller of the two distances. */
int self_pair_stays_apart(int is_edges, const double x[4][3], const double y[4][3],
                          const double weight[4], double distance) {
    double axis[3];
    nearest_combine(x, weight, axis);
    const double start = distance_along(is_edges, x, axis);
    const double end = distance_along(is_edges, y, axis), least = start < end ? start : end;
    return least > 0 && least * least > distance * distance * vector_dot(axis, axis);
}

/* Returns six times the volume of the tetrahedron of the four points at time t; it is 0 if they are
 * coplanar. */
static double volume_at(const double x[4][3], const double y[4][3], double t) {
    double at[3][3], cross[3];
    for (int k = 0; k < 3; k++)
        for (int a = 0; a < 3; a++)
            at[k][a] = (1 - t) * (x[k + 1][a] - x[0][a]) + t * (y[k + 1][a] - y[0][a]);
    vector_cross(at[0], at[1], cross);
    return vector_dot(cross, at[2]);
}

/* Computes the coefficients c of the volume as a cubic in t, from its values at four times; `value`
 * receives the values at t = 0 and 1. */
static void fit(const double x[4][3], const double y[4][3], double c[4], double value[2]) {
    const double f0 = volume_at(x, y, 0), f1 = volume_at(x, y, 1.0 / 3);
    const double f2 = volume_at(x, y, 2.0 / 3), f3 = volume_at(x, y, 1);
    value[0] = f0;
    value[1] = f3;
    c[0] = f0;
    c[1] = (-11 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / 2;
    c[2] = 9 * (2 * f0 - 5 * f1 + 4 * f2 - f3) / 2;
    c[3] = 9 * (-f0 + 3 * f1 - 3 * f2 + f3) / 2;
}

/* Finds the cubic's extrema within (0, 1), ascending. Returns their number. */
static int turning_points(const double c[4], double at[2]) {
    const double a = 3 * c[3], b = 2 * c[2], d = b * b - 4 * a * c[1];
    int count = 0;
    double root[2] = {-1, -1};
    if (fabs(a) > 1e-14 * fabs(b) && d > 0) {
        const double q = -(b + copysign(sqrt(d), b)) / 2;
        root[0] = q / a;
        root[1] = q != 0 ? c[1] / q : -1;
    } else if (b != 0) {
        root[0] = -c[1] / b;
    }
    for (int k = 0; k < 2; k++)
        if (root[k] > 0 && root[k] < 1)
            at[count++] = root[k];
    if (count == 2 && at[0] > at[1]) {
        const double swap = at[0];
        at[0] = at[1];
        at[1] = swap;
    }
    assert(count < 2 || at[0] <= at[1]);
    return count;
}

/* Do the features touch at time t, at which the four points are coplanar? */
static int touch_at(int is_edges, const double x[4][3], const double y[4][3], double t,
                    self_contact *found) {
    double at[4][3], size = 0;
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++) {
            at[k][a] = (1 - t) * x[k][a] + t * y[k][a];
            size = fmax(size, fabs(at[k][a] - at[0][a]));
        }
    return distance_between(is_edges, (const double(*)[3])at, 1e-9, found->weight) <= 1e-6 * size;
}

int self_pair_passes(int is_edges, const double x[4][3], const double y[4][3],
                     self_contact *found) {
    double c[4], turn[4] = {0}, at_end[2];
    fit(x, y, c, at_end);
    const int count = turning_points(c, turn + 1);
    turn[count + 1] = 1;
    double first = at_end[0], next;
    for (int k = 0; k <= count; k++, first = next) {
        double low = turn[k], high = turn[k + 1];
        next = k < count ? volume_at(x, y, high) : at_end[1];
        if ((first < 0) == (next < 0))
            continue;
        for (int n = 0; n < 48; n++) {
            const double middle = (low + high) / 2;
            if ((volume_at(x, y, middle) < 0) == (first < 0))
                low = middle;
            else
                high = middle;
        }
        if (touch_at(is_edges, x, y, high, found))
            return set_normal(x, found);
    }
    return 0;
}

int self_pair_ends_near(int is_edges, const double x[4][3], const double y[4][3], double gap,
                        self_contact *found) {
    return distance_between(is_edges, y, 0, found->weight) < gap && set_normal(x, found);
}
