/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/stage.h"

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "view/patch.h"
#include "view/shadow.h"
#include "view/solids.h"

struct stage {
    const scene *of;
    int width, height;
    OSMesaContext context;
    unsigned char *pixels; /* [height][width][4] */
    GLuint weave;
    shadow shadow; /* shadows that cloth and solids cast on themselves and each other */
};

static const GLfloat BACKGROUND[3] = {0.93f, 0.945f, 0.96f};
static const GLfloat LIGHT[4] = {-0.45f, -0.8f, 1.1f, 0.0f}; /* direction to the light, which is at
                                                              * infinity (w = 0) */
static const double REPEAT = 0.16; /* m, period of the pattern woven into the cloth */
enum { WEAVE = 64 };
/* Limits of the number of small triangles in a picture, and of parts of a side. More would not be
 * visible. */
enum { MOST_PIECES = 300000, MOST_PARTS = 5 };

/** Makes the texture of a checked cloth: two crossing stripes. */
static GLuint make_weave(void) {
    static const double light[3] = {244.0, 240.0, 230.0}, dark[3] = {38.0, 98.0, 140.0};
    unsigned char texel[WEAVE][WEAVE][3];
    GLuint name;
    for (int y = 0; y < WEAVE; y++)
        for (int x = 0; x < WEAVE; x++) {
            const double share = 0.5 * ((x < WEAVE / 2) + (y < WEAVE / 2));
            for (int c = 0; c < 3; c++)
                texel[y][x][c] = (unsigned char)(light[c] + share * (dark[c] - light[c]));
        }
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, WEAVE, WEAVE, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    return name;
}

static void set_light(void) {
    static const GLfloat key[4] = {0.66f, 0.64f, 0.60f, 1.0f};
    static const GLfloat fill[4] = {0.16f, 0.17f, 0.20f, 1.0f};
    static const GLfloat fill_from[4] = {0.9f, -0.5f, 0.25f, 0.0f};
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, key);
    glLightfv(GL_LIGHT0, GL_POSITION, LIGHT);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, fill);
    glLightfv(GL_LIGHT1, GL_POSITION, fill_from);
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
}

/** Switches the key light on or off, and likewise the ambient and fill light (`others`). */
static void switch_lights(int key, int others) {
    static const GLfloat ambient[4] = {0.39f, 0.40f, 0.43f, 1.0f}, none[4] = {0, 0, 0, 1.0f};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, others ? ambient : none);
    (key ? glEnable : glDisable)(GL_LIGHT0);
    (others ? glEnable : glDisable)(GL_LIGHT1);
}

static void set_material(GLenum side, float red, float green, float blue) {
    const GLfloat color[4] = {red, green, blue, 1.0f};
    glMaterialfv(side, GL_AMBIENT_AND_DIFFUSE, color);
}

stage *stage_new(const scene *s, int width, int height) {
    stage *st = calloc(1, sizeof *st);
    if (!st) {
        fprintf(stderr, "render: out of memory\n");
        return NULL;
    }
    st->of = s;
    st->width = width;
    st->height = height;
    st->pixels = malloc(4 * (size_t)width * (size_t)height);
    st->context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!st->pixels || !st->context ||
        !OSMesaMakeCurrent(st->context, st->pixels, GL_UNSIGNED_BYTE, width, height)) {
        fprintf(stderr, "render: OSMesa cannot draw pictures of %d by %d\n", width, height);
        stage_free(st);
        return NULL;
    }
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    st->weave = make_weave();
    if (shadow_new(&st->shadow) != 0) {
        fprintf(stderr, "render: out of memory\n");
        stage_free(st);
        return NULL;
    }
    return st;
}

void stage_free(stage *st) {
    if (!st)
        return;
    shadow_free(&st->shadow);
    if (st->context)
        OSMesaDestroyContext(st->context);
    free(st->pixels);
    free(st);
}

void stage_set_camera(const camera *from) {
    const double near = 0.25 * from->depth[0], far = 4.0 * from->depth[1] + 20.0;
    GLdouble view[16] = {0.0};
    for (int k = 0; k < 3; k++) {
        view[4 * k] = from->right[k];
        view[4 * k + 1] = from->up[k];
        view[4 * k + 2] = from->back[k];
    }
    view[15] = 1.0;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-near * from->slope[0], near * from->slope[0], -near * from->slope[1],
              near * from->slope[1], near, far);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(view);
    glTranslated(-from->eye[0], -from->eye[1], -from->eye[2]);
}

static void draw_cloth(const stage *st, const patches *cloth) {
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, st->weave);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScaled(1.0 / REPEAT, 1.0 / REPEAT, 1.0);
    glMatrixMode(GL_MODELVIEW);
    set_material(GL_FRONT, 1.0f, 1.0f, 1.0f);
    set_material(GL_BACK, 1.0f, 0.86f, 0.76f);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(3, GL_DOUBLE, 0, cloth->position);
    glNormalPointer(GL_FLOAT, 0, cloth->normal);
    glTexCoordPointer(2, GL_FLOAT, 0, cloth->material);
    glDrawElements(GL_TRIANGLES, 3 * cloth->triangle_count, GL_UNSIGNED_INT, cloth->triangle);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glDisableClientState(GL_NORMAL_ARRAY);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisable(GL_TEXTURE_2D);
}

static void draw_bare_cloth(const patches *cloth) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_DOUBLE, 0, cloth->position);
    glDrawElements(GL_TRIANGLES, 3 * cloth->triangle_count, GL_UNSIGNED_INT, cloth->triangle);
    glDisableClientState(GL_VERTEX_ARRAY);
}

static void draw_solids(const stage *st, double time) {
    for (int k = 0; k < st->of->collider_count; k++) {
        const collider *c = &st->of->colliders[k];
        if (c->kind == COLLIDER_BOX)
            set_material(GL_FRONT_AND_BACK, 0.62f, 0.44f, 0.30f);
        else
            set_material(GL_FRONT_AND_BACK, 0.80f, 0.52f, 0.28f);
        solids_draw(c, time);
    }
}

/** Projects all later drawing onto the plane, away from the light. */
static void flatten(const double normal[3], double offset) {
    double slope = 0.0, matrix[16] = {0.0};
    for (int k = 0; k < 3; k++)
        slope += normal[k] * (double)LIGHT[k];
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            matrix[4 * column + row] =
                (row == column ? 1.0 : 0.0) - (double)LIGHT[row] * normal[column] / slope;
        matrix[12 + row] = (double)LIGHT[row] * offset / slope;
    }
    matrix[15] = 1.0;
    glMultMatrixd(matrix);
}

/** Darkens the plane in the shadows of cloth and solids. A stencil limits this to once per
 *  pixel. */
static void draw_shadows(const stage *st, const collider *plane, const patches *cloth,
                         double time) {
    double offset = 0.001; /* m above the plane, so that the plane does not hide the shadow */
    double towards_light = 0.0, point[3], normal[3];
    solids_plane(plane, time, point, normal);
    for (int k = 0; k < 3; k++) {
        offset += normal[k] * point[k];
        towards_light += normal[k] * (double)LIGHT[k];
    }
    if (towards_light < 0.1)
        return;
    glDisable(GL_LIGHTING);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glColor4f(0.10f, 0.12f, 0.18f, 0.28f);
    glPushMatrix();
    flatten(normal, offset);
    draw_bare_cloth(cloth);
    draw_solids(st, time);
    glPopMatrix();
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_BLEND);
    glEnable(GL_LIGHTING);
}

static void take_picture(const stage *st, picture *p) {
    for (size_t k = 0; k < (size_t)st->width * (size_t)st->height; k++)
        memcpy(p->rgb + 3 * k, st->pixels + 4 * k, 3);
}

/** Draws the shadow map: cloth and solids as seen from the light. */
static int draw_shadow_map(stage *st, const patches *cloth, double time) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double center[3], square = 0.0;
    for (int i = 0; i < cloth->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], cloth->position[3 * (size_t)i + (size_t)k]);
            high[k] = fmax(high[k], cloth->position[3 * (size_t)i + (size_t)k]);
        }
    for (int k = 0; k < 3; k++) {
        center[k] = (low[k] + high[k]) / 2.0;
        square += (high[k] - low[k]) * (high[k] - low[k]) / 4.0;
    }
    if (shadow_begin(&st->shadow, st->context, LIGHT, center, 1.1 * sqrt(square)) != 0)
        return -1;
    glDisable(GL_LIGHTING);
    draw_bare_cloth(cloth);
    draw_solids(st, time);
    shadow_end(&st->shadow);
    return OSMesaMakeCurrent(st->context, st->pixels, GL_UNSIGNED_BYTE, st->width, st->height) ? 0
                                                                                               : -1;
}

/** Draws cloth and solids in two passes: first without the key light, then adding the key light
 *  outside of shadows. */
static void draw_lit(const stage *st, const patches *cloth, double time) {
    switch_lights(0, 1);
    draw_solids(st, time);
    draw_cloth(st, cloth);
    switch_lights(1, 0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthFunc(GL_LEQUAL);
    shadow_apply(&st->shadow);
    draw_solids(st, time);
    draw_cloth(st, cloth);
    shadow_stop();
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
}

static void draw_planes(const stage *st, const camera *from, const patches *cloth, double time) {
    const double middle[3] = {from->eye[0] - from->back[0] * from->depth[1],
                              from->eye[1] - from->back[1] * from->depth[1], 0.0};
    switch_lights(1, 1);
    for (int k = 0; k < st->of->collider_count; k++) {
        const collider *c = &st->of->colliders[k];
        if (c->kind != COLLIDER_PLANE)
            continue;
        solids_draw_plane(c, time, middle, 2.0 * from->depth[1], BACKGROUND);
        draw_shadows(st, c, cloth, time);
    }
}

/** Draws into the stage's pixels. Returns 0, or -1 if OSMesa fails. */
static int draw_all(stage *st, const camera *from, const patches *cloth, double time) {
    if (draw_shadow_map(st, cloth, time) != 0)
        return -1;
    glViewport(0, 0, st->width, st->height);
    glClearColor(BACKGROUND[0], BACKGROUND[1], BACKGROUND[2], 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    stage_set_camera(from);
    set_light();
    draw_planes(st, from, cloth, time);
    draw_lit(st, cloth, time);
    glFinish();
    return 0;
}

/** The number of parts into which each side of a triangle is divided for drawing. */
static int parts_of(int triangle_count) {
    int parts = MOST_PARTS;
    while (parts > 1 && (long)triangle_count * parts * parts > MOST_PIECES)
        parts--;
    return parts;
}

int stage_draw(stage *st, const camera *from, const stage_cloth *cloth, double time, picture *p) {
    patches smooth;
    int status = patches_make(&smooth, cloth->vertex_count, cloth->triangle_count, cloth->position,
                              cloth->material, cloth->triangle, parts_of(cloth->triangle_count));
    if (status == 0)
        status = picture_new(p, st->width, st->height);
    if (status != 0) {
        fprintf(stderr, "render: out of memory\n");
    } else if (draw_all(st, from, &smooth, time) != 0) {
        fprintf(stderr, "render: OSMesa cannot draw shadows\n");
        picture_free(p);
        status = -1;
    } else {
        take_picture(st, p);
    }
    patches_free(&smooth);
    return status;
}
