/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "motion.h"

#include <assert.h>

#include "base/vector.h"

static const double degree = 3.14159265358979323846 / 180;

int motion_rotates(const collider *k) {
    for (int n = 0; n < k->keyframe_count; n++)
        if (k->keyframes[n].angle < 0 || k->keyframes[n].angle > 0)
            return 1;
    return 0;
}

double motion_end(const collider *k) {
    if (vector_length(k->velocity) > 0)
        return INFINITY;
    return motion_has_keys(k) ? k->keyframes[k->keyframe_count - 1].time : 0;
}

/* Finds the keyframe at or before `time` and the next one. Returns the position of `time` between
 * them, from 0 to 1. */
static double between(const collider *k, double time, const keyframe **before,
                      const keyframe **after) {
    assert(motion_has_keys(k));
    int n = 0;
    while (n < k->keyframe_count && k->keyframes[n].time <= time)
        n++;
    *before = &k->keyframes[n > 0 ? n - 1 : 0];
    *after = &k->keyframes[n < k->keyframe_count ? n : k->keyframe_count - 1];
    assert((*before)->time <= (*after)->time);
    const double length = (*after)->time - (*before)->time;
    return length > 0 ? (time - (*before)->time) / length : 0;
}

double motion_angle(const collider *k, double time) {
    const keyframe *before, *after;
    if (!motion_has_keys(k))
        return 0;
    const double part = between(k, time, &before, &after);
    return degree * (before->angle + part * (after->angle - before->angle));
}

/* Computes the rotation by `angle` (rad) about the unit axis, by Rodrigues' formula. */
static void turn_about(const double axis[3], double angle, double rotation[3][3]) {
    const double c = cos(angle), s = sin(angle);
    const double cross[3][3] = {
        {0, -axis[2], axis[1]}, {axis[2], 0, -axis[0]}, {-axis[1], axis[0], 0}};
    for (int r = 0; r < 3; r++)
        for (int a = 0; a < 3; a++)
            rotation[r][a] = (r == a ? c : 0) + s * cross[r][a] + (1 - c) * axis[r] * axis[a];
}

void motion_pose(const collider *k, double time, body_pose *pose) {
    static const double none[3] = {0, 0, 1};
    const keyframe *before, *after;
    for (int a = 0; a < 3; a++)
        pose->origin[a] = k->position[a] + time * k->velocity[a];
    turn_about(motion_has_keys(k) ? k->turn_axis : none, motion_angle(k, time), pose->rotation);
    if (!motion_has_keys(k))
        return;
    const double part = between(k, time, &before, &after);
    for (int a = 0; a < 3; a++)
        pose->origin[a] += before->move[a] + part * (after->move[a] - before->move[a]);
}

void motion_in_step(const collider *k, double time, double h, body_motion *m) {
    const double angle = motion_angle(k, time), angle_then = motion_angle(k, time + h);
    m->h = h;
    m->rotates = angle < angle_then || angle > angle_then;
    motion_pose(k, time, &m->begin);
    motion_pose(k, time + h, &m->end);
}

double motion_displacement(const body_motion *m, double reach) {
    double way[3], turned = 0;
    vector_subtract(m->end.origin, m->begin.origin, way);
    for (int r = 0; r < 3; r++)
        for (int a = 0; a < 3; a++) {
            const double change = m->end.rotation[r][a] - m->begin.rotation[r][a];
            turned += change * change;
        }
    return vector_length(way) + sqrt(turned) * reach;
}

/* Sets p to x in the axes of the pose. */
static void to_pose(const body_pose *pose, const double x[3], double p[3]) {
    double from[3];
    vector_subtract(x, pose->origin, from);
    for (int a = 0; a < 3; a++)
        p[a] = pose->rotation[0][a] * from[0] + pose->rotation[1][a] * from[1] +
               pose->rotation[2][a] * from[2];
}

/* Sets d to the direction in space of p, which is in the axes of the pose. */
static void from_pose(const body_pose *pose, const double p[3], double d[3]) {
    for (int r = 0; r < 3; r++)
        d[r] = vector_dot(pose->rotation[r], p);
}

void motion_to_body(const collider *k, double time, const double x[3], double p[3]) {
    if (motion_has_keys(k)) {
        body_pose pose;
        motion_pose(k, time, &pose);
        to_pose(&pose, x, p);
        return;
    }
    for (int a = 0; a < 3; a++)
        p[a] = x[a] - k->position[a] - time * k->velocity[a];
}

void motion_enter_keyed(const body_motion *m, const double x[3], const double v[3], double p[3],
                        double u[3]) {
    double end[3];
    vector_add_scaled(x, m->h, v, end);
    to_pose(&m->begin, x, p);
    to_pose(&m->end, end, u);
    vector_subtract(u, p, u);
}

void motion_carry_keyed(const body_motion *m, const double p[3], double normal[3],
                        double carried[3]) {
    const double own[3] = {normal[0], normal[1], normal[2]};
    double at_begin[3], at_end[3];
    from_pose(&m->end, own, normal);
    from_pose(&m->begin, p, at_begin);
    from_pose(&m->end, p, at_end);
    for (int a = 0; a < 3; a++)
        carried[a] =
            m->h > 0 ? (m->end.origin[a] + at_end[a] - m->begin.origin[a] - at_begin[a]) / m->h : 0;
}
