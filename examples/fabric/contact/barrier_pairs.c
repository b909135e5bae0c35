/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Lists the pairs: those of the grid, and each vertex with each plane. */
#include "barrier.h"

#include <string.h>

#include "base/vector.h"

void barrier_nearest(const barrier *b, const barrier_pair *pair, const double x[4][3],
                     nearest *found) {
    if (pair->kind == BARRIER_VERTEX) {
        nearest_vertex_triangle(x, found);
    } else if (pair->kind == BARRIER_EDGES) {
        nearest_edges(x, found);
    } else {
        double from[3];
        const double *normal = b->scene->colliders[pair->collider].axis;
        vector_subtract(x[0], x[1], from);
        *found = (nearest){.weight = {1, -1, 0, 0}, .distance = vector_dot(from, normal)};
        memcpy(found->normal, normal, sizeof found->normal);
    }
}

/* Returns an upper bound on the decrease of the features' distance during the displacement, m. The
 * first feature has `firsts` vertices. */
static double greatest_approach(const int vertex[4], const double (*displacement)[3], int firsts) {
    double of[2] = {0, 0};
    for (int k = 0; displacement && k < 4; k++) {
        double *most = &of[k >= firsts];
        *most = fmax(*most, vector_length(displacement[vertex[k]]));
    }
    return of[0] + of[1];
}

/* Returns the reach of a pair of the cloth: the gap. For features of one component the reach is at
 * most half their rest distance, but at least a hundredth of the gap. Otherwise triangles smaller
 * than the gap would repel their neighbours. */
static double reach_of_cloth(const barrier *b, const barrier_pair *pair) {
    const int firsts = pair->kind == BARRIER_EDGES ? 2 : 1;
    const double gap = b->scene->self_collision.gap;
    double at[4][3];
    nearest found;
    if (b->component[pair->vertex[0]] != b->component[pair->vertex[firsts]])
        return gap;
    barrier_gather(pair->vertex, (const double(*)[3])b->rest, at);
    barrier_nearest(b, pair, (const double(*)[3])at, &found);
    return fmin(gap, fmax(found.distance / 2, gap / 100));
}

/* Converts a pair of the grid; its reach is 0 if all its vertices belong to bodies. */
static barrier_pair pair_of(const barrier *b, const self_pair *from) {
    barrier_pair pair = {.kind = from->is_edges ? BARRIER_EDGES : BARRIER_VERTEX, .collider = -1};
    int of_bodies = 1;
    memcpy(pair.vertex, from->vertex, sizeof pair.vertex);
    for (int k = 0; k < 4; k++) {
        const int owner = b->collider[pair.vertex[k]];
        of_bodies &= owner >= 0;
        if (owner >= 0)
            pair.collider = owner;
    }
    if (of_bodies)
        return pair;
    if (pair.collider >= 0)
        pair.reach = b->scene->colliders[pair.collider].gap;
    else
        pair.reach = b->scene->self_collision.gap;
    return pair;
}

/* Are the bounding boxes of the features' motions farther from each other than the reach? */
static int boxes_keep_distance(const barrier_pair *pair, const double (*x)[3],
                               const double (*displacement)[3]) {
    return self_pair_keeps_distance(pair->vertex, pair->kind == BARRIER_EDGES, pair->reach,
                                    displacement ? 1 : 0, x, displacement ? displacement : x);
}

/* Sets the pair's reach to 0 if the features cannot come within it. */
static void leave_out_far(const barrier *b, const double (*x)[3], const double (*displacement)[3],
                          barrier_pair *pair) {
    double at[4][3];
    nearest found;
    if (pair->kind != BARRIER_PLANE && boxes_keep_distance(pair, x, displacement)) {
        pair->reach = 0;
        return;
    }
    barrier_gather(pair->vertex, x, at);
    barrier_nearest(b, pair, (const double(*)[3])at, &found);
    const double most =
        greatest_approach(pair->vertex, displacement, pair->kind == BARRIER_EDGES ? 2 : 1);
    if (pair->reach > 0 && pair->collider < 0)
        pair->reach = found.distance - most < pair->reach ? reach_of_cloth(b, pair) : 0;
    if (found.distance - most >= pair->reach)
        pair->reach = 0;
}

static int count_planes(const barrier *b) {
    int count = 0;
    for (int i = b->cloth->vertex_count; i < b->surface.vertex_count; i++)
        count += b->scene->colliders[b->collider[i]].kind == COLLIDER_PLANE;
    return count;
}

/* Adds a pair of each cloth vertex with the plane whose point is vertex `point`. */
static void add_plane(const barrier *b, int point, const double (*x)[3],
                      const double (*displacement)[3], barrier_pair *pair) {
    const int number = b->collider[point];
#pragma omp parallel for schedule(static)
    for (int i = 0; i < b->cloth->vertex_count; i++) {
        pair[i] = (barrier_pair){.vertex = {i, point, point, point},
                                 .kind = BARRIER_PLANE,
                                 .collider = number,
                                 .reach = b->scene->colliders[number].gap};
        leave_out_far(b, x, displacement, &pair[i]);
    }
}

/* Returns the largest distance, m, of a vertex from its position at the last search, at the
 * beginning or end of the displacement. */
static double distance_from_search(const barrier *b, const double (*x)[3],
                                   const double (*displacement)[3]) {
    double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most)
    for (int i = 0; i < b->surface.vertex_count; i++) {
        double from[3];
        vector_subtract(x[i], b->searched[i], from);
        most = fmax(most, vector_length(from));
        if (displacement)
            vector_add_scaled(from, 1, displacement[i], from);
        most = fmax(most, vector_length(from));
    }
    return most;
}

/* Removes the candidates that cannot come within their reach while no vertex moves by more than the
 * margin. */
static void drop_far_candidates(barrier *b, const double (*x)[3]) {
    self_pair *candidate = b->search.pair;
    const int found = b->search.pair_count;
#pragma omp parallel for schedule(static)
    for (int k = 0; k < found; k++) {
        barrier_pair pair = pair_of(b, &candidate[k]);
        pair.reach = pair.reach > 0 ? pair.reach + 2 * b->margin : 0;
        candidate[k].is_far = !(pair.reach > 0) || boxes_keep_distance(&pair, x, NULL);
    }
    b->search.pair_count = 0;
    for (int k = 0; k < found; k++)
        if (!candidate[k].is_far)
            candidate[b->search.pair_count++] = candidate[k];
}

/* Finds candidates for pairs. Boxes are enlarged by the margin, so that a search stays valid until
 * a vertex has moved by more than the margin. */
static int search(barrier *b, const double (*x)[3], const double (*displacement)[3]) {
    const double gap = b->search.gap;
    if (b->has_candidates && distance_from_search(b, x, displacement) <= b->margin)
        return 0;
    memcpy(b->searched, x, (size_t)b->surface.vertex_count * sizeof *b->searched);
    b->has_candidates = distance_from_search(b, x, displacement) <= b->margin;
    if (!b->has_candidates)
        return self_grid_find(&b->search, 1, x, displacement, INFINITY);
    b->search.gap += b->margin;
    const int status = self_grid_find(&b->search, 0, x, x, INFINITY);
    b->search.gap = gap;
    if (status == 0)
        drop_far_candidates(b, x);
    return status;
}

int barrier_find_pairs(barrier *b, const double (*x)[3], const double (*displacement)[3]) {
    barrier_list *list = &b->list;
    const int vertices = b->cloth->vertex_count;
    list->pairs = 0;
    if (search(b, x, displacement) != 0)
        return -1;
    const int found = b->search.pair_count;
    const long all = found + (long)vertices * count_planes(b);
    if (array_grow(&list->pair, &list->pair_room, all, sizeof *list->pair) != 0)
        return -1;
#pragma omp parallel for schedule(static)
    for (int k = 0; k < found; k++) {
        list->pair[k] = pair_of(b, &b->search.pair[k]);
        if (list->pair[k].reach > 0)
            leave_out_far(b, x, displacement, &list->pair[k]);
    }
    barrier_pair *next = list->pair + found;
    for (int i = vertices; i < b->surface.vertex_count; i++)
        if (b->scene->colliders[b->collider[i]].kind == COLLIDER_PLANE) {
            add_plane(b, i, x, displacement, next);
            next += vertices;
        }
    for (long k = 0; k < all; k++)
        if (list->pair[k].reach > 0)
            list->pair[list->pairs++] = list->pair[k];
    return 0;
}

int barrier_find_contacts(barrier *b, const double (*x)[3]) {
    barrier_list *list = &b->list;
    list->contacts = 0;
    if (array_grow(&list->contact, &list->contact_room, list->pairs, sizeof *list->contact) != 0)
        return -1;
#pragma omp parallel for schedule(static)
    for (int k = 0; k < list->pairs; k++) {
        double at[4][3];
        list->contact[k].pair = list->pair[k];
        barrier_gather(list->pair[k].vertex, x, at);
        barrier_nearest(b, &list->pair[k], (const double(*)[3])at, &list->contact[k].at);
    }
    for (int k = 0; k < list->pairs; k++)
        if (list->contact[k].at.distance < list->contact[k].pair.reach)
            list->contact[list->contacts++] = list->contact[k];
    return 0;
}
