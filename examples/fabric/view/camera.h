/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The camera of a picture. */
#ifndef FABRIC_VIEW_CAMERA_H
#define FABRIC_VIEW_CAMERA_H

/** A camera at `eye` that looks in the direction opposite to `back`; right, up and back are
 *  orthonormal. */
typedef struct camera {
    double eye[3]; /* m */
    double right[3], up[3], back[3];
    double slope[2]; /* half the width and half the height of the picture at distance 1 */
    double depth[2]; /* m, distances from the eye to the nearest and the farthest framed point */
} camera;

/**
 * Chooses a camera, with z upwards, whose pictures of width / height = aspect contain the `count`
 * points (at least one) with a margin. `back` is the direction from the points to the eye, of any
 * length, not vertical.
 */
camera camera_frame(const double back[3], double aspect, double (*points)[3], long count);

#endif
