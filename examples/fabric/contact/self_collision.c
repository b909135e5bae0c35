/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "self_collision.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "mesh/mesh_sides.h"

/* Pairs nearer than the gap separate by this fraction of the missing distance in a step of the
 * scene. */
static const double drawing_apart = 0.25;
/* What would pass is kept this part of its distance, or of the gap, away. */
static const double kept_away = 0.1;

/* Each vertex and edge is owned by the first of its triangles. */
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
    s->grid.box = calloc((size_t)m->triangle_count + 1, sizeof *s->grid.box);
    s->grid.owned = calloc((size_t)m->triangle_count + 1, sizeof *s->grid.owned);
    s->turns.vertex = calloc((size_t)m->vertex_count + 1, sizeof *s->turns.vertex);
    s->turns.v = calloc((size_t)m->vertex_count + 1, sizeof *s->turns.v);
    if (s->grid.box && s->grid.owned && s->turns.vertex && s->turns.v && share_out(s) == 0)
        return 0;
    self_collision_free(s);
    return -1;
}

void self_collision_free(self_collision *s) {
    free(s->grid.box);
    free(s->grid.owned);
    free(s->grid.start);
    free(s->grid.entry);
    for (int part = 0; part < SELF_PARTS; part++)
        free(s->grid.part[part].pair);
    free(s->pair);
    free(s->turns.vertex);
    free(s->turns.v);
    free(s->turns.pair);
    *s = (self_collision){0};
}

static void gather(const self_pair *pair, double h, const double (*x)[3], const double (*v)[3],
                   double start[4][3], double end[4][3]) {
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++) {
            start[k][a] = x[pair->vertex[k]][a];
            end[k][a] = start[k][a] + (h * v[pair->vertex[k]][a]);
        }
}

/* Whether the swept boxes of the two features keep more than this distance. For most pairs they
 * do. */
static int stay_apart(double apart, const self_pair *pair, const double start[4][3],
                      const double end[4][3]) {
    const int firsts = pair->is_edges ? 2 : 1;
    for (int a = 0; a < 3; a++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int k = 0; k < 4; k++) {
            const int side = k >= firsts;
            const double least = start[k][a] < end[k][a] ? start[k][a] : end[k][a];
            const double most = start[k][a] < end[k][a] ? end[k][a] : start[k][a];
            low[side] = least < low[side] ? least : low[side];
            high[side] = most > high[side] ? most : high[side];
        }
        if (low[0] > high[1] + apart || low[1] > high[0] + apart)
            return 1;
    }
    return 0;
}

/* Are the features nearer than the gap in the rest shape, as those of thin triangles are? They are
 * only kept from passing. */
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

/* The change of the normal velocity that this contact asks for, m/s; 0: none. */
static double asked(const self_collision *s, const self_pair *pair, double h, const double (*v)[3],
                    const double start[4][3], const double end[4][3], self_contact *found) {
    double speed = 0, least = 0;
    if (stay_apart(s->gap, pair, start, end))
        return 0;
    if (!pair->near_at_rest && self_pair_is_near(pair->is_edges, start, s->gap, found) &&
        !rest_near(s, pair))
        least = drawing_apart * (s->gap - found->distance) / s->step;
    else if (self_pair_passes(pair->is_edges, start, end, found))
        least = -(1 - kept_away) * found->distance / h;
    else if (!pair->near_at_rest &&
             self_pair_ends_near(pair->is_edges, start, end, kept_away * s->gap, found) &&
             !rest_near(s, pair))
        least = (kept_away * s->gap - found->distance) / h;
    else
        return 0;
    for (int k = 0; k < 4; k++)
        speed += found->weight[k] * vector_dot(found->normal, v[pair->vertex[k]]);
    return speed < least ? least - speed : 0;
}

static int is_quiet(const self_collision *s, int n) {
    const int seen = s->turns.pair[n], *vertex = s->pair[n].vertex, *changed = s->turns.vertex;
    return seen >= 0 && changed[vertex[0]] <= seen && changed[vertex[1]] <= seen &&
           changed[vertex[2]] <= seen && changed[vertex[3]] <= seen;
}

/* asked, of pair n at velocities v. */
static double asked_now(const self_collision *s, int n, double h, const double (*x)[3],
                        const double (*v)[3], self_contact *found) {
    double start[4][3], end[4][3];
    gather(&s->pair[n], h, x, v, start, end);
    return asked(s, &s->pair[n], h, v, (const double(*)[3])start, (const double(*)[3])end, found);
}

/* In parallel: marks velocities that changed since the last round, and pairs that need no
 * impulse at the beginning of a round. These are most pairs; the sequential part skips them. */
static void look_through(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    self_turns *turns = &s->turns;
    turns->now++;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->mesh->vertex_count; i++)
        if (memcmp(v[i], turns->v[i], sizeof v[i]) != 0)
            turns->vertex[i] = turns->now;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < s->pair_count; n++) {
        self_contact found;
        if (!is_quiet(s, n) && !(asked_now(s, n, h, x, v, &found) > 0))
            turns->pair[n] = turns->now;
    }
}

/* Returns the change of the normal velocity, m/s; 0: none. */
static double push_pair(self_collision *s, const movable *of, int n, double h, const double (*x)[3],
                        double (*v)[3], double *work) {
    self_contact found;
    feature both = {.count = 4};
    const double change = asked_now(s, n, h, x, (const double(*)[3])v, &found);
    if (!(change > 0)) {
        s->turns.pair[n] = s->turns.now;
        return 0;
    }
    for (int k = 0; k < 4; k++) {
        both.vertex[k] = s->pair[n].vertex[k];
        both.weight[k] = found.weight[k];
    }
    if (!impulse_give(of, &both, found.normal, change, s->friction, NULL, v, work))
        return 0;
    s->turns.now++;
    for (int k = 0; k < 4; k++)
        s->turns.vertex[both.vertex[k]] = s->turns.now;
    return change;
}

double self_collision_push(self_collision *s, const movable *of, double h, const double (*x)[3],
                           double (*v)[3], double *work) {
    double largest = 0;
    look_through(s, h, x, (const double(*)[3])v);
    for (int n = 0; n < s->pair_count; n++)
        if (!is_quiet(s, n))
            largest = fmax(largest, push_pair(s, of, n, h, x, v, work));
    memcpy(s->turns.v, v, sizeof *v * (size_t)s->mesh->vertex_count);
    return largest;
}

int self_collision_passes(const self_collision *s, const self_pair *pair, double h,
                          const double (*x)[3], const double (*v)[3]) {
    double start[4][3], end[4][3];
    self_contact found;
    gather(pair, h, x, v, start, end);
    return !stay_apart(s->gap, pair, (const double(*)[3])start, (const double(*)[3])end) &&
           self_pair_passes(pair->is_edges, (const double(*)[3])start, (const double(*)[3])end,
                            &found);
}

/* For pairs that were just found. 0, or -1: out of memory. */
static int forget_turns(self_turns *turns, int vertices, int pairs) {
    if (turns->pair_room < pairs) {
        free(turns->pair);
        turns->pair = malloc((size_t)pairs * sizeof *turns->pair);
        turns->pair_room = turns->pair ? pairs : 0;
    }
    if (pairs > 0 && !turns->pair)
        return -1;
    turns->now = 0;
    memset(turns->vertex, 0, (size_t)vertices * sizeof *turns->vertex);
    for (int n = 0; n < pairs; n++)
        turns->pair[n] = -1;
    return 0;
}

int self_collision_check(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    int passing = 0;
    s->left = 1;
    if (self_grid_find(s, h, x, v) != 0)
        return -1;
#pragma omp parallel for schedule(static) reduction(+ : passing)
    for (int n = 0; n < s->pair_count; n++)
        passing += self_collision_passes(s, &s->pair[n], h, x, v);
    s->left = passing;
    return forget_turns(&s->turns, s->mesh->vertex_count, s->pair_count);
}

/* Keeps the pairs that may come near. What impulses move a vertex by in a step is less than a gap,
 * as a rule; what comes near all the same is found when the step is looked through at its end. */
static void drop_far_pairs(self_collision *s, double h, const double (*x)[3],
                           const double (*v)[3]) {
    int kept[SELF_PARTS];
#pragma omp parallel for schedule(static)
    for (int part = 0; part < SELF_PARTS; part++) {
        const int first = self_part_start(s->pair_count, part);
        int last = first;
        for (int n = first; n < self_part_start(s->pair_count, part + 1); n++) {
            double start[4][3], end[4][3];
            gather(&s->pair[n], h, x, v, start, end);
            if (!stay_apart(2 * s->gap, &s->pair[n], (const double(*)[3])start,
                            (const double(*)[3])end))
                s->pair[last++] = s->pair[n];
        }
        kept[part] = last - first;
    }
    int count = 0;
    for (int part = 0; part < SELF_PARTS; part++) {
        const self_pair *from = s->pair + self_part_start(s->pair_count, part);
        memmove(s->pair + count, from, (size_t)kept[part] * sizeof *from);
        count += kept[part];
    }
    s->pair_count = count;
}

int self_collision_find(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    s->left = 0;
    if (self_grid_find(s, h, x, v) != 0)
        return -1;
    s->visits += s->pair_count;
    drop_far_pairs(s, h, x, v);
    return forget_turns(&s->turns, s->mesh->vertex_count, s->pair_count);
}
