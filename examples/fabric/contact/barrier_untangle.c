/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Separates overlapping parts before the first step, by geometry only: vertices are projected, one
 * constraint after the other (position-based dynamics, Müller et al. 2007), until no edge crosses a
 * triangle, no vertex is inside a solid and no pair is nearer than a quarter of its reach.
 *
 * A crossing does not determine which of two layers belongs on which side. So one side is chosen
 * for each pair of connected parts: the one on which most of their vertices are. Of parts in the
 * same place, the one that comes first in the mesh becomes the lower. If a part overlaps itself,
 * each connected patch of the overlap is treated likewise. The boundary of an overlap moves inwards
 * by about one edge per round, hence the number of rounds.
 */
#include <string.h>

#include "barrier.h"
#include "base/vector.h"
#include "motion.h"
#include "shape.h"

enum { most_rounds = 400 };
/* Pairs nearer than half of this fraction of their reach are moved apart to this fraction. */
static const double wanted_part = 0.5;

typedef struct untangling {
    barrier *b;
    int cloths, parts; /* number of connected parts of the cloth; that number plus the bodies */
    int *part;         /* [surface's vertices] index of the vertex's part */
    double *side;      /* [cloths * parts] > 0: the first part is on the side to which the second's
                        * normals point */
    int *patch; /* [cloth's vertices] union-find parent; a set is a patch of vertices that overlap
                 * their own part */
    double *above; /* [cloth's vertices] m, height above the part's own nearest triangle, along its
                    * normal; 0: none; at a patch's root: the patch's sum */
    double (*normal)[3]; /* [surface's vertices] vertex normals */
    double longest;      /* m, maximum displacement of a projection */
    int crossings;       /* number of crossings found in this round */
    int changed;         /* a vertex moved in this round */
    arrays own;
} untangling;

/* Numbers parts in the order of their first vertices; bodies follow. */
static int untangling_init(untangling *u, barrier *b) {
    const int vertices = b->cloth->vertex_count;
    *u = (untangling){.b = b, .longest = mesh_mean_edge(b->cloth)};
    u->part = arrays_add(&u->own, (size_t)b->surface.vertex_count + 1, sizeof *u->part);
    u->normal = arrays_add(&u->own, (size_t)b->surface.vertex_count + 1, sizeof *u->normal);
    u->patch = arrays_add(&u->own, (size_t)vertices + 1, sizeof *u->patch);
    u->above = arrays_add(&u->own, (size_t)vertices + 1, sizeof *u->above);
    if (u->own.failed)
        return -1;
    for (int i = 0; i < vertices; i++)
        if (b->component[i] == i)
            u->part[i] = u->cloths++;
    u->parts = u->cloths + b->scene->collider_count;
    for (int i = 0; i < b->surface.vertex_count; i++)
        u->part[i] = i < vertices ? u->part[b->component[i]] : u->cloths + b->collider[i];
    u->side = arrays_add(&u->own, (size_t)u->cloths * (size_t)u->parts + 1, sizeof *u->side);
    return u->own.failed ? -1 : 0;
}

static void triangle_normal(const barrier *b, const int vertex[3], double normal[3]) {
    vector_normal(b->x[vertex[0]], b->x[vertex[1]], b->x[vertex[2]], normal);
}

/* Vertex normals, weighted by the areas of the triangles. */
static void find_normals(untangling *u) {
    const mesh *m = &u->b->surface;
    memset(u->normal, 0, (size_t)m->vertex_count * sizeof *u->normal);
    for (int t = 0; t < m->triangle_count; t++) {
        double normal[3];
        triangle_normal(u->b, m->triangle[t], normal);
        for (int p = 0; p < 3; p++)
            vector_add_scaled(u->normal[m->triangle[t][p]], 1, normal,
                              u->normal[m->triangle[t][p]]);
    }
}

static void feature_normal(const untangling *u, int count, const int *vertex, double normal[3]) {
    if (count == 3) {
        triangle_normal(u->b, vertex, normal);
    } else {
        memcpy(normal, u->normal[vertex[0]], sizeof u->normal[0]);
        if (count == 2)
            vector_add_scaled(normal, 1, u->normal[vertex[1]], normal);
    }
    vector_unit(normal, normal);
}

/* Sums in u->side, for each pair of parts, the heights of one part's vertices above (> 0) or below
 * near triangles of the other. Returns 0, or -1 if out of memory or if a number is not finite. */
static int find_sides(untangling *u) {
    barrier *b = u->b;
    const double gap = b->search.gap;
    b->search.gap = u->longest;
    const int status = self_grid_find(&b->search, 0, read_only(b->x), read_only(b->x), INFINITY);
    b->search.gap = gap;
    barrier_begin_search(b);
    for (int k = 0; status == 0 && k < b->search.pair_count; k++) {
        const int *v = b->search.pair[k].vertex, one = u->part[v[0]], other = u->part[v[1]];
        double at[4][3], up[3], vertical[3];
        nearest found;
        if (b->search.pair[k].is_edges)
            continue;
        barrier_gather(v, read_only(b->x), at);
        nearest_vertex_triangle(read_only(at), &found);
        nearest_combine(read_only(at), found.weight, vertical);
        feature_normal(u, one <= other ? 3 : 1, one <= other ? v + 1 : v, up);
        const double height = vector_dot(vertical, up);
        if (fabs(height) < 0.7 * found.distance)
            continue; /* neither above nor below the triangle */
        if (one == other && (u->above[v[0]] == 0 || fabs(height) < fabs(u->above[v[0]])))
            u->above[v[0]] = height;
        else if (one < other)
            u->side[one * u->parts + other] += height;
        else if (one > other)
            u->side[other * u->parts + one] -= height;
    }
    for (int n = 0; n < b->scene->collider_count; n++)
        for (int k = 0; k < u->cloths && b->scene->colliders[n].kind != COLLIDER_MESH; k++)
            u->side[k * u->parts + u->cloths + n] = 1; /* outside */
    return status;
}

/* Connects neighbours that overlap their own part, and adds up their heights. */
static void find_patches(untangling *u) {
    const mesh *m = u->b->cloth;
    for (int i = 0; i < m->vertex_count; i++)
        u->patch[i] = i;
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            const int i = m->triangle[t][p], j = m->triangle[t][(p + 1) % 3];
            if (u->above[i] != 0 && u->above[j] != 0)
                u->patch[forest_root(u->patch, j)] = forest_root(u->patch, i);
        }
    for (int i = 0; i < m->vertex_count; i++) {
        u->patch[i] = forest_root(u->patch, i);
        if (u->patch[i] != i)
            u->above[u->patch[i]] += u->above[i];
    }
}

/* Finds the direction in which the first feature must move relative to the second one of the same
 * part. Returns 0 if it is unknown. */
static int find_own_direction(const untangling *u, int firsts, const int *first, int seconds,
                              const int *second, double direction[3]) {
    double one = 0, other = 0;
    for (int k = 0; k < firsts; k++)
        one += u->above[u->patch[first[k]]];
    for (int k = 0; k < seconds; k++)
        other += u->above[u->patch[second[k]]];
    const double sign = one != 0 ? one : -other;
    if (one != 0)
        feature_normal(u, seconds, second, direction);
    else
        feature_normal(u, firsts, first, direction);
    vector_scale(direction, sign > 0 ? 1 : -1, direction);
    return sign != 0;
}

/* Finds the direction in which the first feature must move relative to the second. Returns 0 if it
 * is unknown. */
static int find_direction(const untangling *u, int firsts, const int *first, int seconds,
                          const int *second, double direction[3]) {
    const int one = u->part[first[0]], other = u->part[second[0]];
    if (one == other)
        return find_own_direction(u, firsts, first, seconds, second, direction);
    if (one < other)
        feature_normal(u, seconds, second, direction);
    else
        feature_normal(u, firsts, first, direction);
    const double side = u->side[one < other ? one * u->parts + other : other * u->parts + one];
    const double sign = (side > 0) == (one < other) ? 1 : -1;
    vector_scale(direction, sign, direction);
    return 1;
}

/* Moves vertices so that sum weight[k] x[k] grows along the direction by `lacking` m, or by
 * u->longest if that is less. Driven vertices do not move. */
static void project(untangling *u, int count, const int *vertex, const double *weight,
                    const double direction[3], double lacking) {
    double squares = 0;
    for (int k = 0; k < count; k++)
        squares += u->b->driven[vertex[k]] ? 0 : weight[k] * weight[k];
    if (!(squares > 0) || !(lacking > 0))
        return;
    const double factor = fmin(lacking, u->longest) / squares;
    for (int k = 0; k < count; k++)
        if (!u->b->driven[vertex[k]])
            vector_add_scaled(u->b->x[vertex[k]], factor * weight[k], direction,
                              u->b->x[vertex[k]]);
    u->changed = 1;
}

static double reach_between(const barrier *b, int i, int j) {
    const int owner = b->collider[i] >= 0 ? b->collider[i] : b->collider[j];
    return owner >= 0 ? b->scene->colliders[owner].gap : b->scene->self_collision.gap;
}

/* A barrier_visitor: moves the edge's end that is on the wrong side to the other side. */
static int separate_crossing(void *context, const barrier *b, const barrier_crossing *found) {
    untangling *u = context;
    double direction[3], across[3];
    int end = found->nearer;
    u->crossings++;
    if (find_direction(u, 2, found->edge, 3, found->triangle, direction)) {
        vector_subtract(b->x[found->edge[0]], b->x[found->edge[1]], across);
        end = vector_dot(across, direction) > 0;
    } else {
        vector_scale(found->normal, -1, direction);
    }
    const int vertex[4] = {found->edge[end], found->triangle[0], found->triangle[1],
                           found->triangle[2]};
    const double weight[4] = {1, -found->weight[0], -found->weight[1], -found->weight[2]};
    double at[4][3], apart[3];
    barrier_gather(vertex, read_only(b->x), at);
    nearest_combine(read_only(at), weight, apart);
    project(u, 4, vertex, weight, direction,
            wanted_part * reach_between(b, vertex[0], vertex[1]) - vector_dot(apart, direction));
    return 0;
}

static void leave_solids(untangling *u) {
    barrier *b = u->b;
    for (int n = 0; n < b->scene->collider_count; n++) {
        const collider *k = &b->scene->colliders[n];
        body_pose pose;
        motion_pose(k, 0, &pose);
        for (int i = 0; k->kind != COLLIDER_MESH && i < b->cloth->vertex_count; i++) {
            double p[3], normal[3], out[3];
            motion_to_body(k, 0, b->x[i], p);
            const double distance = shape_distance(k, p, normal);
            if (distance >= wanted_part * k->gap / 2)
                continue;
            for (int a = 0; a < 3; a++)
                out[a] = vector_dot(pose.rotation[a], normal);
            project(u, 1, &i, (const double[]){1}, out, wanted_part * k->gap - distance);
        }
    }
}

static void separate_near(untangling *u) {
    const barrier *b = u->b;
    for (int k = 0; k < b->list.pairs; k++) {
        const barrier_pair *pair = &b->list.pair[k];
        const int firsts = pair->kind == BARRIER_EDGES ? 2 : 1;
        const double wanted = wanted_part * pair->reach;
        double at[4][3], apart[3], direction[3];
        nearest found;
        barrier_gather(pair->vertex, read_only(b->x), at);
        barrier_nearest(b, pair, read_only(at), &found);
        if (pair->kind == BARRIER_PLANE || found.distance >= wanted / 2)
            continue; /* leave_solids handles planes */
        const int own = u->part[pair->vertex[0]] == u->part[pair->vertex[firsts]];
        if (own && u->crossings > 0)
            continue; /* the first feature may be on the wrong side */
        if ((own && found.distance > 0) ||
            !find_direction(u, firsts, pair->vertex, 4 - firsts, pair->vertex + firsts, direction))
            memcpy(direction, found.normal, sizeof direction);
        nearest_combine(read_only(at), found.weight, apart);
        project(u, 4, pair->vertex, found.weight, direction, wanted - vector_dot(apart, direction));
    }
}

int barrier_untangle(barrier *b) {
    untangling u;
    int status = untangling_init(&u, b);
    if (status == 0) {
        find_normals(&u);
        status = find_sides(&u);
        find_patches(&u);
    }
    u.changed = 1;
    for (int round = 0; status == 0 && u.changed && round < most_rounds; round++) {
        u.changed = u.crossings = 0;
        find_normals(&u);
        leave_solids(&u);
        status = barrier_visit_crossings(b, separate_crossing, &u);
        if (status == 0)
            status = barrier_find_pairs(b, read_only(b->x), NULL);
        if (status == 0)
            separate_near(&u);
    }
    arrays_free(&u.own);
    return status;
}
