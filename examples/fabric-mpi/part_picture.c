/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "part_picture.h"

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/vector.h"
#include "petsc_check.h"
#include "view/camera.h"
#include "view/picture.h"
#include "view/stage.h"

/* Sizes in the picture, in pixels. Panels are drawn FINE (four) times as wide and high, then halved
 * twice. */
enum { PANEL = 560, LEGEND = 60, SWATCH = 28, STEP = 84, FINE = 4 };
/* With more triangles than this, edges are not drawn, since they would hide the small triangles. */
enum { MOST_WITH_EDGES = 20000 };

/* From Okabe and Ito's palette for colour-blind readers. */
static const unsigned char colours[PICTURE_RANKS][3] = {
    {86, 180, 233}, {230, 159, 0}, {0, 158, 115},   {204, 121, 167},
    {240, 228, 66}, {213, 94, 0},  {120, 130, 220}, {170, 170, 170},
};

typedef struct part_picture {
    char path[FILE_PATH_SIZE];
    int ranks, vertices, triangles;
    int *owner;         /* [vertices] */
    int (*triangle)[3]; /* [triangles] */
    double (*flat)[3];  /* [vertices] material coordinates, with z = 0 */
} part_picture;

part_picture *part_picture_new(const part *p, const mesh *whole, const division *d) {
    char path[FILE_PATH_SIZE];
    PetscBool wanted;
    CHECK(PetscOptionsGetString(NULL, NULL, "-part_picture", path, sizeof path, &wanted));
    if (!wanted || p->rank != LEADER)
        return NULL;
    part_picture *of = part_memory(1, sizeof *of);
    memcpy(of->path, path, sizeof path);
    of->ranks = p->ranks;
    of->vertices = whole->vertex_count;
    of->triangles = whole->triangle_count;
    of->owner = part_memory((size_t)of->vertices, sizeof *of->owner);
    of->flat = part_memory((size_t)of->vertices, sizeof *of->flat);
    of->triangle = part_memory((size_t)of->triangles, sizeof *of->triangle);
    memcpy(of->triangle, whole->triangle, (size_t)of->triangles * sizeof *of->triangle);
    for (int v = 0; v < of->vertices; v++) {
        of->owner[v] = d->owner[d->of[v]];
        memcpy(of->flat[v], whole->material[v], sizeof *whole->material);
    }
    return of;
}

void part_picture_free(part_picture *of) {
    if (!of)
        return;
    free(of->owner);
    free(of->flat);
    free(of->triangle);
    free(of);
}

/* One of the picture's two panels: its left edge, and its view. */
typedef struct panel {
    int left;
    const double (*x)[3];
    camera from;
    int is_flat;          /* orthographic from above, without shading */
    double low[2], width; /* if flat: lower corner and width of the view, m */
} panel;

static panel flat_panel(const part_picture *of) {
    panel view = {.x = (const double(*)[3])of->flat, .is_flat = 1};
    double high[2];
    memcpy(view.low, of->flat[0], sizeof view.low);
    memcpy(high, of->flat[0], sizeof high);
    for (int v = 0; v < of->vertices; v++)
        for (int k = 0; k < 2; k++) {
            view.low[k] = fmin(view.low[k], of->flat[v][k]);
            high[k] = fmax(high[k], of->flat[v][k]);
        }
    view.width = fmax(high[0] - view.low[0], high[1] - view.low[1]) * 1.08; /* a margin */
    for (int k = 0; k < 2; k++)
        view.low[k] = (view.low[k] + high[k] - view.width) / 2;
    return view;
}

static panel space_panel(const part_picture *of, const double (*x)[3]) {
    static const double back[3] = {0.8, -1.0, 0.9};
    panel view = {.left = PANEL * FINE, .x = x};
    view.from = camera_frame(back, 1, (double(*)[3])x, of->vertices);
    return view;
}

static void look(const panel *view) {
    glViewport(view->left, LEGEND * FINE, PANEL * FINE, PANEL * FINE);
    if (!view->is_flat) {
        stage_set_camera(&view->from);
        return;
    }
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(view->low[0], view->low[0] + view->width, view->low[1], view->low[1] + view->width, -1,
            1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/* Returns the brightness of a triangle: it depends on the angle of the normal, on either side, to a
 * light that is a little above the eye. */
static double brightness(const panel *view, const int triangle[3]) {
    double edge[2][3], normal[3], light[3];
    if (view->is_flat)
        return 1;
    for (int k = 0; k < 2; k++)
        vector_subtract(view->x[triangle[k + 1]], view->x[triangle[0]], edge[k]);
    vector_cross(edge[0], edge[1], normal);
    vector_add_scaled(view->from.back, 0.5, view->from.up, light);
    const double length = vector_length(normal) * vector_length(light);
    return 0.45 + 0.55 * (length > 0 ? fabs(vector_dot(normal, light)) / length : 0);
}

/* Sets the colour, darkened by `bright`, with the fraction `white` of white mixed in. */
static void choose_colour(const unsigned char colour[3], double bright, double white) {
    GLubyte mixed[3];
    for (int a = 0; a < 3; a++)
        mixed[a] = (GLubyte)(colour[a] * bright + (255 - colour[a] * bright) * white);
    glColor3ubv(mixed);
}

/* Draws a corner's third of the triangle: the quadrilateral of the corner, the middles of its two
 * sides and the triangle's middle. */
static void draw_corner(const double corner[3], const double one[3], const double other[3],
                        const double middle[3], int with_edges, const unsigned char colour[3],
                        double bright) {
    choose_colour(colour, bright, 0);
    glBegin(GL_POLYGON);
    glVertex3dv(corner);
    glVertex3dv(one);
    glVertex3dv(middle);
    glVertex3dv(other);
    glEnd();
    if (!with_edges)
        return;
    choose_colour(colour, bright, 0.3);
    glBegin(GL_LINE_STRIP);
    glVertex3dv(one);
    glVertex3dv(corner);
    glVertex3dv(other);
    glEnd();
}

static void draw_triangle(const part_picture *of, const panel *view, int t) {
    const int *vertex = of->triangle[t];
    const int is_shared = of->owner[vertex[0]] != of->owner[vertex[1]] ||
                          of->owner[vertex[0]] != of->owner[vertex[2]];
    const double bright = brightness(view, vertex) * (is_shared ? 0.5 : 1);
    double side[3][3], middle[3]; /* side[k]: middle of the side opposite corner k */
    for (int a = 0; a < 3; a++) {
        for (int k = 0; k < 3; k++)
            side[k][a] = (view->x[vertex[(k + 1) % 3]][a] + view->x[vertex[(k + 2) % 3]][a]) / 2;
        middle[a] = (side[0][a] + side[1][a] + side[2][a]) / 3;
    }
    for (int k = 0; k < 3; k++)
        draw_corner(view->x[vertex[k]], side[(k + 1) % 3], side[(k + 2) % 3], middle,
                    of->triangles <= MOST_WITH_EDGES, colours[of->owner[vertex[k]] % PICTURE_RANKS],
                    bright);
}

static void draw_square(picture *p, int left, int top, int width, const unsigned char colour[3],
                        double bright) {
    for (int y = top; y < top + SWATCH; y++)
        for (int x = left; x < left + width; x++)
            for (int a = 0; a < 3; a++)
                p->rgb[3 * ((size_t)y * (size_t)p->width + (size_t)x) + (size_t)a] =
                    (unsigned char)(colour[a] * bright);
}

/* Draws each rank's two colours and its number, centred below the panels. */
static void draw_legend(picture *p, int ranks) {
    const int shown = ranks < PICTURE_RANKS ? ranks : PICTURE_RANKS;
    const int left = (p->width - shown * STEP) / 2, top = PANEL + (LEGEND - SWATCH) / 2;
    for (int r = 0; r < shown; r++) {
        char number[16];
        snprintf(number, sizeof number, "%d", r);
        draw_square(p, left + r * STEP, top, SWATCH / 2, colours[r], 1);
        draw_square(p, left + r * STEP + SWATCH / 2, top, SWATCH / 2, colours[r], 0.5);
        picture_text(p, left + r * STEP + SWATCH + 8, top + 4, 3, number);
    }
}

static void draw_panels(const part_picture *of, const double (*x)[3]) {
    const panel panels[] = {flat_panel(of), space_panel(of, x)};
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_POLYGON_OFFSET_FILL); /* so that edges are in front of the triangles */
    glPolygonOffset(1, 1);
    glLineWidth(FINE * 0.75f);
    for (size_t k = 0; k < sizeof panels / sizeof *panels; k++) {
        look(&panels[k]);
        for (int t = 0; t < of->triangles; t++)
            draw_triangle(of, &panels[k], t);
    }
    glFinish();
}

/* Draws the panels off screen, FINE times as large. Returns 0, or -1 if out of memory. */
static int draw_large(const part_picture *of, const double (*x)[3], picture *large) {
    const int width = 2 * PANEL * FINE, height = (PANEL + LEGEND) * FINE;
    const size_t count = (size_t)width * (size_t)height;
    unsigned char *pixels = malloc(4 * count);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    int status = -1;
    if (pixels && context && picture_new(large, width, height) == 0 &&
        OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height)) {
        OSMesaPixelStore(OSMESA_Y_UP, 0);
        draw_panels(of, x);
        for (size_t k = 0; k < count; k++)
            memcpy(large->rgb + 3 * k, pixels + 4 * k, 3);
        status = 0;
    }
    if (context)
        OSMesaDestroyContext(context);
    free(pixels);
    return status;
}

void part_picture_write(const part_picture *of, const double (*x)[3]) {
    picture large = {0}, half = {0}, done = {0};
    if (!of)
        return;
    if (draw_large(of, x, &large) != 0 || picture_halve(&large, &half) != 0 ||
        picture_halve(&half, &done) != 0)
        part_give_up("out of memory for -part_picture");
    draw_legend(&done, of->ranks);
    if (picture_write_png(&done, of->path) != 0)
        part_give_up("-part_picture: the picture is not written");
    picture_free(&large);
    picture_free(&half);
    picture_free(&done);
}
