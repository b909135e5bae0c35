/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/solids.h"

#include <GL/gl.h>
#include <math.h>

#include "base/vector.h"
#include "contact/motion.h"
#include "mesh/surface.h"

enum { AROUND = 96, DOWN = 48 };
static const double PI = 3.14159265358979323846;
static const double TILE = 0.25; /* m, side of a tile */

/** Computes two unit vectors at right angles to the axis and to each other. */
static void axes_across(const double axis[3], double first[3], double second[3]) {
    const int other =
        fabs(axis[0]) < 0.9 ? 0 : 1; /* a coordinate axis that is not parallel to `axis` */
    double length = 0.0;
    for (int k = 0; k < 3; k++) {
        first[k] = (k == other ? 1.0 : 0.0) - axis[other] * axis[k];
        length += first[k] * first[k];
    }
    for (int k = 0; k < 3; k++)
        first[k] /= sqrt(length);
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        second[k] = axis[i] * first[j] - axis[j] * first[i];
    }
}

static void draw_box(const collider *c, const double center[3]) {
    glBegin(GL_QUADS);
    for (int face = 0; face < 6; face++) {
        const int across = face / 2, i = (across + 1) % 3, j = (across + 2) % 3;
        const double side = face % 2 == 0 ? 1.0 : -1.0;
        double normal[3] = {0.0, 0.0, 0.0}, corner[3];
        normal[across] = side;
        glNormal3dv(normal);
        for (int k = 0; k < 4; k++) {
            const double u = k == 1 || k == 2 ? 1.0 : -1.0, v = k >= 2 ? 1.0 : -1.0;
            corner[across] = center[across] + side * c->size[across];
            corner[i] = center[i] + side * u * c->size[i]; /* counter-clockwise from outside */
            corner[j] = center[j] + v * c->size[j];
            glVertex3dv(corner);
        }
    }
    glEnd();
}

static void sphere_vertex(const collider *c, const double center[3], int around, int down) {
    const double longitude = 2.0 * PI * around / (double)AROUND,
                 latitude = PI * (0.5 - (double)down / (double)DOWN);
    const double normal[3] = {cos(latitude) * cos(longitude), cos(latitude) * sin(longitude),
                              sin(latitude)};
    glNormal3dv(normal);
    glVertex3d(center[0] + c->size[0] * normal[0], center[1] + c->size[0] * normal[1],
               center[2] + c->size[0] * normal[2]);
}

static void draw_sphere(const collider *c, const double center[3]) {
    for (int down = 0; down < DOWN; down++) {
        glBegin(GL_QUAD_STRIP);
        for (int around = 0; around <= AROUND; around++) {
            sphere_vertex(c, center, around, down);
            sphere_vertex(c, center, around, down + 1);
        }
        glEnd();
    }
}

/** Computes a point of the circle at the cylinder's end `end` (-1 or 1), and the normal of the
 *  curved side there. */
static void edge_point(const collider *c, const double center[3], int around, double end,
                       double point[3], double normal[3]) {
    double first[3], second[3];
    const double angle = 2.0 * PI * around / (double)AROUND;
    axes_across(c->axis, first, second);
    for (int k = 0; k < 3; k++) {
        normal[k] = cos(angle) * first[k] + sin(angle) * second[k];
        point[k] = center[k] + c->size[0] * normal[k] + end * c->size[1] * c->axis[k];
    }
}

static void draw_cylinder(const collider *c, const double center[3]) {
    double point[3], normal[3];
    glBegin(GL_QUAD_STRIP);
    for (int around = 0; around <= AROUND; around++)
        for (int end = 1; end >= -1; end -= 2) {
            edge_point(c, center, around, end, point, normal);
            glNormal3dv(normal);
            glVertex3dv(point);
        }
    glEnd();
    for (int end = -1; end <= 1; end += 2) {
        glBegin(GL_POLYGON);
        glNormal3d(end * c->axis[0], end * c->axis[1], end * c->axis[2]);
        for (int around = 0; around < AROUND; around++) {
            edge_point(c, center, end * around, end, point, normal);
            glVertex3dv(point);
        }
        glEnd();
    }
}

static void draw_mesh(const collider *c, const double center[3]) {
    const mesh *m = surface_mesh(c->surface);
    glBegin(GL_TRIANGLES);
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            const int v = m->triangle[t][p];
            glNormal3dv(surface_normal(c->surface, v));
            glVertex3d(center[0] + m->position[v][0], center[1] + m->position[v][1],
                       center[2] + m->position[v][2]);
        }
    glEnd();
}

void solids_draw(const collider *c, double time) {
    static const double center[3] = {0.0, 0.0, 0.0};
    double columns[16] = {0.0};
    body_pose pose;
    motion_pose(c, time, &pose);
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            columns[4 * column + row] = pose.rotation[row][column];
    for (int row = 0; row < 3; row++)
        columns[12 + row] = pose.origin[row];
    columns[15] = 1.0;
    glPushMatrix();
    glMultMatrixd(columns);
    if (c->kind == COLLIDER_BOX)
        draw_box(c, center);
    else if (c->kind == COLLIDER_SPHERE)
        draw_sphere(c, center);
    else if (c->kind == COLLIDER_CYLINDER)
        draw_cylinder(c, center);
    else if (c->kind == COLLIDER_MESH)
        draw_mesh(c, center);
    glPopMatrix();
}

void solids_plane(const collider *c, double time, double point[3], double normal[3]) {
    body_pose pose;
    motion_pose(c, time, &pose);
    for (int k = 0; k < 3; k++) {
        point[k] = pose.origin[k];
        normal[k] = vector_dot(pose.rotation[k], c->axis);
    }
}

/** Sets the colour of a tile's corner at (x, y) from the middle; it fades outwards to the
 * background.
 */
static void tile_color(double x, double y, int odd, double reach, const float background[3]) {
    const float own = odd ? 0.80f : 0.845f;
    const double distance = sqrt(x * x + y * y) / reach;
    const float fade = distance < 1.0 ? (float)(distance * distance) : 1.0f;
    glColor3f(own + fade * (background[0] - own), own + fade * (background[1] - own),
              own + fade * (background[2] - own));
}

void solids_draw_plane(const collider *c, double time, const double middle[3], double reach,
                       const float background[3]) {
    double position[3], normal[3], first[3], second[3], from[2] = {0.0, 0.0};
    const int tiles = (int)ceil(reach / TILE);
    solids_plane(c, time, position, normal);
    axes_across(normal, first, second);
    for (int k = 0; k < 3; k++) {
        from[0] += (middle[k] - position[k]) * first[k];
        from[1] += (middle[k] - position[k]) * second[k];
    }
    const long start[2] = {(long)floor(from[0] / TILE), (long)floor(from[1] / TILE)};
    glDisable(GL_LIGHTING);
    glBegin(GL_QUADS);
    for (long i = start[0] - tiles; i <= start[0] + tiles; i++)
        for (long j = start[1] - tiles; j <= start[1] + tiles; j++)
            for (int corner = 0; corner < 4; corner++) {
                const double u = TILE * (double)(i + (corner == 1 || corner == 2));
                const double v = TILE * (double)(j + (corner >= 2));
                tile_color(u - from[0], v - from[1], (int)((i + j) & 1), reach, background);
                glVertex3d(position[0] + u * first[0] + v * second[0],
                           position[1] + u * first[1] + v * second[1],
                           position[2] + u * first[2] + v * second[2]);
            }
    glEnd();
    glEnable(GL_LIGHTING);
}
