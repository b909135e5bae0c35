/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The camera of a picture. */
#ifndef FABRIC_VIEW_CAMERA_H
#define FABRIC_VIEW_CAMERA_H

/** At `eye`, looking in the direction opposite to `back`; right, up and back are unit vectors at
 *  right angles. */
typedef struct camera {
    double eye[3]; /* m */
    double right[3], up[3], back[3];
    double slope[2]; /* half the picture's width and height at distance 1 */
    double depth[2]; /* m, from the eye to the nearest and the farthest of the points framed */
} camera;

/**
 * Frames the `count` points (at least one) with a margin, upright (z), for pictures of
 * width / height = aspect. back: any vector that is not vertical, from the points to the eye.
 */
camera camera_frame(const double back[3], double aspect, double (*points)[3], long count);

#endif
