/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Positions and motions of colliders. A collider without keyframes moves at a constant velocity.
 * One with keyframes moves and rotates at constant rates between consecutive keyframes, and rests
 * before the first and after the last. It rotates about its turn_axis through its position. In a
 * step that contains a keyframe it moves with its mean velocity over the step.
 *
 * Contact is found in the body's own axes, in which a vertex starts the step at p and ends it at
 * p + u. The path from p to p + u is taken as a straight line: for a body that rotates by the angle
 * a, the error is a^2 / 8 of the distance to its axis. Both ends are exact.
 */
#ifndef FABRIC_MOTION_H
#define FABRIC_MOTION_H

#include <string.h>

#include "scene/scene.h"

/** A position and a rotation: the point p of the body is at origin + rotation p in space. */
typedef struct body_pose {
    double origin[3]; /* m */
    double rotation[3][3];
} body_pose;

/** A step of a collider with keyframes. */
typedef struct body_motion {
    double h;    /* s */
    int rotates; /* true: the collider rotates during the step */
    body_pose begin, end;
} body_motion;

static inline int motion_has_keys(const collider *k) {
    return k->keyframe_count > 0;
}

/** Does the collider ever rotate? */
int motion_rotates(const collider *k);

/** Returns the time after which the collider does not move any more, s, or infinity if its velocity
 *  is not 0. */
double motion_end(const collider *k);

/** The pose of any collider at `time`, s. */
void motion_pose(const collider *k, double time, body_pose *pose);

/** The angle by which the collider is rotated at `time`, rad. */
double motion_angle(const collider *k, double time);

/** Computes the motion of a collider with keyframes in the step of h s that begins at `time`. */
void motion_in_step(const collider *k, double time, double h, body_motion *m);

/** Returns an upper bound, m, on the displacement in the step of points within `reach` m of the
 *  body's origin. */
double motion_displacement(const body_motion *m, double reach);

/** Converts the point x of space to p in the body's axes at `time`. */
void motion_to_body(const collider *k, double time, const double x[3], double p[3]);

void motion_enter_keyed(const body_motion *m, const double x[3], const double v[3], double p[3],
                        double u[3]);
void motion_carry_keyed(const body_motion *m, const double p[3], double normal[3],
                        double carried[3]);

/** Computes in the body's axes p, the position of x at the beginning of the step, and u, its
 *  displacement at velocity v (m/s). m is used only for colliders with keyframes. */
static inline void motion_enter(const collider *k, const body_motion *m, double time, double h,
                                const double x[3], const double v[3], double p[3], double u[3]) {
    if (motion_has_keys(k)) {
        motion_enter_keyed(m, x, v, p, u);
        return;
    }
    for (int a = 0; a < 3; a++) {
        p[a] = x[a] - k->position[a] - time * k->velocity[a];
        u[a] = h * (v[a] - k->velocity[a]);
    }
}

/** Converts from the body's axes to space: rotates the normal to its direction at the step's end,
 *  and computes the mean velocity `carried` (m/s) of the body at p. */
static inline void motion_carry(const collider *k, const body_motion *m, const double p[3],
                                double normal[3], double carried[3]) {
    if (motion_has_keys(k))
        motion_carry_keyed(m, p, normal, carried);
    else
        memcpy(carried, k->velocity, sizeof k->velocity);
}

#endif
