/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Delaunay meshes by libqhull. */
#include "mesh.h"

#include <libqhull_r/qhull_ra.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_parts.h"

enum { ERROR_SIZE = 256 };

/** Twice the signed area of three points. */
static double doubled_area(double (*p)[2], const int t[3]) {
    return (p[t[1]][0] - p[t[0]][0]) * (p[t[2]][1] - p[t[0]][1]) -
           (p[t[2]][0] - p[t[0]][0]) * (p[t[1]][1] - p[t[0]][1]);
}

/** Converts a facet of qhull to a counter-clockwise triangle. Returns 0, or -1 if it is
 *  degenerate. */
static int take_facet(qhT *qh, const facetT *facet, double (*points)[2], int triangle[3]) {
    vertexT *vertex, **vertexp;
    int corners = 0;
    FOREACHvertex_(facet->vertices) {
        if (corners < 3)
            triangle[corners] = qh_pointid(qh, vertex->point);
        corners++;
    }
    if (corners != 3)
        return -1;
    const double area = doubled_area(points, triangle);
    if (area < 0.0) {
        const int swap = triangle[1];
        triangle[1] = triangle[2];
        triangle[2] = swap;
    }
    return area == 0.0 ? -1 : 0;
}

/** Copies the Delaunay triangles: the lower side of the convex hull of the points lifted to a
 *  paraboloid. */
static int take_facets(qhT *qh, double (*points)[2], mesh *m, char *error) {
    facetT *facet;
    int found = 0;
    FORALLfacets {
        if (facet->upperdelaunay)
            continue;
        if (found < m->triangle_count && take_facet(qh, facet, points, m->triangle[found]) != 0) {
            snprintf(error, ERROR_SIZE, "the triangulation has a degenerate triangle");
            return -1;
        }
        found++;
    }
    if (found != m->triangle_count) {
        snprintf(error, ERROR_SIZE, "the triangulation has %d triangles, %d were expected", found,
                 m->triangle_count);
        return -1;
    }
    return 0;
}

static int triangulate(mesh *m, double (*points)[2], char *error) {
    qhT qhull;
    char *log = NULL, options[] = "qhull d Qbb Qt";
    size_t log_size = 0;
    int not_freed, total, status = -1;
    FILE *stream = open_memstream(&log, &log_size);
    if (!stream) {
        snprintf(error, ERROR_SIZE, "out of memory");
        return -1;
    }
    qh_zero(&qhull, stream);
    if (qh_new_qhull(&qhull, 2, m->vertex_count, &points[0][0], False, options, NULL, stream) == 0)
        status = take_facets(&qhull, points, m, error);
    else {
        fflush(stream);
        snprintf(error, ERROR_SIZE, "qhull: %.*s", (int)strcspn(log ? log : "", "\n"),
                 log ? log : "");
    }
    qh_freeqhull(&qhull, !qh_ALL);
    qh_memfreeshort(&qhull, &not_freed, &total);
    fclose(stream);
    free(log);
    return status;
}

static int check_request(int vertices, int boundary, double side, char *error) {
    if (boundary < 4 || vertices <= boundary)
        snprintf(
            error, ERROR_SIZE,
            "a mesh needs 4 vertices or more on its border and at least one inside, not %d of %d",
            boundary, vertices);
    else if (!(side > 0.0))
        snprintf(error, ERROR_SIZE, "a mesh's side must be greater than 0");
    else
        return 0;
    return -1;
}

int mesh_generate(mesh *m, int vertices, int boundary, double side, unsigned seed, char *error) {
    *m = (mesh){0};
    if (check_request(vertices, boundary, side, error) != 0)
        return -1;
    double(*points)[2] = malloc((size_t)vertices * sizeof *points);
    /* Euler: vertices - edges + triangles = 1, and 2 * edges = 3 * triangles + boundary. */
    if (!points || mesh_allocate(m, vertices, 2 * vertices - 2 - boundary) != 0 ||
        mesh_points(points, vertices, boundary, seed) != 0) {
        snprintf(error, ERROR_SIZE, "out of memory");
        goto failed;
    }
    if (triangulate(m, points, error) != 0)
        goto failed;
    for (int i = 0; i < vertices; i++) {
        m->material[i][0] = side * points[i][0];
        m->material[i][1] = side * points[i][1];
        m->position[i][0] = m->material[i][0];
        m->position[i][1] = m->material[i][1];
        m->position[i][2] = 0.0;
    }
    mesh_sort_triangles(m); /* makes the result independent of qhull's order */
    free(points);
    return 0;
failed:
    free(points);
    mesh_free(m);
    return -1;
}
