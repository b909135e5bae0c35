/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define GL_GLEXT_PROTOTYPES
#include "view/shadow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

enum { SHADOW_SIZE = 2048 };

int shadow_new(shadow *s) {
    static const GLfloat lit[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    *s = (shadow){.pixels = malloc((size_t)4 * SHADOW_SIZE * SHADOW_SIZE)};
    if (!s->pixels)
        return -1;
    glGenTextures(1, &s->depths);
    glBindTexture(GL_TEXTURE_2D, s->depths);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
    return 0;
}

void shadow_free(shadow *s) {
    if (s->pixels)
        glDeleteTextures(1, &s->depths);
    free(s->pixels);
    *s = (shadow){0};
}

/* Sets an orthographic view along the light that contains everything within `radius` of `center`.
 * In depth it extends to four times the radius in both directions, so that objects there are not
 * clipped. */
static void set_light_view(const float light[3], const double center[3], double radius) {
    double back[3] = {(double)light[0], (double)light[1], (double)light[2]}, right[3], up[3];
    double view[16] = {0};
    const double length = vector_length(back), upright[3] = {0, 0, 1}, along[3] = {0, 1, 0};
    for (int a = 0; a < 3; a++)
        back[a] /= length;
    vector_cross(fabs(back[2]) < 0.9 ? upright : along, back, right);
    const double size = vector_length(right);
    for (int a = 0; a < 3; a++)
        right[a] /= size;
    vector_cross(back, right, up);
    for (int a = 0; a < 3; a++) {
        view[4 * a] = right[a];
        view[4 * a + 1] = up[a];
        view[4 * a + 2] = back[a];
    }
    view[15] = 1;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-radius, radius, -radius, radius, -4 * radius, 4 * radius);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(view);
    glTranslated(-center[0], -center[1], -center[2]);
}

/* Stores the product of the light's matrices with the map from [-1, 1] to [0, 1]. */
static void set_texture_matrix(shadow *s) {
    double projection[16], view[16];
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetDoublev(GL_MODELVIEW_MATRIX, view);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslated(0.5, 0.5, 0.5);
    glScaled(0.5, 0.5, 0.5);
    glMultMatrixd(projection);
    glMultMatrixd(view);
    glGetDoublev(GL_TEXTURE_MATRIX, s->from_world);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
}

int shadow_begin(shadow *s, OSMesaContext context, const float light[3], const double center[3],
                 double radius) {
    if (!OSMesaMakeCurrent(context, s->pixels, GL_UNSIGNED_BYTE, SHADOW_SIZE, SHADOW_SIZE))
        return -1;
    glViewport(0, 0, SHADOW_SIZE, SHADOW_SIZE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    set_light_view(light, center, radius);
    set_texture_matrix(s);
    /* Stores slightly larger depths; otherwise surfaces would shadow themselves in places. */
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(3.0f, 6.0f);
    return 0;
}

void shadow_end(shadow *s) {
    glBindTexture(GL_TEXTURE_2D, s->depths);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, SHADOW_SIZE, SHADOW_SIZE, 0);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glFinish();
}

void shadow_apply(const shadow *s) {
    static const GLenum coordinate[4] = {GL_S, GL_T, GL_R, GL_Q};
    static const GLenum generated[4] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R,
                                        GL_TEXTURE_GEN_Q};
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, s->depths);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glMatrixMode(GL_TEXTURE);
    glLoadMatrixd(s->from_world);
    glMatrixMode(GL_MODELVIEW);
    for (int a = 0; a < 4; a++) { /* makes the texture coordinates equal to the position in the
                                   * world */
        GLdouble axis[4] = {0};
        axis[a] = 1;
        glTexGeni(coordinate[a], GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGendv(coordinate[a], GL_EYE_PLANE, axis);
        glEnable(generated[a]);
    }
    glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
}

void shadow_stop(void) {
    glActiveTexture(GL_TEXTURE1);
    glDisable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
}
