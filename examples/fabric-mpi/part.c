/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Which vertices and elements a part has. */
#include "part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_parts.h"
#include "part_layout.h"
#include "solver_parts.h"

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

static int owns(const part *p, const int *owner, int vertex) {
    return owner[vertex / SOLVER_CHUNK] == p->rank;
}

/* Does the element touch a vertex that the rank owns? Then its vertices are marked. */
static int takes(const part *p, const int *owner, const int *vertex, int size, int *mark) {
    int touches = 0;
    for (int k = 0; k < size; k++)
        touches |= owns(p, owner, vertex[k]);
    for (int k = 0; touches && k < size; k++)
        mark[vertex[k]] = 1;
    return touches;
}

/* Marks the vertices of the part; counts them and its elements in the mesh. */
static void find(const part *p, const mesh *whole, const int *owner, int *mark, mesh *counted) {
    *counted = (mesh){0};
    for (int v = 0; v < whole->vertex_count; v++)
        mark[v] = owns(p, owner, v);
    for (int t = 0; t < whole->triangle_count; t++)
        counted->triangle_count += takes(p, owner, whole->triangle[t], 3, mark);
    for (int t = 0; t < whole->hinge_count; t++)
        counted->hinge_count += takes(p, owner, whole->hinge[t], 4, mark);
    for (int v = 0; v < whole->vertex_count; v++)
        counted->vertex_count += mark[v];
}

/* The part's vertices, and in local_of [whole vertices] their numbers there. */
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

static void take_elements(part *p, const mesh *whole, const int *owner, const int *local_of,
                          int *mark) {
    mesh *m = &p->mesh;
    int triangles = 0, hinges = 0;
    for (int t = 0; t < whole->triangle_count; t++) {
        if (!takes(p, owner, whole->triangle[t], 3, mark))
            continue;
        for (int k = 0; k < 3; k++)
            m->triangle[triangles][k] = local_of[whole->triangle[t][k]];
        triangles++;
    }
    for (int t = 0; t < whole->hinge_count; t++) {
        if (!takes(p, owner, whole->hinge[t], 4, mark))
            continue;
        for (int k = 0; k < 4; k++)
            m->hinge[hinges][k] = local_of[whole->hinge[t][k]];
        p->hinge[hinges++] = t;
    }
}

static void take_blocks(part *p, const int *owner, const int *local_of) {
    p->block = part_memory((size_t)p->chunks, sizeof *p->block);
    p->blocks = 0;
    for (int k = 0; k < p->chunks; k++) {
        const int first = k * SOLVER_CHUNK;
        const int left = p->vertices - first;
        const int length = left < SOLVER_CHUNK ? left : SOLVER_CHUNK;
        if (owner[k] == p->rank)
            p->block[p->blocks++] = (own_block){k, local_of[first], local_of[first] + length};
    }
}

void part_take(part *p, const mesh *whole, const int *owner) {
    const size_t vertices = (size_t)whole->vertex_count;
    int *mark = part_memory(vertices, sizeof *mark);
    int *local_of = part_memory(vertices, sizeof *local_of);
    mesh counted;
    find(p, whole, owner, mark, &counted);
    if (mesh_allocate(&p->mesh, counted.vertex_count, counted.triangle_count) != 0)
        part_give_up("out of memory");
    p->mesh.hinge_count = counted.hinge_count;
    p->mesh.hinge = part_memory((size_t)counted.hinge_count, sizeof *p->mesh.hinge);
    p->mesh.rest_in_space = whole->rest_in_space;
    p->mesh.bent_at_rest = whole->bent_at_rest;
    p->global = part_memory((size_t)counted.vertex_count, sizeof *p->global);
    p->hinge = part_memory((size_t)counted.hinge_count, sizeof *p->hinge);
    take_vertices(p, whole, mark, local_of);
    take_elements(p, whole, owner, local_of, mark);
    take_blocks(p, owner, local_of);
    free(mark);
    free(local_of);
}

/* The leader's mesh, at all ranks. */
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

/* What acts within the cloth and on all of it. Pins, bodies, contact and the monitor are the
 * leader's. */
static void spread_scene(scene *s, const scene *of) {
    if (of)
        *s = *of;
    MPI_Bcast(s, (int)sizeof *s, MPI_BYTE, LEADER, MPI_COMM_WORLD);
    s->sheet = NULL;
    s->pin_count = s->collider_count = 0;
    s->pins = NULL;
    s->colliders = NULL;
    s->self_gap = s->sleep = 0;
    s->integrator = INTEGRATOR_LINEAR_EULER;
    s->limits.off = 1;
}

void part_make(part *p, const mesh *whole, const scene *of) {
    char error[256];
    mesh all;
    *p = (part){0};
    MPI_Comm_rank(MPI_COMM_WORLD, &p->rank);
    MPI_Comm_size(MPI_COMM_WORLD, &p->ranks);
    spread_scene(&p->scene, of);
    spread_mesh(&all, whole);
    p->vertices = all.vertex_count;
    p->chunks = (all.vertex_count + SOLVER_CHUNK - 1) / SOLVER_CHUNK;
    int *owner = part_memory((size_t)p->chunks, sizeof *owner);
    part_share_blocks(p, &all, owner);
    part_take(p, &all, owner);
    part_connect(p, owner);
    free(owner);
    if (!whole)
        mesh_free(&all);
    p->sim = __real_simulation_new(&p->mesh, &p->scene, error);
    if (!p->sim)
        part_give_up(error);
    part_view(p);
}

void part_free(part *p) {
    __real_simulation_free(p->sim);
    mesh_free(&p->mesh);
    free(p->global);
    free(p->hinge);
    free(p->block);
    part_disconnect(p);
    *p = (part){0};
}
