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

/** A collider in the file. */
typedef struct solid {
    const collider *of;
    mesh surface;
    bounds box;
} solid;

/** Data collected before writing. */
typedef struct gltf {
    const cloth_frames *frames;
    state first;
    bounds *frame; /* [frames->count] bounds of the first frame, then of the other frames'
                    * differences from it */
    int solid_count;
    solid *solids;
    uint64_t bytes; /* number of bytes of the buffer */
} gltf;

/* The buffer's parts in the file's order. Each part is a bufferView. */
enum { CLOTH, TARGETS, CORNERS, TIMES, WEIGHTS, SOLIDS, SOLID_CORNERS, PATHS, TURNS, PARTS };

/** Converts coordinates from z up to y up. */
static inline void gltf_turn(const double p[3], double turned[3]) {
    turned[0] = p[0];
    turned[1] = p[2];
    turned[2] = 0 - p[1]; /* never -0 */
}

/** Computes the collider's position at a time, in the file's axes. */
static inline void gltf_place(const collider *c, double time, double turned[3]) {
    body_pose pose;
    motion_pose(c, time, &pose);
    gltf_turn(pose.origin, turned);
}

/** Computes the collider's rotation at a time as a unit quaternion (x, y, z, w). */
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

/** The number of moving solids among the first `count`. */
static inline int gltf_moving_before(const gltf *g, int count) {
    int moving = 0;
    for (int k = 0; k < count; k++)
        moving += gltf_is_moving(g->solids[k].of);
    return moving;
}

static inline int gltf_rotating_before(const gltf *g, int count) {
    int turning = 0;
    for (int k = 0; k < count; k++)
        turning += motion_rotates(g->solids[k].of);
    return turning;
}

/** Computes the number of bytes of each part. */
void gltf_measure(const gltf *g, uint64_t size[PARTS]);

/** Returns the JSON text up to and including the buffer's number of bytes, or NULL if out of
 *  memory. The caller writes the rest and frees the text. */
char *gltf_json(const gltf *g, size_t *length);

#endif
