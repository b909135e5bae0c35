/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Who sends what to whom, by PETSc's star forests. */
#include <stdlib.h>

#include "part_layout.h"
#include "solver_parts.h"

#define CHECK(call) PetscCallAbort(PETSC_COMM_WORLD, call)

/* roots: how many the rank offers; leaf k, of `count`, is leaf[k] here and root[k] there. */
static void connect(PetscSF *sf, int roots, int count, int *leaf, PetscSFNode *root) {
    CHECK(PetscSFCreate(PETSC_COMM_WORLD, sf));
    CHECK(PetscSFSetGraph(*sf, roots, count, leaf, PETSC_COPY_VALUES, root, PETSC_COPY_VALUES));
    CHECK(PetscSFSetUp(*sf));
}

static MPI_Datatype unit_of(int size) {
    static MPI_Datatype units[16];
    if (size == 1)
        return MPI_DOUBLE;
    if (units[size] == 0) {
        MPI_Type_contiguous(size, MPI_DOUBLE, &units[size]);
        MPI_Type_commit(&units[size]);
    }
    return units[size];
}

/* The numbers that vertices have in their owners' parts. */
static void ask_places(const part *p, int *place) {
    int *at = part_memory((size_t)p->mesh.vertex_count, sizeof *at);
    int *all = part_memory((size_t)p->vertices, sizeof *all);
    for (int i = 0; i < p->mesh.vertex_count; i++)
        at[i] = i;
    CHECK(PetscSFReduceBegin(p->own, MPI_INT, at, all, MPI_REPLACE));
    CHECK(PetscSFReduceEnd(p->own, MPI_INT, at, all, MPI_REPLACE));
    CHECK(PetscSFBcastBegin(p->all, MPI_INT, all, place, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(p->all, MPI_INT, all, place, MPI_REPLACE));
    free(at);
    free(all);
}

/* In which order the blocks' sums come in. */
static void order_sums(part *p, const int *owner) {
    int n = 0;
    p->order = part_memory((size_t)p->chunks, sizeof *p->order);
    p->came = part_memory((size_t)p->chunks, sizeof *p->came);
    p->sums = part_memory((size_t)p->chunks, sizeof *p->sums);
    p->counts = part_memory((size_t)p->ranks, sizeof *p->counts);
    p->starts = part_memory((size_t)p->ranks, sizeof *p->starts);
    for (int r = 0; r < p->ranks; r++) {
        p->starts[r] = n;
        for (int k = 0; k < p->chunks; k++)
            if (owner[k] == r)
                p->order[n++] = k;
        p->counts[r] = n - p->starts[r];
    }
}

void part_connect(part *p, const int *owner) {
    const int count = p->mesh.vertex_count, offered = p->rank == LEADER ? p->vertices : 0;
    int *leaf = part_memory((size_t)count, sizeof *leaf);
    int *place = part_memory((size_t)count, sizeof *place);
    PetscSFNode *root = part_memory((size_t)count, sizeof *root);
    int n = 0;
    for (int i = 0; i < count; i++) {
        leaf[i] = i;
        root[i] = (PetscSFNode){LEADER, p->global[i]};
    }
    connect(&p->all, offered, count, leaf, root);
    for (int b = 0; b < p->blocks; b++)
        for (int i = p->block[b].begin; i < p->block[b].end; i++) {
            leaf[n] = i;
            root[n++] = (PetscSFNode){LEADER, p->global[i]};
        }
    connect(&p->own, offered, n, leaf, root);
    ask_places(p, place);
    n = 0;
    for (int i = 0; i < count; i++) {
        const int of = owner[p->global[i] / SOLVER_CHUNK];
        if (of == p->rank)
            continue;
        leaf[n] = i;
        root[n++] = (PetscSFNode){of, place[i]};
    }
    connect(&p->ghosts, count, n, leaf, root);
    order_sums(p, owner);
    free(leaf);
    free(place);
    free(root);
}

void part_disconnect(part *p) {
    CHECK(PetscSFDestroy(&p->all));
    CHECK(PetscSFDestroy(&p->own));
    CHECK(PetscSFDestroy(&p->ghosts));
    free(p->order);
    free(p->came);
    free(p->sums);
    free(p->counts);
    free(p->starts);
}

void part_receive(PetscSF sf, int size, const void *whole, void *local) {
    CHECK(PetscSFBcastBegin(sf, unit_of(size), whole, local, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(sf, unit_of(size), whole, local, MPI_REPLACE));
}

void part_receive_bytes(const part *p, const unsigned char *whole, unsigned char *local) {
    CHECK(PetscSFBcastBegin(p->own, MPI_UNSIGNED_CHAR, whole, local, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(p->own, MPI_UNSIGNED_CHAR, whole, local, MPI_REPLACE));
}

void part_receive_ints(const part *p, const int *whole, int *local) {
    CHECK(PetscSFBcastBegin(p->own, MPI_INT, whole, local, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(p->own, MPI_INT, whole, local, MPI_REPLACE));
}

void part_return(const part *p, int size, const void *local, void *whole) {
    CHECK(PetscSFReduceBegin(p->own, unit_of(size), local, whole, MPI_REPLACE));
    CHECK(PetscSFReduceEnd(p->own, unit_of(size), local, whole, MPI_REPLACE));
}

void part_update_ghosts(const part *p, double (*value)[3]) {
    part_receive(p->ghosts, 3, value, value);
}

double part_sum(const part *p, const double *own) {
    MPI_Allgatherv(own, p->blocks, MPI_DOUBLE, p->came, p->counts, p->starts, MPI_DOUBLE,
                   MPI_COMM_WORLD);
    for (int n = 0; n < p->chunks; n++)
        p->sums[p->order[n]] = p->came[n];
    return solver_sum(p->sums, p->chunks);
}
