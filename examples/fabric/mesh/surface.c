/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "surface.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "base/vector.h"
#include "mesh_sides.h"

enum { ERROR_SIZE = 256, LEAF_SIZE = 4, DEEPEST = 64 };

/** A box of the tree: a leaf has the triangles order[first] .. order[first + count - 1]; an inner
 *  node has count 0 and the children `first` and `first + 1`. */
typedef struct tree_node {
    double low[3], high[3];
    int first, count;
} tree_node;

struct surface {
    mesh mesh;
    int count; /* number of triangles with area */
    int node_count;
    int *order;           /* [count] triangles in the leaves' order */
    tree_node *node;      /* [2 * count] */
    double (*face)[3];    /* [triangles] unit normals */
    double (*edge)[3][3]; /* [triangles] pseudonormals of the edges 0-1, 1-2, 2-0 */
    double (*vertex)[3];  /* [vertices] pseudonormals */
    arrays own;
};

const mesh *surface_mesh(const surface *s) {
    return &s->mesh;
}

double surface_reach(const surface *s) {
    double reach = 0;
    for (int a = 0; a < 3; a++) {
        reach = fmax(reach, fabs(s->node[0].low[a]));
        reach = fmax(reach, fabs(s->node[0].high[a]));
    }
    return reach;
}

const double *surface_normal(const surface *s, int vertex) {
    assert(vertex >= 0 && vertex < s->mesh.vertex_count);
    return s->vertex[vertex];
}

void surface_free(surface *s) {
    if (!s)
        return;
    arrays_free(&s->own);
    mesh_free(&s->mesh);
    free(s);
}

static const double *corner(const surface *s, int t, int p) {
    return s->mesh.position[s->mesh.triangle[t][p % 3]];
}

/* Computes the unit normals, and lists the triangles that have one. */
static void find_faces(surface *s) {
    for (int t = 0; t < s->mesh.triangle_count; t++) {
        double cross[3];
        vector_normal(corner(s, t, 0), corner(s, t, 1), corner(s, t, 2), cross);
        const double length = vector_length(cross);
        if (!(length > 0) || !isfinite(length))
            continue;
        vector_unit(cross, s->face[t]);
        s->order[s->count++] = t;
    }
}

static void find_vertex_normals(surface *s) {
    for (int n = 0; n < s->count; n++) {
        const int t = s->order[n];
        for (int p = 0; p < 3; p++) {
            double one[3], other[3], cross[3];
            double *sum = s->vertex[s->mesh.triangle[t][p]];
            vector_subtract(corner(s, t, p + 1), corner(s, t, p), one);
            vector_subtract(corner(s, t, p + 2), corner(s, t, p), other);
            vector_cross(one, other, cross);
            const double angle = atan2(vector_length(cross), vector_dot(one, other));
            vector_add_scaled(sum, angle, s->face[t], sum);
        }
    }
}

/* Sums the normals of each edge's triangles. A triangle without area has the normal 0. */
static int find_edge_normals(surface *s) {
    const int count = 3 * s->mesh.triangle_count;
    mesh_side *sides = mesh_sides_new(&s->mesh);
    if (!sides)
        return -1;
    for (int i = 0, together; i < count; i += together) {
        double sum[3] = {0, 0, 0};
        together = mesh_sides_together(&sides[i], count - i);
        for (int k = i; k < i + together; k++)
            vector_add_scaled(sum, 1, s->face[sides[k].triangle], sum);
        for (int k = i; k < i + together; k++)
            memcpy(s->edge[sides[k].triangle][sides[k].number], sum, sizeof sum);
    }
    free(sides);
    return 0;
}

static double middle(const surface *s, int t, int axis) {
    return corner(s, t, 0)[axis] + corner(s, t, 1)[axis] + corner(s, t, 2)[axis];
}

static void bound(const surface *s, tree_node *node, int first, int count) {
    for (int a = 0; a < 3; a++) {
        node->low[a] = INFINITY;
        node->high[a] = -INFINITY;
        for (int n = first; n < first + count; n++)
            for (int p = 0; p < 3; p++) {
                const double x = corner(s, s->order[n], p)[a];
                node->low[a] = x < node->low[a] ? x : node->low[a];
                node->high[a] = x > node->high[a] ? x : node->high[a];
            }
    }
}

/* Splits the triangles at the middle of the box's longest edge: moves those whose centre lies below
 * it to the front. Returns their number, or 0 if all are on one side. */
static int split(surface *s, const tree_node *node, int first, int count) {
    int axis = 0, at = first;
    for (int a = 1; a < 3; a++)
        if (node->high[a] - node->low[a] > node->high[axis] - node->low[axis])
            axis = a;
    const double cut = 1.5 * (node->low[axis] + node->high[axis]);
    for (int n = first; n < first + count; n++)
        if (middle(s, s->order[n], axis) < cut) {
            const int t = s->order[n];
            s->order[n] = s->order[at];
            s->order[at++] = t;
        }
    return at == first + count ? 0 : at - first;
}

static void build(surface *s, int index, int first, int count, int depth) {
    assert(first >= 0 && count > 0 && first + count <= s->count);
    assert(s->node_count <= 2 * s->count);
    tree_node *node = &s->node[index];
    bound(s, node, first, count);
    node->first = first;
    node->count = count;
    if (count <= LEAF_SIZE || depth == DEEPEST - 2)
        return;
    int left = split(s, node, first, count);
    if (left == 0)
        left = count / 2;
    node->count = 0;
    node->first = s->node_count;
    s->node_count += 2;
    const int child = node->first;
    build(s, child, first, left, depth + 1);
    build(s, child + 1, first + left, count - left, depth + 1);
}

surface *surface_new(mesh *m, char *error) {
    const size_t triangles = (size_t)m->triangle_count + 1;
    surface *s = calloc(1, sizeof *s);
    snprintf(error, ERROR_SIZE, "out of memory");
    if (!s)
        return NULL;
    s->mesh = *m;
    s->order = arrays_add(&s->own, triangles, sizeof *s->order);
    s->node = arrays_add(&s->own, 2 * triangles, sizeof *s->node);
    s->face = arrays_add(&s->own, triangles, sizeof *s->face);
    s->edge = arrays_add(&s->own, triangles, sizeof *s->edge);
    s->vertex = arrays_add(&s->own, (size_t)m->vertex_count + 1, sizeof *s->vertex);
    if (!s->own.failed) {
        find_faces(s);
        find_vertex_normals(s);
        if (s->count == 0)
            snprintf(error, ERROR_SIZE, "no triangle has an area");
        else if (find_edge_normals(s) == 0) {
            s->node_count = 1;
            build(s, 0, 0, s->count, 0);
            *m = (mesh){0};
            return s;
        }
    }
    s->mesh = (mesh){0};
    surface_free(s);
    return NULL;
}

/** The nearest point found so far. */
typedef struct nearest {
    double square; /* squared distance */
    double point[3];
    const double *normal; /* pseudonormal at that point */
} nearest;

/* Updates *best if the triangle has a nearer point. That point is on the vertex, the edge or the
 * face whose Voronoi region contains p (Ericson 2005, Real-Time Collision Detection, 5.1.5). */
static void take_triangle(const surface *s, int t, const double p[3], nearest *best) {
    const double *a = corner(s, t, 0), *b = corner(s, t, 1), *c = corner(s, t, 2);
    const int *v = s->mesh.triangle[t];
    const double *normal = s->face[t];
    double ab[3], ac[3], from[3], u = 0, w = 0; /* the point: a + u ab + w ac */
    vector_subtract(b, a, ab);
    vector_subtract(c, a, ac);
    vector_subtract(p, a, from);
    const double d1 = vector_dot(ab, from), d2 = vector_dot(ac, from);
    vector_subtract(p, b, from);
    const double d3 = vector_dot(ab, from), d4 = vector_dot(ac, from);
    vector_subtract(p, c, from);
    const double d5 = vector_dot(ab, from), d6 = vector_dot(ac, from);
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (d1 <= 0 && d2 <= 0) {
        normal = s->vertex[v[0]];
    } else if (d3 >= 0 && d4 <= d3) {
        normal = s->vertex[v[1]];
        u = 1;
    } else if (d6 >= 0 && d5 <= d6) {
        normal = s->vertex[v[2]];
        w = 1;
    } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        normal = s->edge[t][0];
        u = d1 / (d1 - d3);
    } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        normal = s->edge[t][2];
        w = d2 / (d2 - d6);
    } else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        normal = s->edge[t][1];
        w = (d4 - d3) / (d4 - d3 + d5 - d6);
        u = 1 - w;
    } else {
        u = vb / (va + vb + vc);
        w = vc / (va + vb + vc);
    }
    double point[3], away[3];
    vector_add_scaled(a, u, ab, point);
    vector_add_scaled(point, w, ac, point);
    vector_subtract(p, point, away);
    const double square = vector_dot(away, away);
    if (square < best->square) {
        best->square = square;
        best->normal = normal;
        memcpy(best->point, point, sizeof point);
    }
}

static double box_square(const tree_node *node, const double p[3]) {
    double sum = 0;
    for (int a = 0; a < 3; a++) {
        const double below = node->low[a] - p[a], above = p[a] - node->high[a];
        const double out = below > above ? below : above;
        sum += out > 0 ? out * out : 0;
    }
    return sum;
}

double surface_distance(const surface *s, const double p[3], double normal[3]) {
    nearest best = {INFINITY, {0, 0, 0}, s->face[s->order[0]]};
    int stack[DEEPEST + 2], size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const tree_node *node = &s->node[stack[--size]];
        if (box_square(node, p) >= best.square)
            continue;
        for (int n = 0; n < node->count; n++)
            take_triangle(s, s->order[node->first + n], p, &best);
        if (node->count > 0)
            continue;
        assert(size <= DEEPEST);
        const int left_nearer =
            box_square(&s->node[node->first], p) <= box_square(&s->node[node->first + 1], p);
        stack[size++] = node->first + left_nearer; /* the nearer one on top */
        stack[size++] = node->first + !left_nearer;
    }
    double away[3];
    vector_subtract(p, best.point, away);
    const double distance = sqrt(best.square), length = vector_length(best.normal);
    const double sign = vector_dot(away, best.normal) < 0 ? -1 : 1;
    /* On the surface itself the direction is that of the pseudonormal. */
    const int far = distance > 1e-12 * (1 + vector_length(p));
    for (int a = 0; a < 3; a++)
        normal[a] = far ? sign * away[a] / distance : best.normal[a] / (length > 0 ? length : 1);
    return sign * distance;
}
