/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "collision.h"

#include <stdlib.h>

#include "chunk_sum.h"
#include "shape.h"
#include "vector.h"

/* Steps in a row in which a constraint may pull before it is ended (flickering contacts otherwise
 * shake cloth at rest). */
enum { patience = 2 };

static void find_pins(collisions *c, const mesh *m, const double *mass) {
    const scene *s = c->scene;
    for (int i = 0; i < m->vertex_count; i++) {
        const double *at = m->material[i];
        c->pin_of[i] = mass[i] > 0 ? -1 : s->pin_count;
        for (int p = s->pin_count - 1; p >= 0; p--)
            if (at[0] >= s->pins[p].low[0] && at[0] <= s->pins[p].high[0] &&
                at[1] >= s->pins[p].low[1] && at[1] <= s->pins[p].high[1])
                c->pin_of[i] = p;
        for (int a = 0; a < 3; a++)
            c->pinned_at[i][a] = m->position[i][a];
    }
}

int collisions_init(collisions *c, const mesh *m, const scene *s, const double *mass) {
    const size_t n = (size_t)m->vertex_count + 1;
    *c = (collisions){.scene = s, .vertex_count = m->vertex_count};
    c->stick_speed = 0.01 * s->step * vector_length(s->gravity);
    if (!(c->stick_speed > 1e-5))
        c->stick_speed = 1e-5;
    c->pin_of = calloc(n, sizeof *c->pin_of);
    c->pinned_at = calloc(n, sizeof *c->pinned_at);
    if (s->collider_count > 0) {
        c->before = calloc(n, sizeof *c->before);
        c->now = calloc(n, sizeof *c->now);
    }
    if (!c->pin_of || !c->pinned_at || (s->collider_count > 0 && (!c->before || !c->now))) {
        collisions_free(c);
        return -1;
    }
    find_pins(c, m, mass);
    return 0;
}

void collisions_free(collisions *c) {
    free(c->pin_of);
    free(c->pinned_at);
    free(c->before);
    free(c->now);
    *c = (collisions){0};
}

static const double *pin_velocity(const collisions *c, int i) {
    static const double held[3] = {0, 0, 0};
    return c->pin_of[i] < c->scene->pin_count ? c->scene->pins[c->pin_of[i]].velocity : held;
}

/* Would a vertex at x with velocity v come too near to the collider in the next h seconds? */
static int would_touch(const collider *k, double time, double h, const double x[3],
                       const double v[3], approach *found) {
    double p[3], u[3];
    for (int a = 0; a < 3; a++) {
        p[a] = x[a] - k->position[a] - time * k->velocity[a];
        u[a] = h * (v[a] - k->velocity[a]);
    }
    return shape_approach(k, p, u, found);
}

/* The velocity along the normal that ends the step at the gap. A vertex found inside is pushed out
 * by no more than the gap a step: the push stays in its velocity. */
static double given_speed(const collider *k, const approach *found, double h) {
    const double push = -found->room > k->gap ? k->gap : -found->room;
    return vector_dot(found->normal, k->velocity) + push / h;
}

static contact *find_contact(vertex_contacts *of, int collider_index) {
    for (int n = 0; n < of->count; n++)
        if (of->list[n].collider == collider_index)
            return &of->list[n];
    return NULL;
}

static void add_contact(vertex_contacts *of, const contact *before, const approach *found,
                        int index, const collider *k, double h) {
    if (of->count == CONTACTS_PER_VERTEX)
        return;
    contact *added = &of->list[of->count++];
    *added = before ? *before : (contact){.collider = index};
    for (int a = 0; a < 3; a++)
        added->normal[a] = found->normal[a];
    added->speed = given_speed(k, found, h);
}

/* A_ii += c (I - n n'), b_i -= c (I - n n') (v - v_collider). */
static void add_friction(const contact *touch, const collider *k, double h, const double v[3],
                         double diagonal[3][3], double b[3]) {
    const double factor = h * k->friction * touch->force / touch->slip_speed;
    double slip[3];
    vector_subtract(v, k->velocity, slip);
    const double away = vector_dot(slip, touch->normal);
    for (int r = 0; r < 3; r++) {
        b[r] -= factor * (slip[r] - away * touch->normal[r]);
        for (int c = 0; c < 3; c++)
            diagonal[r][c] += factor * ((r == c ? 1 : 0) - touch->normal[r] * touch->normal[c]);
    }
}

void collisions_detect(collisions *c, double time, double h, const double (*x)[3],
                       const double (*v)[3], const double (*dv)[3]) {
    if (!c->now)
        return;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->vertex_count; i++) {
        double expected[3];
        vector_add_scaled(v[i], 1, dv[i], expected);
        c->now[i].count = 0;
        if (c->pin_of[i] >= 0)
            continue;
        for (int n = 0; n < c->scene->collider_count; n++) {
            const collider *k = &c->scene->colliders[n];
            const contact *before = find_contact(&c->before[i], n);
            approach found;
            if ((before && before->pulls >= patience) ||
                !would_touch(k, time, h, x[i], expected, &found))
                continue;
            add_contact(&c->now[i], before, &found, n, k, h);
        }
    }
}

void collisions_add_friction(const collisions *c, double h, const double (*v)[3],
                             linear_system *system) {
    if (!c->now)
        return;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->vertex_count; i++)
        for (int n = 0; n < c->now[i].count; n++) {
            const int number = c->now[i].list[n].collider;
            const contact *before = find_contact(&c->before[i], number);
            if (before && !before->sticks && before->force > 0)
                add_friction(before, &c->scene->colliders[number], h, v[i],
                             system->A.value[system->A.row_start[i]], system->b[i]);
        }
}

/* Normals first: they win over the tangents of a contact that sticks. */
static int demands(const collisions *c, const vertex_contacts *of, const double v[3], double d[][3],
                   double *change) {
    int count = 0;
    for (int n = 0; n < of->count; n++, count++) {
        for (int a = 0; a < 3; a++)
            d[count][a] = of->list[n].normal[a];
        change[count] = of->list[n].speed - vector_dot(of->list[n].normal, v);
    }
    for (int n = 0; n < of->count; n++) {
        const collider *k = &c->scene->colliders[of->list[n].collider];
        if (!of->list[n].sticks)
            continue;
        /* All three axes: what lies along the normals is known already and is left out. */
        for (int axis = 0; axis < 3; axis++, count++) {
            for (int a = 0; a < 3; a++)
                d[count][a] =
                    (a == axis ? 1 : 0) - of->list[n].normal[axis] * of->list[n].normal[a];
            change[count] = vector_dot(d[count], k->velocity) - vector_dot(d[count], v);
            if (!(vector_dot(d[count], d[count]) > 0.1))
                count--;
        }
        break;
    }
    return count;
}

void collisions_constrain(const collisions *c, const double (*v)[3], constraints *given) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->vertex_count; i++) {
        double d[CONTACTS_PER_VERTEX + 3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        double change[CONTACTS_PER_VERTEX + 3];
        int count = 0;
        if (c->pin_of[i] >= 0) {
            vector_subtract(pin_velocity(c, i), v[i], change);
            count = 3;
        } else if (c->now) {
            count = demands(c, &c->now[i], v[i], d, change);
        }
        if (count > 0)
            constraint_give(given, i, count, (const double(*)[3])d, change);
        else if (given->given[i] > 0)
            constraint_release(given, i);
    }
}

int collisions_add_missed(collisions *c, double time, double h, const double (*x)[3],
                          const double (*v)[3], const double (*dv)[3]) {
    int added = 0;
    if (!c->now)
        return 0;
#pragma omp parallel for schedule(static) reduction(+ : added)
    for (int i = 0; i < c->vertex_count; i++) {
        double after[3];
        vector_add_scaled(v[i], 1, dv[i], after);
        if (c->pin_of[i] >= 0)
            continue;
        for (int n = 0; n < c->scene->collider_count; n++) {
            const collider *k = &c->scene->colliders[n];
            approach found;
            if (c->now[i].count == CONTACTS_PER_VERTEX || find_contact(&c->now[i], n) ||
                !would_touch(k, time, h, x[i], after, &found) || !(found.beyond > 0))
                continue;
            add_contact(&c->now[i], NULL, &found, n, k, h);
            added++;
        }
    }
    return added;
}

/* Changes the velocity of one vertex; whether it did. */
static int keep_out(const collisions *c, int i, double time, double h, const double x[3],
                    double v[3]) {
    int changed = 0;
    for (int n = 0; n < c->scene->collider_count && c->pin_of[i] < 0; n++) {
        const collider *k = &c->scene->colliders[n];
        approach found;
        if (find_contact(&c->now[i], n) || !would_touch(k, time, h, x, v, &found) ||
            !(found.beyond > 0))
            continue;
        const double lacking = given_speed(k, &found, h) - vector_dot(found.normal, v);
        if (!(lacking > 0))
            continue;
        vector_add_scaled(v, lacking, found.normal, v);
        changed = 1;
    }
    return changed;
}

double collisions_keep_out(const collisions *c, double time, double h, const double *mass,
                           const double (*x)[3], double (*v)[3]) {
    const int count = c->vertex_count;
    double sum[CHUNK_SUM_MOST] = {0};
    if (!c->now)
        return 0;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++) {
            const double before = vector_dot(v[i], v[i]);
            if (keep_out(c, i, time, h, x[i], v[i]))
                sum[chunk] += mass[i] * (vector_dot(v[i], v[i]) - before) / 2;
        }
    return chunk_sum_all(count, sum);
}

void collisions_place_pins(const collisions *c, double time, double (*x)[3], double (*v)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->vertex_count; i++) {
        if (c->pin_of[i] < 0)
            continue;
        for (int a = 0; a < 3; a++) {
            v[i][a] = pin_velocity(c, i)[a];
            x[i][a] = c->pinned_at[i][a] + time * v[i][a];
        }
    }
}

/* What the constraint's force (N) says about the contact: does it pull, does it stick? */
static void judge(contact *touch, const collider *k, double stick_speed, double h, double mass,
                  const double v[3], const double force[3]) {
    double along[3], slip[3];
    touch->force = vector_dot(touch->normal, force);
    vector_add_scaled(force, -touch->force, touch->normal, along);
    vector_subtract(v, k->velocity, slip);
    vector_add_scaled(slip, -vector_dot(slip, touch->normal), touch->normal, slip);
    const double sideways = vector_length(along);
    const double most = touch->force > 0 ? k->friction * touch->force : 0;
    touch->pulls = touch->force < 0 ? touch->pulls + 1 : 0;
    if (touch->sticks) {
        touch->sticks = sideways <= most;
        touch->slip_speed = h * (sideways - most) / mass; /* what it will slip with at most */
    } else {
        touch->slip_speed = vector_length(slip);
        touch->sticks = touch->slip_speed < stick_speed && most > 0;
    }
    if (touch->slip_speed < stick_speed)
        touch->slip_speed = stick_speed;
}

void collisions_accept(collisions *c, double h, const double *mass, const double (*v)[3],
                       const double (*residual)[3]) {
    if (!c->now)
        return;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->vertex_count; i++) {
        const double force[3] = {-residual[i][0] / h, -residual[i][1] / h, -residual[i][2] / h};
        for (int n = 0; n < c->now[i].count; n++) {
            contact *touch = &c->now[i].list[n];
            judge(touch, &c->scene->colliders[touch->collider], c->stick_speed, h, mass[i], v[i],
                  force);
        }
    }
    vertex_contacts *spare = c->before;
    c->before = c->now;
    c->now = spare;
}
