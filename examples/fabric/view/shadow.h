/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A shadow map: a texture of depths as seen from the light. Points behind these depths are in
 *  shadow. Uses OpenGL's fixed-function pipeline in the current OSMesa context. */
#ifndef FABRIC_VIEW_SHADOW_H
#define FABRIC_VIEW_SHADOW_H

#include <GL/gl.h>
#include <GL/osmesa.h>

typedef struct shadow {
    GLuint depths;         /* texture of SHADOW_SIZE squared */
    unsigned char *pixels; /* buffer for the light's picture */
    double from_world[16]; /* matrix, by columns, from world coordinates (m) to texture
                            * coordinates */
} shadow;

/** Makes a shadow map. Returns 0, or -1 if out of memory. Call shadow_free in the same context. */
int shadow_new(shadow *s);
void shadow_free(shadow *s);

/** Objects drawn between this call and shadow_end cast shadows within `radius` m of `center`;
 *  `light` [3] points to the light. Returns 0, or -1 if the map cannot be drawn. */
int shadow_begin(shadow *s, OSMesaContext context, const float light[3], const double center[3],
                 double radius);
void shadow_end(shadow *s);

/** Objects drawn between this call and shadow_stop are black in shadow. The current model-view
 * matrix must be the camera's. */
void shadow_apply(const shadow *s);
void shadow_stop(void);

#endif
