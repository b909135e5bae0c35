/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Draws cloth and colliders, off screen (OSMesa: no display and no graphics card is needed). */
#ifndef FABRIC_VIEW_STAGE_H
#define FABRIC_VIEW_STAGE_H

#include "scene/scene.h"
#include "view/camera.h"
#include "view/picture.h"

typedef struct stage stage;

/** The cloth at one moment. */
typedef struct stage_cloth {
    int vertex_count, triangle_count;
    const double *position; /* [3 * vertex_count] m */
    const int *triangle;    /* [3 * triangle_count] */
    const float *material;  /* [2 * vertex_count] m, coordinates for the woven pattern */
} stage_cloth;

/** Prepares pictures of this size. Returns NULL after a message on standard error. Only one stage
 *  may exist at a time, because OSMesa's current context is global. The scene must outlive it. */
stage *stage_new(const scene *s, int width, int height);
void stage_free(stage *st);

/** Draws the scene at `time` (s; it determines the colliders' poses) into p, which picture_free
 *  frees. Returns 0, or -1 after a message on standard error. */
int stage_draw(stage *st, const camera *from, const stage_cloth *cloth, double time, picture *p);

/** Sets the projection and model-view matrices of OpenGL's current context to the camera's. */
void stage_set_camera(const camera *from);

#endif
