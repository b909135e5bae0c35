/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "self_collision.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "base/vector.h"
#include "mesh/mesh_sides.h"

/* Pairs nearer than the gap separate by this fraction of the missing distance in each step of the
 * scene. */
static const double separation_rate = 0.25;
/* Pairs that would pass keep this fraction of their distance, or of the gap. */
static const double kept_part = 0.1;
/* Threads take this number of pairs at once. Pairs that may meet take a hundred times as long as
 * the others, and they come together. */
enum { PAIRS_AT_ONCE = 64 };

/* Assigns each vertex and each edge to the first of its triangles. */
static int share_out(self_collision *s) {
    const mesh *m = s->mesh;
    const int count = 3 * m->triangle_count;
    unsigned char *seen = calloc((size_t)m->vertex_count + 1, 1);
    mesh_side *sides = mesh_sides_new(m);
    const int status = seen && sides ? 0 : -1;
    for (int t = 0; status == 0 && t < m->triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            if (!seen[m->triangle[t][p]])
                s->grid.owned[t] |= 1 << p;
            seen[m->triangle[t][p]] = 1;
        }
    for (int k = 0; status == 0 && k < count; k += mesh_sides_together(&sides[k], count - k))
        s->grid.owned[sides[k].triangle] |= 1 << (3 + sides[k].number);
    free(seen);
    free(sides);
    return status;
}

int self_collision_init(self_collision *s, const mesh *m, double gap, double friction,
                        double step) {
    *s = (self_collision){.mesh = m,
                          .gap = gap,
                          .friction = friction,
                          .step = step,
                          .bodies_from = m->triangle_count};
    s->grid.box = arrays_add(&s->own, (size_t)m->triangle_count + 1, sizeof *s->grid.box);
    s->grid.owned = arrays_add(&s->own, (size_t)m->triangle_count + 1, sizeof *s->grid.owned);
    s->history.vertex = arrays_add(&s->own, (size_t)m->vertex_count + 1, sizeof *s->history.vertex);
    s->history.v = arrays_add(&s->own, (size_t)m->vertex_count + 1, sizeof *s->history.v);
    if (!s->own.failed && share_out(s) == 0)
        return 0;
    self_collision_free(s);
    return -1;
}

void self_collision_free(self_collision *s) {
    arrays_free(&s->own);
    free(s->grid.start);
    free(s->grid.first);
    free(s->grid.entry);
    free(s->grid.loose);
    for (int part = 0; part < SELF_PARTS; part++)
        free(s->grid.part[part].pair);
    free(s->pair);
    free(s->history.pair);
    free(s->history.demand);
    *s = (self_collision){0};
}

/* Are the features nearer than the gap in the rest shape, as those of thin triangles are? Such a
 * pair is only kept from passing. */
static int rest_near(const self_collision *s, const self_pair *pair) {
    const mesh *m = s->mesh;
    double at[4][3] = {{0}};
    self_contact found;
    for (int k = 0; k < 4; k++)
        if (m->rest_in_space)
            memcpy(at[k], m->position[pair->vertex[k]], sizeof at[k]);
        else
            memcpy(at[k], m->material[pair->vertex[k]], sizeof m->material[0]);
    return self_pair_is_near(pair->is_edges, (const double(*)[3])at, s->gap, &found);
}

/* Computes the change of the normal velocity that the pair requires, m/s, or 0 if it requires
 * none. */
static double required_change(const self_collision *s, const self_pair *pair, double h,
                              const double (*x)[3], const double (*v)[3], self_contact *found) {
    double from[4][3], to[4][3], speed = 0, least = 0;
    if (self_pair_keeps_distance(pair->vertex, pair->is_edges, s->gap, h, x, v))
        return 0;
    self_pair_gather(pair, h, x, v, from, to);
    const double(*start)[3] = (const double(*)[3])from, (*end)[3] = (const double(*)[3])to;
    if (!pair->near_at_rest && self_pair_is_near(pair->is_edges, start, s->gap, found) &&
        !rest_near(s, pair))
        least = separation_rate * (s->gap - found->distance) / s->step;
    else if (self_pair_passes(pair->is_edges, start, end, found))
        least = -(1 - kept_part) * found->distance / h;
    else if (!pair->near_at_rest &&
             self_pair_ends_near(pair->is_edges, start, end, kept_part * s->gap, found) &&
             !rest_near(s, pair))
        least = (kept_part * s->gap - found->distance) / h;
    else
        return 0;
    for (int k = 0; k < 4; k++)
        speed += found->weight[k] * vector_dot(found->normal, v[pair->vertex[k]]);
    return speed < least ? least - speed : 0;
}

/* Have the vertices of pair n kept their velocities since the time `since`? */
static int is_unchanged(const self_collision *s, int n, int since) {
    const int *vertex = s->pair[n].vertex, *changed = s->history.vertex;
    return changed[vertex[0]] <= since && changed[vertex[1]] <= since &&
           changed[vertex[2]] <= since && changed[vertex[3]] <= since;
}

static int is_quiet(const self_collision *s, int n) {
    return is_unchanged(s, n, s->history.pair[n]);
}

static void update_demand(self_collision *s, int n, double h, const double (*x)[3],
                          const double (*v)[3]) {
    assert(n >= 0 && n < s->pair_count);
    self_demand *to = &s->history.demand[n];
    to->change = required_change(s, &s->pair[n], h, x, v, &to->contact);
    assert(!(to->change < 0));
}

/* Runs in parallel at the beginning of a round: marks velocities that changed since the last round,
 * and computes the impulses that pairs need. Most pairs need none, and the sequential part skips
 * them. Returns the first pair that needs one: no velocity changes before it. */
static int evaluate_pairs(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    self_history *history = &s->history;
    int first = s->pair_count;
    history->round_start = ++history->now;
#pragma omp parallel reduction(min : first)
    {
#pragma omp for schedule(static)
        for (int i = 0; i < s->mesh->vertex_count; i++)
            if (memcmp(v[i], history->v[i], sizeof v[i]) != 0)
                history->vertex[i] = history->now;
#pragma omp for schedule(dynamic, PAIRS_AT_ONCE)
        for (int n = 0; n < s->pair_count; n++) {
            if (is_quiet(s, n))
                continue;
            update_demand(s, n, h, x, v);
            if (!(history->demand[n].change > 0))
                history->pair[n] = history->now;
            else
                first = n < first ? n : first;
        }
    }
    return first;
}

/* Gives pair n the impulse that it needs. Returns the change of the normal velocity, m/s. */
static double push_pair(self_collision *s, const movable *of, int n, double h, const double (*x)[3],
                        double (*v)[3], double *work) {
    const self_demand *demand = &s->history.demand[n];
    feature both = {.count = 4};
    if (!is_unchanged(s, n, s->history.round_start))
        update_demand(s, n, h, x, (const double(*)[3])v);
    if (!(demand->change > 0)) {
        s->history.pair[n] = s->history.now;
        return 0;
    }
    for (int k = 0; k < 4; k++) {
        both.vertex[k] = s->pair[n].vertex[k];
        both.weight[k] = demand->contact.weight[k];
    }
    if (!impulse_give(of, &both, demand->contact.normal, demand->change, s->friction, NULL, v,
                      work))
        return 0;
    s->history.now++;
    for (int k = 0; k < 4; k++)
        s->history.vertex[both.vertex[k]] = s->history.now;
    return demand->change;
}

double self_collision_push(self_collision *s, const movable *of, double h, const double (*x)[3],
                           double (*v)[3], double *work) {
    double largest = 0;
    const int first = evaluate_pairs(s, h, x, (const double(*)[3])v);
    for (int n = first; n < s->pair_count; n++)
        if (!is_quiet(s, n))
            largest = fmax(largest, push_pair(s, of, n, h, x, v, work));
    memcpy(s->history.v, v, sizeof *v * (size_t)s->mesh->vertex_count);
    return largest;
}

int self_collision_passes(const self_collision *s, const self_pair *pair, double h,
                          const double (*x)[3], const double (*v)[3]) {
    double start[4][3], end[4][3];
    self_contact found;
    if (self_pair_keeps_distance(pair->vertex, pair->is_edges, s->gap, h, x, v))
        return 0;
    self_pair_gather(pair, h, x, v, start, end);
    return self_pair_passes(pair->is_edges, (const double(*)[3])start, (const double(*)[3])end,
                            &found);
}

/* Resets the history for a new list of pairs. Returns 0, or -1 if out of memory. */
static int reset_history(self_history *history, int vertices, int pairs) {
    if (array_grow(&history->pair, &history->pair_room, pairs, sizeof *history->pair) != 0 ||
        array_grow(&history->demand, &history->demand_room, pairs, sizeof *history->demand) != 0)
        return -1;
    history->now = 0;
    memset(history->vertex, 0, (size_t)vertices * sizeof *history->vertex);
    for (int n = 0; n < pairs; n++)
        history->pair[n] = -1;
    return 0;
}

int self_collision_check(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    int passing = 0;
    s->left = 1;
    if (self_grid_find(s, h, x, v, s->gap) != 0)
        return -1;
#pragma omp parallel for schedule(dynamic, PAIRS_AT_ONCE) reduction(+ : passing)
    for (int n = 0; n < s->pair_count; n++)
        passing += self_collision_passes(s, &s->pair[n], h, x, v);
    s->left = passing;
    return 0;
}

int self_collision_find(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    s->left = 0;
    /* Impulses usually move a vertex by less than a gap in a step. self_collision_check finds pairs
     * that come near nevertheless. */
    if (self_grid_find(s, h, x, v, 2 * s->gap) != 0)
        return -1;
    s->visits += s->pair_count;
    return reset_history(&s->history, s->mesh->vertex_count, s->pair_count);
}
