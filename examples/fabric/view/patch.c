/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/patch.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

/** A patch's corners, and the control points of its cubic: along[i][j] is on the side from corner i
 *  to corner j, next to corner i. */
typedef struct cubic {
    const double *corner[3], *normal[3];
    const float *material[3];
    double along[3][3][3], middle[3];
} cubic;

/* Computes unit normals: the sum of the normals of the triangles around each vertex, weighted by
 * their areas. */
static void sum_normals(int vertex_count, int triangle_count, const double *position,
                        const int *triangle, double *normal) {
    memset(normal, 0, 3 * (size_t)vertex_count * sizeof *normal);
    for (int t = 0; t < triangle_count; t++) {
        const int *corner = &triangle[3 * (size_t)t];
        double one[3], two[3], cross[3];
        vector_subtract(&position[3 * (size_t)corner[1]], &position[3 * (size_t)corner[0]], one);
        vector_subtract(&position[3 * (size_t)corner[2]], &position[3 * (size_t)corner[0]], two);
        vector_cross(one, two, cross);
        for (int n = 0; n < 3; n++)
            for (int a = 0; a < 3; a++)
                normal[3 * (size_t)corner[n] + (size_t)a] += cross[a];
    }
    for (int i = 0; i < vertex_count; i++) {
        double *of = &normal[3 * (size_t)i];
        const double length = vector_length(of);
        for (int a = 0; a < 3; a++)
            of[a] /= length > 0 ? length : 1;
    }
}

/* A control point on a side is a third of the side away from its corner, projected onto the plane
 * of the corner's normal. */
static void find_inner_points(cubic *c) {
    double corners[3] = {0}, sides[3] = {0};
    for (int i = 0; i < 3; i++) {
        vector_add_scaled(corners, 1.0 / 3, c->corner[i], corners);
        for (int j = 0; j < 3; j++) {
            double way[3];
            if (i == j)
                continue;
            vector_subtract(c->corner[j], c->corner[i], way);
            vector_add_scaled(way, -vector_dot(way, c->normal[i]), c->normal[i], way);
            vector_add_scaled(c->corner[i], 1.0 / 3, way, c->along[i][j]);
            vector_add_scaled(sides, 1.0 / 6, c->along[i][j], sides);
        }
    }
    for (int a = 0; a < 3; a++)
        c->middle[a] = 1.5 * sides[a] - 0.5 * corners[a];
}

/* Appends the patch's point with these barycentric coordinates. */
static void put_vertex(const cubic *c, const double w[3], patches *p) {
    const size_t at = (size_t)p->vertex_count++;
    double *x = &p->position[3 * at], n[3] = {0};
    for (int a = 0; a < 3; a++)
        x[a] = 6 * w[0] * w[1] * w[2] * c->middle[a];
    p->material[2 * at] = p->material[2 * at + 1] = 0;
    for (int i = 0; i < 3; i++) {
        vector_add_scaled(x, w[i] * w[i] * w[i], c->corner[i], x);
        for (int j = 0; j < 3; j++)
            if (i != j)
                vector_add_scaled(x, 3 * w[i] * w[i] * w[j], c->along[i][j], x);
        vector_add_scaled(n, w[i], c->normal[i], n);
        for (int a = 0; a < 2; a++)
            p->material[2 * at + (size_t)a] += (float)w[i] * c->material[i][a];
    }
    const double length = vector_length(n);
    for (int a = 0; a < 3; a++)
        p->normal[3 * at + (size_t)a] = (float)(n[a] / (length > 0 ? length : 1));
}

static void put_triangle(patches *p, int a, int b, int c) {
    int *corner = &p->triangle[3 * (size_t)p->triangle_count++];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
}

/* Appends the patch's points, in rows from corner 0 to the opposite side, and its triangles. Row r
 * has r + 1 points. */
static void put_patch(const cubic *c, int parts, patches *p) {
    const int first = p->vertex_count;
    for (int r = 0; r <= parts; r++)
        for (int k = 0; k <= r; k++) {
            const double w[3] = {(double)(parts - r) / parts, (double)(r - k) / parts,
                                 (double)k / parts};
            put_vertex(c, w, p);
        }
    for (int r = 0; r < parts; r++)
        for (int k = 0; k <= r; k++) {
            const int above = first + r * (r + 1) / 2 + k, below = above + r + 1;
            put_triangle(p, above, below, below + 1);
            if (k < r)
                put_triangle(p, above, below + 1, above + 1);
        }
}

int patches_make(patches *p, int vertex_count, int triangle_count, const double *position,
                 const float *material, const int *triangle, int parts) {
    const size_t points = (size_t)triangle_count * (size_t)((parts + 1) * (parts + 2) / 2) + 1;
    const size_t pieces = (size_t)triangle_count * (size_t)(parts * parts) + 1;
    double *normal = malloc((3 * (size_t)vertex_count + 1) * sizeof *normal);
    *p = (patches){.position = malloc(3 * points * sizeof *p->position),
                   .normal = malloc(3 * points * sizeof *p->normal),
                   .material = malloc(2 * points * sizeof *p->material),
                   .triangle = malloc(3 * pieces * sizeof *p->triangle)};
    if (!normal || !p->position || !p->normal || !p->material || !p->triangle) {
        free(normal);
        return -1;
    }
    sum_normals(vertex_count, triangle_count, position, triangle, normal);
    for (int t = 0; t < triangle_count; t++) {
        cubic c;
        for (int n = 0; n < 3; n++) {
            const size_t i = (size_t)triangle[3 * (size_t)t + (size_t)n];
            c.corner[n] = &position[3 * i];
            c.normal[n] = &normal[3 * i];
            c.material[n] = &material[2 * i];
        }
        find_inner_points(&c);
        put_patch(&c, parts, p);
    }
    free(normal);
    return 0;
}

void patches_free(patches *p) {
    free(p->position);
    free(p->normal);
    free(p->material);
    free(p->triangle);
    *p = (patches){0};
}
