/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "shape_triangle.h"

#include <assert.h>
#include <string.h>

#include "base/vector.h"

/* Limits of the subdivision's depth and number of parts, reached only by triangles many thousand
 * times as large as the gap. */
enum { deepest = 12, most_parts = 2000 };

/** The search for the nearest point. */
typedef struct search {
    const collider *k;
    const double (*p)[3]; /* [3] the triangle */
    int is_convex;
    int visited;  /* number of parts visited */
    double slack; /* m, absolute tolerance of the result */
    double part;  /* relative tolerance, added to `slack`: fraction of the distance's excess over
                   * `kept` */
    double kept;
    double distance;  /* m, the least distance so far; at first the largest distance of interest */
    double weight[3]; /* weights of the nearest point */
    double normal[3];
} search;

static void mix(const double (*p)[3], const double weight[3], double at[3]) {
    for (int a = 0; a < 3; a++)
        at[a] = weight[0] * p[0][a] + weight[1] * p[1][a] + weight[2] * p[2][a];
}

/* Tolerance of the search: the result may be greater than the least distance by this much. */
static double allowed(const search *s) {
    const double left = s->distance - s->kept;
    return s->slack + (left > 0 ? s->part * left : 0);
}

/* A lower bound on the distance of the part's points. */
static double lower_bound(const search *s, const double (*corner)[3], const double middle[3],
                          double distance, const double normal[3]) {
    double least = INFINITY;
    for (int n = 0; n < 3; n++) {
        double at[3], away[3];
        mix(s->p, corner[n], at);
        vector_subtract(at, middle, away);
        const double change = s->is_convex ? vector_dot(normal, away) : -vector_length(away);
        least = fmin(least, distance + change);
    }
    return least;
}

/* Searches the part with these corners, given as weights of the triangle's corners. */
static void search_part(search *s, const double (*corner)[3], int depth) {
    assert(depth <= deepest);
    double weight[3], middle[3], normal[3], half[3][3];
    for (int a = 0; a < 3; a++)
        weight[a] = (corner[0][a] + corner[1][a] + corner[2][a]) / 3;
    mix(s->p, weight, middle);
    const double distance = shape_distance(s->k, middle, normal);
    if (distance < s->distance) {
        s->distance = distance;
        memcpy(s->weight, weight, sizeof weight);
        memcpy(s->normal, normal, sizeof normal);
    }
    if (depth == deepest || ++s->visited > most_parts ||
        !(lower_bound(s, corner, middle, distance, normal) < s->distance - allowed(s)))
        return;
    for (int n = 0; n < 3; n++)
        for (int a = 0; a < 3; a++)
            half[n][a] = (corner[n][a] + corner[(n + 1) % 3][a]) / 2;
    search_part(s, (const double(*)[3])half, depth + 1);
    for (int n = 0; n < 3; n++) {
        double part[3][3];
        for (int a = 0; a < 3; a++) {
            part[0][a] = corner[n][a];
            part[1][a] = half[n][a];
            part[2][a] = half[(n + 2) % 3][a];
        }
        search_part(s, (const double(*)[3])part, depth + 1);
    }
}

/* Finds the nearest point, if it is nearer than `far`. */
static void find_nearest(search *s, const double (*p)[3], double far) {
    static const double whole[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    s->p = p;
    s->distance = far;
    s->visited = 0;
    search_part(s, whole, 0);
}

double shape_inner_radius(const collider *k) {
    switch (k->kind) {
    case COLLIDER_BOX:
        return fmin(k->size[0], fmin(k->size[1], k->size[2]));
    case COLLIDER_SPHERE:
        return k->size[0];
    case COLLIDER_CYLINDER:
        return fmin(k->size[0], k->size[1]);
    case COLLIDER_MESH:
    case COLLIDER_PLANE:
        break;
    }
    return k->gap;
}

static double longest_displacement(const double u[3][3]) {
    return fmax(vector_length(u[0]), fmax(vector_length(u[1]), vector_length(u[2])));
}

int shape_meets_triangle(const collider *k, const double p[3][3], const double u[3][3],
                         double weight[3], approach *found) {
    enum { most_steps = 64 };
    const double radius = shape_inner_radius(k), way = longest_displacement(u);
    const double kept = -TRIANGLE_DEPTH_PART * radius;
    const int is_convex = k->kind != COLLIDER_MESH;
    search s = {.k = k,
                .is_convex = is_convex,
                .slack = (is_convex ? 0.05 : 0.5) * radius,
                .part = 0.3,
                .kept = kept};
    const double touch = kept + s.slack + 0.01 * radius;
    double at[3][3], done = 0, start[3], there[3], moved[3];
    for (int n = 0; n < most_steps; n++) {
        const double far = touch + (1 - done) * way / (1 - s.part);
        for (int c = 0; c < 3; c++)
            vector_add_scaled(p[c], done, u[c], at[c]);
        find_nearest(&s, (const double(*)[3])at, far);
        if (s.distance >= far)
            return 0;
        if (s.distance <= touch)
            break;
        done += (s.distance - allowed(&s) - kept) / way;
        if (done > 1)
            return 0;
    }
    mix(p, s.weight, start);
    mix((const double(*)[3])at, s.weight, there);
    vector_subtract(start, there, start);
    mix(u, s.weight, moved);
    memcpy(weight, s.weight, sizeof s.weight);
    memcpy(found->normal, s.normal, sizeof s.normal);
    found->room = vector_dot(s.normal, start) + s.distance - kept;
    found->beyond = -vector_dot(s.normal, moved) - found->room;
    return found->beyond > 0;
}
