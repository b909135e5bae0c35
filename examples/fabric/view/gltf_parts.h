/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the files that write glTF; not for users of gltf.h. */
#ifndef FABRIC_VIEW_GLTF_PARTS_H
#define FABRIC_VIEW_GLTF_PARTS_H

#include <stddef.h>
#include <stdint.h>

#include "base/vector.h"
#include "contact/motion.h"
#include "scene/scene.h"
#include "view/cloth_frames.h"

/** Least and greatest coordinates of a list of points, in glTF's axes, as floats. */
typedef struct bounds {
    float low[3], high[3];
} bounds;

/** A collider as it goes into the file. */
typedef struct solid {
    const collider *of;
    mesh surface;
    bounds box;
} solid;

/** Data collected before anything is written. */
typedef struct gltf {
    const cloth_frames *frames;
    state first;
    bounds *frame; /* [frames->count]: of the first frame, then of the differences from it */
    int solid_count;
    solid *solids;
    uint64_t bytes; /* of all numbers */
} gltf;

/* The buffer's parts, each a bufferView, in this order in the file; accessors are in it too. */
enum { CLOTH, TARGETS, CORNERS, TIMES, WEIGHTS, SOLIDS, SOLID_CORNERS, PATHS, TURNS, PARTS };

/** From z up to y up. */
static inline void gltf_turn(const double p[3], double turned[3]) {
    turned[0] = p[0];
    turned[1] = p[2];
    turned[2] = 0 - p[1]; /* without -0 */
}

/** Where the collider is at a time, in the file. */
static inline void gltf_place(const collider *c, double time, double turned[3]) {
    body_pose pose;
    motion_pose(c, time, &pose);
    gltf_turn(pose.origin, turned);
}

/** How it is turned then: a unit quaternion (x, y, z, w). */
static inline void gltf_rotation(const collider *c, double time, double quaternion[4]) {
    const double half = motion_angle(c, time) / 2;
    double axis[3];
    gltf_turn(c->turn_axis, axis);
    for (int a = 0; a < 3; a++)
        quaternion[a] = sin(half) * axis[a];
    quaternion[3] = cos(half);
}

static inline int gltf_is_moving(const collider *c) {
    return vector_dot(c->velocity, c->velocity) > 0 || motion_has_keys(c);
}

/** How many of the solids before the first `count` move; how many turn. */
static inline int gltf_moving_before(const gltf *g, int count) {
    int moving = 0;
    for (int k = 0; k < count; k++)
        moving += gltf_is_moving(g->solids[k].of);
    return moving;
}

static inline int gltf_turning_before(const gltf *g, int count) {
    int turning = 0;
    for (int k = 0; k < count; k++)
        turning += motion_turns(g->solids[k].of);
    return turning;
}

/** Bytes of each part. */
void gltf_measure(const gltf *g, uint64_t size[PARTS]);

/** The JSON, but for its end: the last thing is the buffer's length. To be freed; NULL: out of
 *  memory. */
char *gltf_json(const gltf *g, size_t *length);

#endif
