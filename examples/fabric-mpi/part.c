/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Determines the vertices and elements of a part. */
#include "part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/mesh_parts.h"
#include "part_layout.h"
#include "part_picture.h"
#include "solution_petsc.h"
#include "solver/solver_domains_parts.h"
#include "solver/solver_parts.h"

void part_give_up(const char *why) {
    fprintf(stderr, "fabric-mpi: %s\n", why);
    MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    abort();
}

void *part_memory(size_t count, size_t size) {
    void *memory = calloc(count + 1, size);
    if (!memory)
        part_give_up("out of memory");
    return memory;
}

static int owns(const part *p, const division *d, int vertex) {
    return d->owner[d->of[vertex]] == p->rank;
}

/* Does the element have a vertex that the rank owns? If so, marks its vertices. */
static int takes(const part *p, const division *d, const int *vertex, int size, int *mark) {
    int touches = 0;
    for (int k = 0; k < size; k++)
        touches |= owns(p, d, vertex[k]);
    for (int k = 0; touches && k < size; k++)
        mark[vertex[k]] = 1;
    return touches;
}

/* Marks the vertices of the part. `counted` receives the numbers of its vertices and elements. */
static void find(const part *p, const mesh *whole, const division *d, int *mark, mesh *counted) {
    *counted = (mesh){0};
    for (int v = 0; v < whole->vertex_count; v++)
        mark[v] = owns(p, d, v);
    for (int t = 0; t < whole->triangle_count; t++)
        counted->triangle_count += takes(p, d, whole->triangle[t], 3, mark);
    for (int t = 0; t < whole->hinge_count; t++)
        counted->hinge_count += takes(p, d, whole->hinge[t], 4, mark);
    for (int v = 0; v < whole->vertex_count; v++)
        counted->vertex_count += mark[v];
}

/* Lists the part's vertices; local_of [whole vertices] receives their numbers in the part. */
static void take_vertices(part *p, const mesh *whole, const int *mark, int *local_of) {
    int n = 0;
    for (int v = 0; v < whole->vertex_count; v++) {
        if (!mark[v])
            continue;
        p->global[n] = v;
        memcpy(p->mesh.position[n], whole->position[v], sizeof *whole->position);
        memcpy(p->mesh.material[n], whole->material[v], sizeof *whole->material);
        local_of[v] = n++;
    }
}

static void take_elements(part *p, const mesh *whole, const division *d, const int *local_of,
                          int *mark) {
    mesh *m = &p->mesh;
    int triangles = 0, hinges = 0;
    for (int t = 0; t < whole->triangle_count; t++) {
        if (!takes(p, d, whole->triangle[t], 3, mark))
            continue;
        for (int k = 0; k < 3; k++)
            m->triangle[triangles][k] = local_of[whole->triangle[t][k]];
        triangles++;
    }
    for (int t = 0; t < whole->hinge_count; t++) {
        if (!takes(p, d, whole->hinge[t], 4, mark))
            continue;
        for (int k = 0; k < 4; k++)
            m->hinge[hinges][k] = local_of[whole->hinge[t][k]];
        p->hinge[hinges++] = t;
    }
}

static void take_blocks(part *p, const division *d, const int *local_of) {
    p->block = part_memory((size_t)d->count, sizeof *p->block);
    p->blocks = 0;
    for (int k = 0; k < d->count; k++) {
        const int first = d->first[k], length = d->first[k + 1] - first;
        if (d->owner[k] == p->rank)
            p->block[p->blocks++] = (own_block){k, local_of[first], local_of[first] + length, 0};
    }
}

void part_take(part *p, const mesh *whole, const division *d) {
    const size_t vertices = (size_t)whole->vertex_count;
    int *mark = part_memory(vertices, sizeof *mark);
    int *local_of = part_memory(vertices, sizeof *local_of);
    mesh counted;
    find(p, whole, d, mark, &counted);
    if (mesh_allocate(&p->mesh, counted.vertex_count, counted.triangle_count) != 0)
        part_give_up("out of memory");
    p->mesh.hinge_count = counted.hinge_count;
    p->mesh.hinge = part_memory((size_t)counted.hinge_count, sizeof *p->mesh.hinge);
    p->mesh.rest_in_space = whole->rest_in_space;
    p->mesh.bent_at_rest = whole->bent_at_rest;
    p->global = part_memory((size_t)counted.vertex_count, sizeof *p->global);
    p->hinge = part_memory((size_t)counted.hinge_count, sizeof *p->hinge);
    take_vertices(p, whole, mark, local_of);
    take_elements(p, whole, d, local_of, mark);
    take_blocks(p, d, local_of);
    free(mark);
    free(local_of);
}

/* Broadcasts the leader's mesh. */
static void spread_mesh(mesh *m, const mesh *whole) {
    if (whole)
        *m = *whole;
    MPI_Bcast(m, (int)sizeof *m, MPI_BYTE, LEADER, MPI_COMM_WORLD);
    if (!whole) {
        const int flags[2] = {m->rest_in_space, m->bent_at_rest}, hinges = m->hinge_count;
        if (mesh_allocate(m, m->vertex_count, m->triangle_count) != 0)
            part_give_up("out of memory");
        m->rest_in_space = flags[0];
        m->bent_at_rest = flags[1];
        m->hinge_count = hinges;
        m->hinge = part_memory((size_t)hinges, sizeof *m->hinge);
    }
    MPI_Bcast(m->position, 3 * m->vertex_count, MPI_DOUBLE, LEADER, MPI_COMM_WORLD);
    MPI_Bcast(m->material, 2 * m->vertex_count, MPI_DOUBLE, LEADER, MPI_COMM_WORLD);
    MPI_Bcast(m->triangle, 3 * m->triangle_count, MPI_INT, LEADER, MPI_COMM_WORLD);
    MPI_Bcast(m->hinge, 4 * m->hinge_count, MPI_INT, LEADER, MPI_COMM_WORLD);
}

/* Broadcasts the parts of the scene that act on the whole cloth: material and surroundings. Pins,
 * bodies, contact and the monitor stay with the leader. */
static void spread_scene(scene *s, const scene *of) {
    if (of)
        *s = *of;
    MPI_Bcast(s, (int)sizeof *s, MPI_BYTE, LEADER, MPI_COMM_WORLD);
    s->mesh.sheet = NULL;
    s->pin_count = s->collider_count = 0;
    s->pins = NULL;
    s->colliders = NULL;
    s->self_collision.gap = s->solution.sleep = 0;
    s->time.integrator = INTEGRATOR_LINEAR_EULER;
    s->monitor.off = 1;
}

int part_has_domains(const scene *s, bits_order bits) {
    return bits == BITS_SERIAL && s->solution.preconditioner == PRECONDITIONER_GAUSS_SEIDEL;
}

int part_block_count(const scene *s, bits_order bits, int vertices) {
    return part_has_domains(s, bits) ? domain_count(vertices)
                                     : (vertices + SOLVER_CHUNK - 1) / SOLVER_CHUNK;
}

static void divide(const part *p, const mesh *whole, division *d) {
    const int domains = part_has_domains(&p->scene, p->bits);
    const int vertices = whole->vertex_count;
    d->count = part_block_count(&p->scene, p->bits, vertices);
    d->first = part_memory((size_t)d->count + 1, sizeof *d->first);
    d->of = part_memory((size_t)vertices, sizeof *d->of);
    d->owner = part_memory((size_t)d->count, sizeof *d->owner);
    for (int k = 0; k < d->count; k++)
        d->first[k] = domains ? domain_start(vertices, k) : k * SOLVER_CHUNK;
    d->first[d->count] = vertices;
    for (int k = 0; k < d->count; k++)
        for (int v = d->first[k]; v < d->first[k + 1]; v++)
            d->of[v] = k;
    part_share_blocks(p, whole, d);
}

/* Makes the part's solver with the domains of the whole cloth. A domain that another rank owns
 * contains at most ghosts. */
static void make_domains(part *p, const division *d) {
    int *start = part_memory((size_t)d->count + 1, sizeof *start);
    for (int k = 0, i = 0; k <= d->count; k++) {
        while (i < p->mesh.vertex_count && p->global[i] < d->first[k])
            i++;
        start[k] = i;
    }
    p->domains = domain_solver_divided(&p->sim->system.A, d->count, start);
    free(start);
    if (!p->domains)
        part_give_up("out of memory");
    MPI_Allreduce(MPI_IN_PLACE, &p->domains->has_between, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
}

void part_make(part *p, bits_order bits, const mesh *whole, const scene *of) {
    division d;
    char error[256];
    mesh all;
    *p = (part){.bits = bits};
    MPI_Comm_rank(MPI_COMM_WORLD, &p->rank);
    MPI_Comm_size(MPI_COMM_WORLD, &p->ranks);
    spread_scene(&p->scene, of);
    spread_mesh(&all, whole);
    p->vertices = all.vertex_count;
    divide(p, &all, &d);
    part_take(p, &all, &d);
    part_connect(p, &d);
    p->picture = part_picture_new(p, &all, &d);
    if (!whole)
        mesh_free(&all);
    p->sim = __real_simulation_new(&p->mesh, &p->scene, error);
    if (!p->sim)
        part_give_up(error);
    p->diagonal = part_memory((size_t)p->mesh.vertex_count, sizeof *p->diagonal);
    if (part_has_domains(&p->scene, bits))
        make_domains(p, &d);
    if (bits == BITS_ANY)
        p->petsc = petsc_solver_new(p);
    free(d.first);
    free(d.of);
    free(d.owner);
    part_view(p);
}

void part_free(part *p) {
    domain_solver_free(p->domains);
    petsc_solver_free(p->petsc);
    part_picture_free(p->picture);
    __real_simulation_free(p->sim);
    mesh_free(&p->mesh);
    free(p->diagonal);
    free(p->global);
    free(p->hinge);
    free(p->block);
    part_disconnect(p);
    *p = (part){0};
}
