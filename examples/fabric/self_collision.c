/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "self_collision.h"

#include <stdlib.h>
#include <string.h>

#include "mesh_sides.h"
#include "vector.h"

/* Impulses are given in this many rounds, the pairs of each in order. */
enum { most_rounds = 20 };
/* What is nearer than the gap draws apart by this part of what is missing, a step of the scene. */
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
    *s = (self_collision){.mesh = m, .gap = gap, .friction = friction, .step = step};
    s->grid.box = calloc((size_t)m->triangle_count + 1, sizeof *s->grid.box);
    s->grid.owned = calloc((size_t)m->triangle_count + 1, sizeof *s->grid.owned);
    if (s->grid.box && s->grid.owned && share_out(s) == 0)
        return 0;
    self_collision_free(s);
    return -1;
}

void self_collision_free(self_collision *s) {
    free(s->grid.box);
    free(s->grid.owned);
    free(s->grid.start);
    free(s->grid.entry);
    free(s->pair);
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

/* Do the boxes that the two features sweep stay further apart than that? Most pairs do. */
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

/* The change of the normal velocity that this contact asks for, m/s; 0: none. */
static double asked(const self_collision *s, const self_pair *pair, double h, const double (*v)[3],
                    const double start[4][3], const double end[4][3], self_contact *found) {
    double speed = 0, least = 0;
    if (stay_apart(s->gap, pair, start, end))
        return 0;
    if (!pair->near_at_rest && self_pair_is_near(pair->is_edges, start, s->gap, found))
        least = drawing_apart * (s->gap - found->distance) / s->step;
    else if (self_pair_passes(pair->is_edges, start, end, found))
        least = -(1 - kept_away) * found->distance / h;
    else
        return 0;
    for (int k = 0; k < 4; k++)
        speed += found->weight[k] * vector_dot(found->normal, v[pair->vertex[k]]);
    return speed < least ? least - speed : 0;
}

static double inverse_mass_of(const self_pair *pair, const self_contact *found,
                              const double *inverse_mass) {
    double sum = 0;
    for (int k = 0; k < 4; k++)
        sum += found->weight[k] * found->weight[k] * inverse_mass[pair->vertex[k]];
    return sum;
}

/* The same impulse, in kg m/s, on the first feature and against it on the second. */
static void give(const self_pair *pair, const self_contact *found, const double *inverse_mass,
                 const double impulse[3], double (*v)[3]) {
    for (int k = 0; k < 4; k++) {
        const int i = pair->vertex[k];
        vector_add_scaled(v[i], found->weight[k] * inverse_mass[i], impulse, v[i]);
    }
}

/* Coulomb: at most friction times the normal impulse, and no more than stops the sliding. */
static void add_friction(const self_pair *pair, const self_contact *found, double mass, double most,
                         const double (*v)[3], double impulse[3]) {
    double slip[3] = {0, 0, 0};
    for (int k = 0; k < 4; k++)
        vector_add_scaled(slip, found->weight[k], v[pair->vertex[k]], slip);
    vector_add_scaled(slip, -vector_dot(slip, found->normal), found->normal, slip);
    const double stops = mass * vector_length(slip);
    if (stops > 0)
        vector_add_scaled(impulse, -mass * (stops < most ? 1 : most / stops), slip, impulse);
}

/* One round over all pairs; returns the largest change of a normal velocity, m/s. */
static double push_apart(self_collision *s, double h, const double *inverse_mass,
                         const double (*x)[3], double (*v)[3]) {
    double largest = 0;
    for (int n = 0; n < s->pair_count; n++) {
        const self_pair *pair = &s->pair[n];
        const double(*moving)[3] = (const double(*)[3])v;
        double start[4][3], end[4][3], impulse[3] = {0, 0, 0};
        self_contact found;
        gather(pair, h, x, moving, start, end);
        const double change =
            asked(s, pair, h, moving, (const double(*)[3])start, (const double(*)[3])end, &found);
        if (!(change > 0))
            continue;
        const double light = inverse_mass_of(pair, &found, inverse_mass);
        if (!(light > 0))
            continue;
        vector_add_scaled(impulse, change / light, found.normal, impulse);
        add_friction(pair, &found, 1 / light, s->friction * change / light, moving, impulse);
        give(pair, &found, inverse_mass, impulse, v);
        largest = fmax(largest, change);
    }
    return largest;
}

static int count_passing(const self_collision *s, double h, const double (*x)[3],
                         const double (*v)[3]) {
    int passing = 0;
#pragma omp parallel for schedule(static) reduction(+ : passing)
    for (int n = 0; n < s->pair_count; n++) {
        double start[4][3], end[4][3];
        self_contact found;
        gather(&s->pair[n], h, x, v, start, end);
        if (!stay_apart(s->gap, &s->pair[n], (const double(*)[3])start, (const double(*)[3])end))
            passing += self_pair_passes(s->pair[n].is_edges, (const double(*)[3])start,
                                        (const double(*)[3])end, &found);
    }
    return passing;
}

/* Keeps the pairs that may come near. What impulses move a vertex by in a step is less than a gap,
 * as a rule; what comes near all the same is found when the step is looked through at its end. */
static void drop_far_pairs(self_collision *s, double h, const double (*x)[3],
                           const double (*v)[3]) {
    int kept = 0;
    for (int n = 0; n < s->pair_count; n++) {
        double start[4][3], end[4][3];
        gather(&s->pair[n], h, x, v, start, end);
        if (!stay_apart(2 * s->gap, &s->pair[n], (const double(*)[3])start,
                        (const double(*)[3])end))
            s->pair[kept++] = s->pair[n];
    }
    s->pair_count = kept;
}

static double kinetic_energy(const self_collision *s, const double *inverse_mass,
                             const double (*v)[3]) {
    double sum = 0;
    for (int i = 0; i < s->mesh->vertex_count; i++)
        if (inverse_mass[i] > 0)
            sum += vector_dot(v[i], v[i]) / inverse_mass[i] / 2;
    return sum;
}

double self_collision_resolve(self_collision *s, double h, const double *inverse_mass,
                              const double (*x)[3], double (*v)[3]) {
    s->left = 0;
    s->failed = self_grid_find(s, h, x, (const double(*)[3])v) != 0;
    s->visits += s->pair_count;
    if (s->failed || s->pair_count == 0)
        return 0;
    const double before = kinetic_energy(s, inverse_mass, (const double(*)[3])v);
    drop_far_pairs(s, h, x, (const double(*)[3])v);
    double largest = push_apart(s, h, inverse_mass, x, v);
    if (!(largest > 0))
        return 0;
    for (int n = 1; n < most_rounds && largest > 1e-3 * s->gap / h; n++)
        largest = push_apart(s, h, inverse_mass, x, v);
    /* The boxes have moved with the velocities. */
    s->failed = self_grid_find(s, h, x, (const double(*)[3])v) != 0;
    s->left = s->failed ? 1 : count_passing(s, h, x, (const double(*)[3])v);
    return kinetic_energy(s, inverse_mass, (const double(*)[3])v) - before;
}
