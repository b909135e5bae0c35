/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Rejects starts with edges through triangles, vertices in solid bodies or features that touch. The
 * message names the first such features by the vertex numbers of the mesh file (from 1). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "barrier.h"
#include "base/vector.h"
#include "motion.h"
#include "shape.h"

/* Features nearer than this fraction of their reach count as touching: the barrier is too steep
 * there for floating-point numbers. */
static const double least_part = 1e-5;

typedef struct extent {
    double low[3], high[3]; /* m */
    int triangle;
} extent;

static int by_low(const void *a, const void *b) {
    const extent *one = a, *other = b;
    const int order = (one->low[0] > other->low[0]) - (one->low[0] < other->low[0]);
    return order != 0 ? order
                      : (one->triangle > other->triangle) - (one->triangle < other->triangle);
}

static extent extent_of(const barrier *b, int triangle) {
    extent e = {.triangle = triangle};
    for (int a = 0; a < 3; a++) {
        e.low[a] = INFINITY;
        e.high[a] = -INFINITY;
        for (int p = 0; p < 3; p++) {
            e.low[a] = fmin(e.low[a], b->x[b->surface.triangle[triangle][p]][a]);
            e.high[a] = fmax(e.high[a], b->x[b->surface.triangle[triangle][p]][a]);
        }
    }
    return e;
}

/* Six times the volume of the tetrahedron a b c d. */
static double volume(const double a[3], const double b[3], const double c[3], const double d[3]) {
    double ad[3], cross[3];
    vector_subtract(d, a, ad);
    vector_normal(a, b, c, cross);
    return vector_dot(cross, ad);
}

/* Does the edge go through the triangle? If so, fills *found. An end that is beyond the plane by no
 * more than rounding counts as in the plane; check_touches finds such features. */
static int crosses(const barrier *b, const int edge[2], const int triangle[3],
                   barrier_crossing *found) {
    const double *p = b->x[edge[0]], *q = b->x[edge[1]], *x[3];
    const double rounding = 1e-9; /* relative to the edge's length */
    double along[3], *weight = found->weight;
    for (int k = 0; k < 3; k++) {
        x[k] = b->x[triangle[k]];
        if (triangle[k] == edge[0] || triangle[k] == edge[1])
            return 0;
    }
    const double above = volume(x[0], x[1], x[2], p), below = volume(x[0], x[1], x[2], q);
    for (int k = 0; k < 3; k++)
        weight[k] = volume(p, q, x[(k + 1) % 3], x[(k + 2) % 3]);
    const int side = weight[2] > 0;
    if ((above > 0) == (below > 0) || (weight[0] > 0) != side || (weight[1] > 0) != side)
        return 0;
    vector_normal(x[0], x[1], x[2], found->normal);
    vector_subtract(q, p, along);
    const double area = vector_length(found->normal), sum = weight[0] + weight[1] + weight[2];
    memcpy(found->edge, edge, sizeof found->edge);
    memcpy(found->triangle, triangle, sizeof found->triangle);
    found->nearer = fabs(above) > fabs(below);
    found->depth = fmin(fabs(above), fabs(below)) / area;
    for (int a = 0; a < 3; a++) {
        found->normal[a] *= (found->nearer ? below : above) > 0 ? 1 / area : -1 / area;
        weight[a] /= sum;
    }
    return found->depth > rounding * vector_length(along);
}

static int number_of(const barrier *b, int vertex) {
    return (b->cloth->number ? b->cloth->number[vertex] : vertex) + 1;
}

/* Writes the feature's name: "edge 3 4" or "triangle 5 6 7" of the cloth, or "edge of
 * colliders.2". */
static void name_feature(const barrier *b, int count, const int *vertex, char *text, size_t size) {
    static const char *const names[] = {"vertex", "edge", "triangle"};
    if (b->collider[vertex[0]] >= 0) {
        const int plane = b->scene->colliders[b->collider[vertex[0]]].kind == COLLIDER_PLANE;
        snprintf(text, size, "%s of colliders.%d", plane ? "the plane" : names[count - 1],
                 b->collider[vertex[0]]);
        return;
    }
    int used = snprintf(text, size, "%s", names[count - 1]);
    for (int k = 0; k < count && used < (int)size; k++)
        used += snprintf(text + used, size - (size_t)used, " %d", number_of(b, vertex[k]));
}

/* Appends the option that may help. Returns -1. */
static int refuse(const barrier *b, char *error) {
    const size_t used = strlen(error);
    snprintf(error + used, 200 - used, "%s",
             b->scene->contact.untangle ? " (contact.untangle could not)"
                                        : ", or set 'contact.untangle: on'");
    return -1;
}

static int complain_crossing(void *to, const barrier *b, const barrier_crossing *found) {
    char first[48], second[48];
    name_feature(b, 2, found->edge, first, sizeof first);
    name_feature(b, 3, found->triangle, second, sizeof second);
    const int body = b->collider[found->edge[0]] >= 0 || b->collider[found->triangle[0]] >= 0;
    snprintf(to, 200, "it starts in %s: %s goes %.3g mm through %s; move them apart by more",
             body ? "a body" : "itself", first, 1e3 * found->depth, second);
    return refuse(b, to);
}

/* Visits the crossings of triangle t's edges with triangle u. */
static int visit_edges(const barrier *b, int t, int u, barrier_visitor *visit, void *context) {
    const int *one = b->surface.triangle[t];
    int status = 0;
    for (int p = 0; p < 3 && status == 0; p++) {
        const int edge[2] = {one[p], one[(p + 1) % 3]};
        barrier_crossing found;
        if (crosses(b, edge, b->surface.triangle[u], &found))
            status = visit(context, b, &found);
    }
    return status;
}

int barrier_visit_crossings(const barrier *b, barrier_visitor *visit, void *context) {
    const int count = b->surface.triangle_count, cloth = b->cloth->triangle_count;
    const int itself = b->scene->self_collision.gap > 0;
    int status = 0;
    extent *list = malloc(((size_t)count + 1) * sizeof *list);
    if (!list)
        return -1;
    for (int t = 0; t < count; t++)
        list[t] = extent_of(b, t);
    qsort(list, (size_t)count, sizeof *list, by_low);
    for (int i = 0; i < count && status == 0; i++)
        for (int j = i + 1; j < count && list[j].low[0] <= list[i].high[0] && status == 0; j++) {
            const int t = list[i].triangle, u = list[j].triangle;
            if ((t >= cloth && u >= cloth) || (!itself && t < cloth && u < cloth) ||
                list[i].low[1] > list[j].high[1] || list[j].low[1] > list[i].high[1] ||
                list[i].low[2] > list[j].high[2] || list[j].low[2] > list[i].high[2])
                continue;
            status = visit_edges(b, t, u, visit, context);
            if (status == 0)
                status = visit_edges(b, u, t, visit, context);
        }
    free(list);
    return status;
}

/* Rejects cloth vertices inside solids. Meshes are exempt, because cloth may lie in a hollow
 * one. */
static int check_inside(const barrier *b, char *error) {
    for (int n = 0; n < b->scene->collider_count; n++) {
        const collider *k = &b->scene->colliders[n];
        for (int i = 0; k->kind != COLLIDER_MESH && i < b->cloth->vertex_count; i++) {
            double p[3], normal[3];
            motion_to_body(k, 0, b->x[i], p);
            const double depth = -shape_distance(k, p, normal);
            if (!(depth > 0))
                continue;
            snprintf(error, 200,
                     "it starts in a body: vertex %d lies %.3g mm in colliders.%d; move it out by "
                     "more",
                     number_of(b, i), 1e3 * depth, n);
            return refuse(b, error);
        }
    }
    return 0;
}

static int check_touches(const barrier *b, char *error) {
    for (int k = 0; k < b->list.pairs; k++) {
        const barrier_pair *pair = &b->list.pair[k];
        const int firsts = pair->kind == BARRIER_EDGES ? 2 : 1;
        char first[48], second[48];
        double at[4][3];
        nearest found;
        barrier_gather(pair->vertex, (const double(*)[3])b->x, at);
        barrier_nearest(b, pair, (const double(*)[3])at, &found);
        if (found.distance > least_part * pair->reach)
            continue;
        name_feature(b, firsts, pair->vertex, first, sizeof first);
        name_feature(b, 4 - firsts, pair->vertex + firsts, second, sizeof second);
        snprintf(
            error, 200,
            "it starts touching: %s and %s are %.2g mm apart; move them apart by %.2g mm or more, "
            "or make them one",
            first, second, 1e3 * found.distance, 1e3 * least_part * pair->reach);
        return refuse(b, error);
    }
    return 0;
}

int barrier_check_start(barrier *b, char *error) {
    return barrier_visit_crossings(b, complain_crossing, error) == 0 &&
                   check_inside(b, error) == 0 && check_touches(b, error) == 0
               ? 0
               : -1;
}
