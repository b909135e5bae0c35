/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Builds the surface of cloth and bodies, and positions the bodies. */
#include "barrier.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "mesh/mesh_parts.h"
#include "motion.h"
#include "shape.h"

/* Rejects scenes that the barrier does not support, with a message in error[200]. */
static int check_scene(const scene *s, char *error) {
    for (int n = 0; n < s->collider_count; n++) {
        const collider *k = &s->colliders[n];
        const char *wrong = k->from > 0 || k->until > 0 ? "is there all the time: no from, no until"
                            : k->kind == COLLIDER_PLANE && motion_rotates(k)
                                ? "does not turn where it is a plane: use a box"
                            : !(k->gap > 0) ? "has a gap above 0"
                                            : NULL;
        if (wrong) {
            snprintf(error, 200, "colliders.%d: with 'contact: barrier' a collider %s", n, wrong);
            return -1;
        }
    }
    return 0;
}

/* Appends a body's surface in the body's own axes; a plane is one point. */
static int add_body(barrier *b, int number) {
    assert(number >= 0 && number < b->scene->collider_count);
    static const double middle[3];
    const collider *k = &b->scene->colliders[number];
    mesh *all = &b->surface, body = {0};
    if (k->kind == COLLIDER_PLANE ? mesh_allocate(&body, 1, 0) != 0
                                  : solid_mesh(k, middle, 1, &body) != 0)
        return -1;
    const int vertices = all->vertex_count + body.vertex_count;
    const int triangles = all->triangle_count + body.triangle_count;
    double(*position)[3] = realloc(all->position, (size_t)vertices * sizeof *position);
    all->position = position ? position : all->position;
    int(*triangle)[3] = realloc(all->triangle, ((size_t)triangles + 1) * sizeof *triangle);
    all->triangle = triangle ? triangle : all->triangle;
    int *owner = realloc(b->collider, (size_t)vertices * sizeof *owner);
    b->collider = owner ? owner : b->collider;
    if (position && triangle && owner) {
        for (int i = 0; i < body.vertex_count; i++) {
            memcpy(position[all->vertex_count + i], body.position[i], sizeof *position);
            owner[all->vertex_count + i] = number;
        }
        for (int t = 0; t < body.triangle_count; t++)
            for (int p = 0; p < 3; p++)
                triangle[all->triangle_count + t][p] = all->vertex_count + body.triangle[t][p];
        all->vertex_count = vertices;
        all->triangle_count = triangles;
    }
    mesh_free(&body);
    return position && triangle && owner ? 0 : -1;
}

static int make_surface(barrier *b) {
    const size_t vertices = (size_t)b->cloth->vertex_count + 1;
    const size_t triangles = (size_t)b->cloth->triangle_count + 1;
    mesh *all = &b->surface;
    all->rest_in_space = 1;
    all->vertex_count = b->cloth->vertex_count;
    all->triangle_count = b->cloth->triangle_count;
    all->position = calloc(vertices, sizeof *all->position);
    all->triangle = calloc(triangles, sizeof *all->triangle);
    b->collider = calloc(vertices, sizeof *b->collider);
    if (!all->position || !all->triangle || !b->collider)
        return -1;
    memcpy(all->position, b->cloth->position, (vertices - 1) * sizeof *all->position);
    memcpy(all->triangle, b->cloth->triangle, (triangles - 1) * sizeof *all->triangle);
    for (size_t i = 0; i < vertices; i++)
        b->collider[i] = -1;
    for (int n = 0; n < b->scene->collider_count; n++)
        if (add_body(b, n) != 0)
            return -1;
    return 0;
}

/* Computes rest positions and connected components (union-find). */
static int know_cloth(barrier *b) {
    const mesh *m = b->cloth;
    const size_t n = (size_t)m->vertex_count + 1;
    b->rest = arrays_add(&b->own, n, sizeof *b->rest);
    b->component = arrays_add(&b->own, n, sizeof *b->component);
    if (b->own.failed)
        return -1;
    for (int i = 0; i < m->vertex_count; i++) {
        b->component[i] = i;
        for (int a = 0; a < 3; a++)
            b->rest[i][a] = m->rest_in_space ? m->position[i][a] : a < 2 ? m->material[i][a] : 0;
    }
    for (int t = 0; t < m->triangle_count; t++)
        for (int p = 1; p < 3; p++)
            b->component[forest_root(b->component, m->triangle[t][p])] =
                forest_root(b->component, m->triangle[t][0]);
    for (int i = 0; i < m->vertex_count; i++)
        b->component[i] = forest_root(b->component, i);
    return 0;
}

static double greatest_reach(const scene *s) {
    double most = s->self_collision.gap;
    for (int n = 0; n < s->collider_count; n++)
        most = fmax(most, s->colliders[n].gap);
    return most;
}

/* Sets the stiffness to m reach (reach / h^2 + g), with the mean mass m, the scene's step h and
 * gravity g. A vertex of mass m then comes to rest at about half its reach under its own weight,
 * and is stopped there within a step. Greater forces press it nearer; the logarithm keeps the
 * distance above 0. */
static void set_stiffness(barrier *b, double reach, const double *mass) {
    const scene *s = b->scene;
    double sum = 0;
    for (int i = 0; i < b->cloth->vertex_count; i++)
        sum += mass[i];
    b->stiffness = sum / fmax(1, b->cloth->vertex_count) * reach *
                   (reach / (s->time.step * s->time.step) + vector_length(s->surroundings.gravity));
    b->slip_speed = 1e-3;
}

int barrier_init(barrier *b, const mesh *cloth, const scene *s, const double *mass, char *error) {
    *b = (barrier){.scene = s, .cloth = cloth};
    const double reach = greatest_reach(s);
    if (check_scene(s, error) != 0)
        return -1;
    snprintf(error, 200, "out of memory");
    if (make_surface(b) != 0 || know_cloth(b) != 0 ||
        self_collision_init(&b->search, &b->surface, reach / 2, 0, s->time.step) != 0)
        return -1;
    b->search.bodies_from = cloth->triangle_count;
    b->margin = reach / 2;
    const size_t n = (size_t)b->surface.vertex_count + 1;
    b->driven = arrays_add(&b->own, n, 1);
    b->begin = arrays_add(&b->own, n, sizeof *b->begin);
    b->x = arrays_add(&b->own, n, sizeof *b->x);
    b->displacement = arrays_add(&b->own, n, sizeof *b->displacement);
    b->goal = arrays_add(&b->own, n, sizeof *b->goal);
    b->searched = arrays_add(&b->own, n, sizeof *b->searched);
    set_stiffness(b, reach, mass);
    return b->own.failed ? -1 : 0;
}

void barrier_free(barrier *b) {
    self_collision_free(&b->search);
    arrays_free(&b->own);
    free(b->surface.position);
    free(b->surface.triangle);
    free(b->collider);
    free(b->list.pair);
    free(b->list.contact);
    free(b->list.grip);
    free(b->list.element);
    *b = (barrier){0};
}

void barrier_place_bodies(const barrier *b, double time, double (*x)[3]) {
    body_pose pose = {0};
    int placed = -1;
    for (int i = b->cloth->vertex_count; i < b->surface.vertex_count; i++) {
        assert(b->collider[i] >= 0 && b->collider[i] < b->scene->collider_count);
        if (b->collider[i] != placed)
            motion_pose(&b->scene->colliders[b->collider[i]], time, &pose);
        placed = b->collider[i];
        for (int a = 0; a < 3; a++)
            x[i][a] = pose.origin[a] + vector_dot(pose.rotation[a], b->surface.position[i]);
    }
}
