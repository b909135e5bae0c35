/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "impact.h"

#include <math.h>

/* Number of rounds of impulses, and of searches for pairs. */
enum { most_rounds = 20, most_searches = 3 };

/* Gives one round of all impulses. Returns the largest change of a velocity, m/s. */
static double push(impact_step *s, double *own_work, double *body_work) {
    double largest = 0;
    if (s->itself)
        largest = self_collision_push(s->itself, &s->of, s->h, s->x, s->v, own_work);
    largest = fmax(largest, collisions_keep_out(s->bodies, s->time, s->h, s->x, s->v, body_work));
    return fmax(largest,
                collisions_push_triangles(s->bodies, &s->of, s->time, s->h, s->x, s->v, body_work));
}

static int find(const impact_step *s) {
    const double(*v)[3] = (const double(*)[3])s->v;
    if (s->itself && self_collision_find(s->itself, s->h, s->x, v) != 0)
        return -1;
    collisions_find_near(s->bodies, s->time, s->h, s->x, v, NULL);
    return collisions_find_triangles(s->bodies, s->time, s->h, s->x, v);
}

static int has_rounds(const impact_step *s) {
    return (s->itself && s->itself->pair_count > 0) || s->bodies->met.count > 0;
}

/* Rounds end when all changes of velocity are below this, m/s. */
static double little(const impact_step *s) {
    const double own = s->itself ? s->itself->gap : INFINITY;
    return 1e-3 * fmin(own, s->bodies->met.gap) / s->h;
}

/* Gives rounds of impulses to the pairs and triangles found last, until the largest change of a
 * velocity is small or no round is left. Returns whether a velocity was changed. */
static int push_until_settled(impact_step *s, double *own_work, double *body_work) {
    double largest = push(s, own_work, body_work);
    const int changed = largest > 0;
    const double enough = little(s);
    for (int n = 1; n < most_rounds && largest > enough && has_rounds(s); n++)
        largest = push(s, own_work, body_work);
    return changed;
}

int impact_resolve(impact_step *s, double *work) {
    double own_work = 0, body_work = 0;
    int changed = 1, failed = 0;
    for (int n = 0; n < most_searches && changed && !failed; n++) {
        failed = find(s) != 0;
        changed = !failed && push_until_settled(s, &own_work, &body_work) && s->itself;
        if (!changed)
            break;
        failed = self_collision_check(s->itself, s->h, s->x, (const double(*)[3])s->v) != 0;
        changed = s->itself->left > 0;
    }
    if (!failed && s->itself && s->itself->left > 0)
        failed = impact_zones_make(s->itself, &s->of, s->h, s->x, s->v, &own_work) != 0;
    if (!failed && s->bodies->met.count > 0)
        collisions_check_triangles(s->bodies, &s->of, s->time, s->h, s->x,
                                   (const double(*)[3])s->v);
    *work = body_work + (own_work < 0 ? own_work : 0);
    return failed ? -1 : 0;
}
