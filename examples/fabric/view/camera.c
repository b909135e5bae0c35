/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/camera.h"

#include <math.h>

static const double HALF_HEIGHT_SLOPE = 0.26; /* tan 14.6 degrees: a portrait lens */
static const double MARGIN = 1.08;
static const double LEAST_DISTANCE = 0.1; /* m */

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(double v[3]) {
    const double length = sqrt(dot(v, v));
    for (int k = 0; k < 3; k++)
        v[k] /= length;
}

static void cross(const double a[3], const double b[3], double c[3]) {
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/** Computes the point's coordinates along the camera's axes. */
static void along(const camera *c, const double point[3], double out[3]) {
    out[0] = dot(c->right, point);
    out[1] = dot(c->up, point);
    out[2] = dot(c->back, point);
}

/** Returns the least distance along `back` at which the picture, centred at `middle`, contains all
 *  points. */
static double distance_for(const camera *c, const double middle[2], double (*points)[3],
                           long count) {
    double distance = -1e300;
    for (long i = 0; i < count; i++) {
        double p[3];
        along(c, points[i], p);
        for (int k = 0; k < 2; k++)
            distance = fmax(distance, p[2] + fabs(p[k] - middle[k]) * MARGIN / c->slope[k]);
        distance = fmax(distance, p[2] + LEAST_DISTANCE);
    }
    return distance;
}

/** Moves `middle` to the centre of the points' perspective image from `distance`. */
static void center(const camera *c, double middle[2], double distance, double (*points)[3],
                   long count) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300}, depth = 0.0;
    for (long i = 0; i < count; i++) {
        double p[3];
        along(c, points[i], p);
        depth += (distance - p[2]) / (double)count;
        for (int k = 0; k < 2; k++) {
            const double seen = (p[k] - middle[k]) / (distance - p[2]);
            low[k] = fmin(low[k], seen);
            high[k] = fmax(high[k], seen);
        }
    }
    for (int k = 0; k < 2; k++)
        middle[k] += 0.5 * (low[k] + high[k]) * depth;
}

camera camera_frame(const double back[3], double aspect, double (*points)[3], long count) {
    static const double vertical[3] = {0.0, 0.0, 1.0};
    camera c = {.slope = {HALF_HEIGHT_SLOPE * aspect, HALF_HEIGHT_SLOPE}};
    double middle[2], first[3], distance;
    for (int k = 0; k < 3; k++)
        c.back[k] = back[k];
    normalize(c.back);
    cross(vertical, c.back, c.right);
    normalize(c.right);
    cross(c.back, c.right, c.up);
    along(&c, points[0], first);
    middle[0] = first[0];
    middle[1] = first[1];
    distance = distance_for(&c, middle, points, count);
    for (int round = 0; round < 6; round++) {
        center(&c, middle, distance, points, count);
        distance = distance_for(&c, middle, points, count);
    }
    c.depth[0] = 1e300;
    for (int k = 0; k < 3; k++)
        c.eye[k] = middle[0] * c.right[k] + middle[1] * c.up[k] + distance * c.back[k];
    for (long i = 0; i < count; i++) {
        const double depth = distance - dot(c.back, points[i]);
        c.depth[0] = fmin(c.depth[0], depth);
        c.depth[1] = fmax(c.depth[1], depth);
    }
    return c;
}
