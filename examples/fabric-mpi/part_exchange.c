/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Lays out the exchanges between ranks as PETSc's star forests. */
#include <stdlib.h>

#include "part_layout.h"
#include "petsc_check.h"
#include "solver/solver_parts.h"

/* Makes an exchange. This rank offers `roots` values and receives `count` values of other ranks:
 * leaf[k] is the local index of the value root[k]. */
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

/* Finds the numbers that vertices have in their owners' parts. */
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

/* Computes the order in which the blocks' sums are received. */
static void order_sums(block_sums *s, int ranks, const division *d) {
    int n = 0;
    s->count = d->count;
    s->order = part_memory((size_t)d->count, sizeof *s->order);
    s->came = part_memory((size_t)d->count, sizeof *s->came);
    s->sum = part_memory((size_t)d->count, sizeof *s->sum);
    s->counts = part_memory((size_t)ranks, sizeof *s->counts);
    s->starts = part_memory((size_t)ranks, sizeof *s->starts);
    for (int r = 0; r < ranks; r++) {
        s->starts[r] = n;
        for (int k = 0; k < d->count; k++)
            if (d->owner[k] == r)
                s->order[n++] = k;
        s->counts[r] = n - s->starts[r];
    }
}

enum { ANY = -1 };

/* Makes the exchange from owners to ghosts: only for ghosts in odd blocks (odd = 1), in even ones
 * (0), or in all (ANY). */
static void connect_ghosts(const part *p, const division *d, const int *place, int odd,
                           PetscSF *sf) {
    const int count = p->mesh.vertex_count;
    int *leaf = part_memory((size_t)count, sizeof *leaf);
    PetscSFNode *root = part_memory((size_t)count, sizeof *root);
    int n = 0;
    for (int i = 0; i < count; i++) {
        const int block = d->of[p->global[i]];
        if (d->owner[block] == p->rank || (odd != ANY && block % 2 != odd))
            continue;
        leaf[n] = i;
        root[n++] = (PetscSFNode){d->owner[block], place[i]};
    }
    connect(sf, count, n, leaf, root);
    free(leaf);
    free(root);
}

/* Marks the blocks with vertices that are ghosts of other ranks. */
static void mark_senders(part *p) {
    PetscInt ranks;
    const PetscInt *offset, *sent;
    int *is_sent = part_memory((size_t)p->mesh.vertex_count, sizeof *is_sent);
    CHECK(PetscSFGetLeafRanks(p->ghosts, &ranks, NULL, &offset, &sent));
    for (int n = 0; ranks > 0 && n < offset[ranks]; n++)
        is_sent[sent[n]] = 1;
    for (int b = 0; b < p->blocks; b++)
        for (int i = p->block[b].begin; i < p->block[b].end; i++)
            p->block[b].sends |= is_sent[i];
    free(is_sent);
}

void part_connect(part *p, const division *d) {
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
    connect_ghosts(p, d, place, ANY, &p->ghosts);
    if (p->ranks > 1)
        mark_senders(p);
    for (int odd = 0; odd < 2 && part_has_domains(&p->scene, p->bits); odd++)
        connect_ghosts(p, d, place, odd, &p->kind[odd]);
    order_sums(&p->sums, p->ranks, d);
    free(leaf);
    free(place);
    free(root);
}

void part_disconnect(part *p) {
    CHECK(PetscSFDestroy(&p->all));
    CHECK(PetscSFDestroy(&p->own));
    CHECK(PetscSFDestroy(&p->ghosts));
    for (int odd = 0; odd < 2; odd++)
        CHECK(PetscSFDestroy(&p->kind[odd]));
    free(p->sums.order);
    free(p->sums.came);
    free(p->sums.sum);
    free(p->sums.counts);
    free(p->sums.starts);
}

void part_receive(PetscSF sf, int size, const void *whole, void *local) {
    CHECK(PetscSFBcastBegin(sf, unit_of(size), whole, local, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(sf, unit_of(size), whole, local, MPI_REPLACE));
}

void part_receive_bytes(PetscSF sf, const unsigned char *whole, unsigned char *local) {
    CHECK(PetscSFBcastBegin(sf, MPI_UNSIGNED_CHAR, whole, local, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(sf, MPI_UNSIGNED_CHAR, whole, local, MPI_REPLACE));
}

void part_receive_ints(PetscSF sf, const int *whole, int *local) {
    CHECK(PetscSFBcastBegin(sf, MPI_INT, whole, local, MPI_REPLACE));
    CHECK(PetscSFBcastEnd(sf, MPI_INT, whole, local, MPI_REPLACE));
}

void part_return(const part *p, int size, const void *local, void *whole) {
    CHECK(PetscSFReduceBegin(p->own, unit_of(size), local, whole, MPI_REPLACE));
    CHECK(PetscSFReduceEnd(p->own, unit_of(size), local, whole, MPI_REPLACE));
}

void part_update_ghosts(const part *p, double (*value)[3]) {
    part_receive(p->ghosts, 3, value, value);
}

void part_update_kind_begin(const part *p, int odd, double (*value)[3]) {
    CHECK(PetscSFBcastBegin(p->kind[odd], unit_of(3), value, value, MPI_REPLACE));
}

void part_update_kind_end(const part *p, int odd, double (*value)[3]) {
    CHECK(PetscSFBcastEnd(p->kind[odd], unit_of(3), value, value, MPI_REPLACE));
}

static double sum_in_any_order(const part *p, const double *own) {
    const double mine = solver_sum(own, p->blocks);
    double sum;
    MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
}

double part_sum(const part *p, const double *own) {
    const block_sums *s = &p->sums;
    if (p->bits == BITS_ANY)
        return sum_in_any_order(p, own);
    MPI_Allgatherv(own, p->blocks, MPI_DOUBLE, s->came, s->counts, s->starts, MPI_DOUBLE,
                   MPI_COMM_WORLD);
    for (int n = 0; n < s->count; n++)
        s->sum[s->order[n]] = s->came[n];
    return solver_sum(s->sum, s->count);
}

double part_sum_terms(const part *p, const double *term) {
    double *all = p->rank == LEADER ? part_memory((size_t)p->vertices, sizeof *all) : NULL;
    double sum = 0;
    part_return(p, 1, term, all);
    for (int first = 0; all && first < p->vertices; first += SOLVER_CHUNK) {
        const int left = p->vertices - first;
        sum += solver_sum(all + first, left < SOLVER_CHUNK ? left : SOLVER_CHUNK);
    }
    free(all);
    MPI_Bcast(&sum, 1, MPI_DOUBLE, LEADER, MPI_COMM_WORLD);
    return sum;
}
