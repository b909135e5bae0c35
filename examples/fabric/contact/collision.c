/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "collision.h"

#include <stdlib.h>
#include <string.h>

#include "base/chunk_sum.h"
#include "base/vector.h"
#include "shape.h"

/* Number of consecutive steps in which a constraint may pull before the contact ends. (Contacts
 * that ended at once would flicker and shake cloth at rest.) */
enum { most_pulls = 2 };

/* Is `time` in the interval from `from` to `until` (0: no end)? */
static int lasts(double from, double until, double time) {
    return time >= from && (until <= 0 || time < until);
}

/* Finds the vertices that pins hold at `time`; of several pins the first holds. A vertex without
 * mass that no pin holds gets the number pin_count, whose speed is 0. */
static void find_pins(collisions *c, double time) {
    const scene *s = c->scene;
    c->pinned.count = 0;
    if (!c->pinned.pin_of)
        return;
    for (int i = 0; i < c->mesh->vertex_count; i++)
        c->pinned.pin_of[i] = c->mass[i] > 0 ? -1 : s->pin_count;
    for (int p = s->pin_count - 1; p >= 0; p--)
        if (lasts(0, s->pins[p].until, time))
            pin_find(&s->pins[p], c->mesh, p, c->pinned.pin_of);
    for (int i = 0; i < c->mesh->vertex_count; i++)
        if (c->pinned.pin_of[i] >= 0)
            c->pinned.list[c->pinned.count++] = i;
}

/* Is a vertex ever held? */
static int any_pins(const collisions *c) {
    for (int i = 0; i < c->mesh->vertex_count && c->scene->pin_count == 0; i++)
        if (!(c->mass[i] > 0))
            return 1;
    return c->scene->pin_count > 0;
}

void collisions_follow(collisions *c, double time) {
    find_pins(c, time);
    c->any_there = 0;
    c->others.count = -1;
    for (int n = 0; n < c->scene->collider_count; n++) {
        c->there[n] =
            (unsigned char)lasts(c->scene->colliders[n].from, c->scene->colliders[n].until, time);
        c->any_there += c->there[n];
    }
}

/* The number of seconds for which a pin has moved by `time`. */
static double moving_time(const pin *p, double time) {
    const double end = p->move_until > 0 && time > p->move_until ? p->move_until : time;
    return end > p->move_from ? end - p->move_from : 0;
}

static void set_pin_speeds(collisions *c, double time, double h) {
    for (int p = 0; p < c->scene->pin_count; p++) {
        const pin *of = &c->scene->pins[p];
        const double moving = moving_time(of, time + h) - moving_time(of, time);
        const int always = of->move_from <= 0 && of->move_until <= 0;
        for (int a = 0; a < 3; a++)
            c->pinned.speed[p][a] = of->velocity[a] * (always ? 1 : moving / h);
    }
}

static int any_keyframes(const scene *s) {
    for (int n = 0; n < s->collider_count; n++)
        if (motion_has_keys(&s->colliders[n]))
            return 1;
    return 0;
}

static int allocate(collisions *c) {
    const size_t n = (size_t)c->mesh->vertex_count + 1;
    const size_t colliders = (size_t)c->scene->collider_count + 1;
    if (any_pins(c)) {
        c->pinned.pin_of = arrays_add(&c->own, n, sizeof *c->pinned.pin_of);
        c->pinned.list = calloc(n, sizeof *c->pinned.list);
        c->own.failed |= !c->pinned.list;
    }
    c->pinned.speed = arrays_add(&c->own, (size_t)c->scene->pin_count + 1, sizeof *c->pinned.speed);
    c->there = arrays_add(&c->own, colliders, 1);
    c->near_list = arrays_add(&c->own, colliders, sizeof *c->near_list);
    c->others.watched = arrays_add(&c->own, colliders, sizeof *c->others.watched);
    if (any_keyframes(c->scene)) {
        c->motion = arrays_add(&c->own, colliders, sizeof *c->motion);
        c->carried = arrays_add(&c->own, n, sizeof *c->carried);
    }
    if (c->scene->collider_count > 0) {
        c->before = arrays_add(&c->own, n, sizeof *c->before);
        c->now = arrays_add(&c->own, n, sizeof *c->now);
    }
    return c->own.failed ? -1 : 0;
}

int collisions_init(collisions *c, const mesh *m, const scene *s, const double *mass) {
    *c = (collisions){.scene = s, .mesh = m, .mass = mass, .now_empty = 1, .before_empty = 1};
    c->stick_speed = 0.01 * s->time.step * vector_length(s->surroundings.gravity);
    if (!(c->stick_speed > 1e-5))
        c->stick_speed = 1e-5;
    if (allocate(c) != 0) {
        collisions_free(c);
        return -1;
    }
    collisions_follow(c, 0);
    if (c->pinned.list) { /* pins only release: the number of held vertices never grows */
        int *held = realloc(c->pinned.list, ((size_t)c->pinned.count + 1) * sizeof *held);
        c->pinned.list = held ? held : c->pinned.list;
    }
    set_pin_speeds(c, 0, s->time.step);
    collisions_find_near(c, 0, 0, (const double(*)[3])m->position, NULL, NULL);
    return 0;
}

void collisions_free(collisions *c) {
    arrays_free(&c->own);
    free(c->pinned.list);
    free(c->met.list);
    free(c->met.distance);
    free(c->met.is_near);
    *c = (collisions){0};
}

/* A vertex that slides over a rotating body ends the step at another point of it. Replaces the
 * tangent plane that the vertex must stay outside of by the one at the end p + u, unless the path
 * leads around or through the body. Returns 0 if the vertex ends outside, otherwise 1. */
static int use_plane_at_end(const collider *k, const body_motion *m, const double p[3],
                            const double u[3], const double v[3], approach *found) {
    approach end;
    double at[3], past[3];
    vector_add_scaled(p, 1, u, at);
    end.beyond = k->gap - shape_distance(k, at, end.normal);
    if (vector_dot(end.normal, found->normal) < 0.5) {
        motion_carry(k, m, p, found->normal, found->carried);
        return 1;
    }
    motion_carry(k, m, at, end.normal, end.carried);
    vector_subtract(end.carried, v, past);
    end.room = m->h * vector_dot(end.normal, past) - end.beyond;
    *found = end;
    return end.beyond > -(1e-3 * k->gap + 1e-9);
}

/* Would a vertex at x with velocity v come too near to the collider in the next h seconds? */
static int would_touch(const collisions *c, int number, double time, double h, const double x[3],
                       const double v[3], approach *found) {
    const collider *k = &c->scene->colliders[number];
    const body_motion *motion = c->motion ? &c->motion[number] : NULL;
    double p[3], u[3];
    motion_enter(k, motion, time, h, x, v, p, u);
    if (!shape_approach(k, p, u, found))
        return 0;
    if (motion_has_keys(k) && motion->rotates)
        return use_plane_at_end(k, motion, p, u, v, found);
    motion_carry(k, motion, p, found->normal, found->carried);
    return 1;
}

double collisions_given_speed(const collisions *c, const collider *k, const approach *found,
                              double h) {
    const double most = k->gap * (h / c->scene->time.step);
    const double push = -found->room > most ? most : -found->room;
    return vector_dot(found->normal, found->carried) + push / h;
}

static contact *find_contact(vertex_contacts *of, int collider_index) {
    for (int n = 0; n < of->count; n++)
        if (of->list[n].collider == collider_index)
            return &of->list[n];
    return NULL;
}

static void add_contact(const collisions *c, int vertex, const contact *before,
                        const approach *found, int index, const collider *k, double h) {
    vertex_contacts *of = &c->now[vertex];
    if (of->count == CONTACTS_PER_VERTEX)
        return;
    if (c->carried)
        memcpy(c->carried[vertex][of->count], found->carried, sizeof found->carried);
    contact *added = &of->list[of->count++];
    *added = before ? *before : (contact){.collider = index};
    memcpy(added->normal, found->normal, sizeof added->normal);
    added->speed = collisions_given_speed(c, k, found, h);
}

/* Adds sliding friction, with k = h friction force / slip speed (c in collision.h): A_ii += k (I
 * - n n'), b_i -= k (I - n n') (v - v_collider). */
static void add_friction(const contact *touch, double friction, const double carried[3], double h,
                         const double v[3], double diagonal[3][3], double b[3]) {
    const double factor = h * friction * touch->force / touch->slip_speed;
    double slip[3];
    vector_subtract(v, carried, slip);
    const double away = vector_dot(slip, touch->normal);
    for (int r = 0; r < 3; r++) {
        b[r] -= factor * (slip[r] - away * touch->normal[r]);
        for (int c = 0; c < 3; c++)
            diagonal[r][c] += factor * ((r == c ? 1 : 0) - touch->normal[r] * touch->normal[c]);
    }
}

static void clear_contacts(collisions *c) {
    for (int i = 0; i < c->mesh->vertex_count && !c->now_empty; i++)
        c->now[i].count = 0;
    c->now_empty = 1;
}

void collisions_detect(collisions *c, double time, double h, const double (*x)[3],
                       const double (*v)[3], const double (*dv)[3]) {
    set_pin_speeds(c, time, h);
    if (!c->now)
        return;
    collisions_find_near(c, time, h, x, v, dv);
    if (!c->any_near) {
        clear_contacts(c);
        return;
    }
    c->now_empty = 0;
    c->visits += (long)c->mesh->vertex_count * c->any_near;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->mesh->vertex_count; i++) {
        double expected[3];
        vector_add_scaled(v[i], 1, dv[i], expected);
        c->now[i].count = 0;
        if (collisions_pin_of(c, i) >= 0)
            continue;
        for (int m = 0; m < c->any_near; m++) {
            const int n = c->near_list[m];
            const collider *k = &c->scene->colliders[n];
            const contact *before = find_contact(&c->before[i], n);
            approach found;
            if ((before && before->pulls >= most_pulls) ||
                !would_touch(c, n, time, h, x[i], expected, &found))
                continue;
            add_contact(c, i, before, &found, n, k, h);
        }
    }
}

void collisions_add_friction(collisions *c, double h, const double (*v)[3], linear_system *system) {
    long visits = 0;
    if (!c->now || c->now_empty)
        return;
#pragma omp parallel for schedule(static) reduction(+ : visits)
    for (int i = 0; i < c->mesh->vertex_count; i++)
        for (int n = 0; n < c->now[i].count; n++) {
            const int number = c->now[i].list[n].collider;
            const contact *before = find_contact(&c->before[i], number);
            if (!before || before->sticks || !(before->force > 0))
                continue;
            add_friction(before, c->scene->colliders[number].friction, collisions_carried(c, i, n),
                         h, v[i], system->A.value[system->A.row_start[i]], system->b[i]);
            visits++;
        }
    c->friction_visits += visits;
}

/* Computes the constraints of a vertex as directions and changes. Normals come first, so that they
 * win over the tangents of a sticking contact. */
static int demands(const collisions *c, int vertex, const double v[3], double d[][3],
                   double *change) {
    const vertex_contacts *of = &c->now[vertex];
    int count = 0;
    for (int n = 0; n < of->count; n++, count++) {
        memcpy(d[count], of->list[n].normal, sizeof *d);
        change[count] = of->list[n].speed - vector_dot(of->list[n].normal, v);
    }
    for (int n = 0; n < of->count; n++) {
        if (!of->list[n].sticks)
            continue;
        /* All three axes are given; constraint_give drops those that depend on earlier ones. */
        for (int axis = 0; axis < 3; axis++, count++) {
            for (int a = 0; a < 3; a++)
                d[count][a] =
                    (a == axis ? 1 : 0) - of->list[n].normal[axis] * of->list[n].normal[a];
            change[count] =
                vector_dot(d[count], collisions_carried(c, vertex, n)) - vector_dot(d[count], v);
            if (!(vector_dot(d[count], d[count]) > 0.1))
                count--;
        }
        break;
    }
    return count;
}

/* Is the vertex to be constrained? */
static int is_given(const collisions *c, int i, int contacts) {
    return collisions_pin_of(c, i) >= 0 || (contacts && c->now[i].count > 0);
}

int collisions_constrain(const collisions *c, const double (*v)[3], constraints *given) {
    const int contacts = c->now && !c->now_empty;
    if (c->pinned.count == 0 && !contacts && given->used == 0)
        return 0;
    for (int i = 0; i < c->mesh->vertex_count; i++)
        if (is_given(c, i, contacts) && constraint_place(given, i) != 0)
            return -1;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->mesh->vertex_count; i++) {
        double d[CONTACTS_PER_VERTEX + 3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        double change[CONTACTS_PER_VERTEX + 3];
        int count = 0;
        if (collisions_pin_of(c, i) >= 0) {
            vector_subtract(c->pinned.speed[c->pinned.pin_of[i]], v[i], change);
            count = 3;
        } else if (contacts) {
            count = demands(c, i, v[i], d, change);
        }
        if (count > 0)
            constraint_give(given, i, count, (const double(*)[3])d, change);
        else if (given->given[i] > 0)
            constraint_release(given, i);
    }
    return 0;
}

int collisions_add_missed(collisions *c, double time, double h, const double (*x)[3],
                          const double (*v)[3], const double (*dv)[3]) {
    int added = 0;
    if (!c->now)
        return 0;
    collisions_find_near(c, time, h, x, v, dv);
    if (!c->any_near)
        return 0;
    c->now_empty = 0;
#pragma omp parallel for schedule(static) reduction(+ : added)
    for (int i = 0; i < c->mesh->vertex_count; i++) {
        double after[3];
        vector_add_scaled(v[i], 1, dv[i], after);
        if (collisions_pin_of(c, i) >= 0)
            continue;
        for (int m = 0; m < c->any_near; m++) {
            const int n = c->near_list[m];
            const collider *k = &c->scene->colliders[n];
            approach found;
            if (c->now[i].count == CONTACTS_PER_VERTEX || find_contact(&c->now[i], n) ||
                !would_touch(c, n, time, h, x[i], after, &found) || !(found.beyond > 0))
                continue;
            add_contact(c, i, NULL, &found, n, k, h);
            added++;
        }
    }
    return added;
}

/* Changes the velocity of vertex i so that it stays outside of near colliders. Returns the largest
 * change, m/s. */
static double keep_out(const collisions *c, int i, double time, double h, const double x[3],
                       double v[3]) {
    double changed = 0;
    for (int m = 0; m < c->any_near && collisions_pin_of(c, i) < 0; m++) {
        const int n = c->near_list[m];
        const collider *k = &c->scene->colliders[n];
        approach found;
        if (find_contact(&c->now[i], n) || !would_touch(c, n, time, h, x, v, &found) ||
            !(found.beyond > 0))
            continue;
        const double lacking =
            collisions_given_speed(c, k, &found, h) - vector_dot(found.normal, v);
        if (!(lacking > 0))
            continue;
        vector_add_scaled(v, lacking, found.normal, v);
        changed = lacking > changed ? lacking : changed;
    }
    return changed;
}

double collisions_keep_out(collisions *c, double time, double h, const double (*x)[3],
                           double (*v)[3], double *work) {
    const int count = c->mesh->vertex_count;
    double sum[CHUNK_SUM_MOST] = {0}, largest = 0;
    if (!c->now || !c->any_near)
        return 0;
#pragma omp parallel for schedule(static) reduction(max : largest)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++) {
        double own = 0;
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++) {
            const double before = vector_dot(v[i], v[i]);
            const double changed = keep_out(c, i, time, h, x[i], v[i]);
            if (changed > 0)
                own += c->mass[i] * (vector_dot(v[i], v[i]) - before) / 2;
            largest = changed > largest ? changed : largest;
        }
        sum[chunk] = own;
    }
    *work += chunk_sum_all(count, sum);
    return largest;
}

void collisions_place_pins(const collisions *c, double time, double (*x)[3], double (*v)[3]) {
#pragma omp parallel for schedule(static)
    for (int n = 0; n < c->pinned.count; n++) {
        const int i = c->pinned.list[n], p = c->pinned.pin_of[i];
        const double moving = p < c->scene->pin_count ? moving_time(&c->scene->pins[p], time) : 0;
        for (int a = 0; a < 3; a++) {
            v[i][a] = c->pinned.speed[p][a];
            x[i][a] = c->mesh->position[i][a] +
                      (p < c->scene->pin_count ? moving * c->scene->pins[p].velocity[a] : 0);
        }
    }
}

/* Decides from the constraint's force (N) whether the contact pulls, and whether it sticks. */
static void settle(contact *touch, const collider *k, const double carried[3], double stick_speed,
                   double h, double mass, const double v[3], const double force[3]) {
    double along[3], slip[3];
    touch->force = vector_dot(touch->normal, force);
    vector_add_scaled(force, -touch->force, touch->normal, along);
    vector_subtract(v, carried, slip);
    vector_add_scaled(slip, -vector_dot(slip, touch->normal), touch->normal, slip);
    const double sideways = vector_length(along);
    const double most = touch->force > 0 ? k->friction * touch->force : 0;
    touch->pulls = touch->force < 0 ? touch->pulls + 1 : 0;
    if (touch->sticks) {
        touch->sticks = sideways <= most;
        touch->slip_speed = h * (sideways - most) / mass; /* an upper bound */
    } else {
        touch->slip_speed = vector_length(slip);
        touch->sticks = touch->slip_speed < stick_speed && most > 0;
    }
    if (touch->slip_speed < stick_speed)
        touch->slip_speed = stick_speed;
}

void collisions_accept(collisions *c, double h, const double (*v)[3], const double (*residual)[3]) {
    if (!c->now)
        return;
    const int before_empty = c->before_empty;
    c->before_empty = c->now_empty;
    c->now_empty = before_empty;
    if (c->before_empty && c->now_empty)
        return;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->mesh->vertex_count; i++) {
        const double force[3] = {-residual[i][0] / h, -residual[i][1] / h, -residual[i][2] / h};
        for (int n = 0; n < c->now[i].count; n++) {
            contact *touch = &c->now[i].list[n];
            settle(touch, &c->scene->colliders[touch->collider], collisions_carried(c, i, n),
                   c->stick_speed, h, c->mass[i], v[i], force);
        }
    }
    vertex_contacts *spare = c->before;
    c->before = c->now;
    c->now = spare;
}
