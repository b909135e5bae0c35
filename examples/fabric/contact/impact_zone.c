/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "impact.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

enum { most_growths = 20 };

/** Sums over a zone's vertices, stored at the zone's root. */
typedef struct zone {
    int count, held;
    double mass, center[3], momentum[3]; /* kg, kg m, kg m/s */
    double held_speed[3];                /* sum over the held vertices, m/s */
    double inertia[3][3], spin[3];       /* about the centre, kg m^2; kg m^2/s */
} zone;

/* Joins the vertices of each passing pair to one zone. Returns the number of passing pairs. */
static int join(const self_collision *s, int *parent, double h, const double (*x)[3],
                const double (*v)[3]) {
    int passing = 0;
    for (int n = 0; n < s->pair_count; n++) {
        const self_pair *pair = &s->pair[n];
        if (!self_collision_passes(s, pair, h, x, v))
            continue;
        passing++;
        for (int k = 1; k < 4; k++) {
            const int one = forest_root(parent, pair->vertex[0]);
            const int other = forest_root(parent, pair->vertex[k]);
            parent[one < other ? other : one] = one < other ? one : other;
        }
    }
    return passing;
}

static void sum_up(const self_collision *s, const movable *of, int *parent, const double (*x)[3],
                   const double (*v)[3], zone *zones) {
    const int count = s->mesh->vertex_count;
    memset(zones, 0, sizeof *zones * (size_t)count);
    for (int i = 0; i < count; i++) {
        zone *z = &zones[forest_root(parent, i)];
        z->count++;
        z->mass += of->mass[i];
        vector_add_scaled(z->center, of->mass[i], x[i], z->center);
        vector_add_scaled(z->momentum, of->mass[i], v[i], z->momentum);
        if (movable_is_held(of, i)) {
            z->held++;
            vector_add_scaled(z->held_speed, 1, v[i], z->held_speed);
        }
    }
    for (int i = 0; i < count; i++) {
        zone *z = &zones[forest_root(parent, i)];
        double arm[3], turn[3];
        for (int a = 0; a < 3; a++)
            arm[a] = x[i][a] - (z->mass > 0 ? z->center[a] / z->mass : 0);
        vector_cross(arm, v[i], turn);
        vector_add_scaled(z->spin, of->mass[i], turn, z->spin);
        const double square = vector_dot(arm, arm);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                z->inertia[r][c] += of->mass[i] * ((r == c ? square : 0) - arm[r] * arm[c]);
    }
}

/* Solves inertia * turn = spin by Cramer's rule. The turn is 0 for a zone in a line, whose inertia
 * is singular. */
static void angular_velocity(const zone *z, double turn[3]) {
    double cross[3], trace = 0;
    vector_cross(z->inertia[1], z->inertia[2], cross);
    const double determinant = vector_dot(z->inertia[0], cross);
    for (int a = 0; a < 3; a++)
        trace += z->inertia[a][a];
    for (int a = 0; a < 3; a++) {
        /* The inertia is symmetric: its rows are its columns. */
        const double *one = a == 0 ? z->spin : z->inertia[0];
        const double *two = a == 1 ? z->spin : z->inertia[1];
        const double *three = a == 2 ? z->spin : z->inertia[2];
        vector_cross(two, three, cross);
        turn[a] =
            determinant > 1e-9 * trace * trace * trace ? vector_dot(one, cross) / determinant : 0;
    }
}

static double move_together(const self_collision *s, const movable *of, int *parent,
                            const double (*x)[3], double (*v)[3], const zone *zones) {
    double work = 0;
    for (int i = 0; i < s->mesh->vertex_count; i++) {
        const zone *z = &zones[forest_root(parent, i)];
        double turn[3] = {0, 0, 0}, arm[3], around[3], change[3];
        assert(z->held <= z->count);
        if (z->count < 2 || !(z->mass > 0))
            continue;
        if (z->held == 0)
            angular_velocity(z, turn);
        for (int a = 0; a < 3; a++) {
            arm[a] = x[i][a] - z->center[a] / z->mass;
            change[a] = z->held > 0 ? z->held_speed[a] / z->held : z->momentum[a] / z->mass;
        }
        vector_cross(turn, arm, around);
        const double before = vector_dot(v[i], v[i]);
        for (int a = 0; a < 3; a++)
            change[a] += around[a] - v[i][a];
        movable_part(of, i, v[i], change, change);
        movable_move(of, i, change, v[i]);
        work += of->mass[i] * (vector_dot(v[i], v[i]) - before) / 2;
    }
    return work;
}

int impact_zones_make(self_collision *s, const movable *of, double h, const double (*x)[3],
                      double (*v)[3], double *work) {
    const size_t count = (size_t)s->mesh->vertex_count + 1;
    int *parent = malloc(count * sizeof *parent);
    zone *zones = malloc(count * sizeof *zones);
    int status = parent && zones ? 0 : -1;
    for (size_t i = 0; status == 0 && i < count; i++)
        parent[i] = (int)i;
    for (int n = 0; status == 0; n++) {
        s->left = join(s, parent, h, x, (const double(*)[3])v);
        if (s->left == 0 || n == most_growths)
            break;
        sum_up(s, of, parent, x, (const double(*)[3])v, zones);
        *work += move_together(s, of, parent, x, v, zones);
        status = self_grid_find(s, h, x, (const double(*)[3])v, s->gap);
    }
    free(parent);
    free(zones);
    return status;
}
